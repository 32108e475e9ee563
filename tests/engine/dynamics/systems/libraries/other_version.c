/* A system for a later version of the interface. */
#include "lober/lober_system.h"

static const lober_system description = {
    LOBER_SYSTEM_ABI + 1, LOBER_MAP, "later", "", 0, NULL, {0}, {0}, NULL, NULL, 0, NULL, 0, NULL, NULL, {0}};

const lober_system* lober_system_describe(void) {
  return &description;
}

/* A map without its inverse. */
#include "lober/lober_system.h"

static int forward(const double* parameters, const double z[2], double image[2]) {
  image[0] = z[1] + *parameters;
  image[1] = -z[0];
  return 0;
}

static const lober_map map = {forward, NULL, NULL, NULL};
static const lober_parameter shift = {"shift", 0, "of x"};
static const lober_system description = {
    LOBER_SYSTEM_ABI, LOBER_MAP, "half", "", 1, &shift, {0}, {0}, &map, NULL, 0, NULL, 0, NULL, NULL, {0}};

const lober_system* lober_system_describe(void) {
  return &description;
}

#include "lober/base/version.hpp"

#define LOBER_TEXT_OF(number) #number
#define LOBER_TEXT(number) LOBER_TEXT_OF(number)

namespace lober {

const char* version() noexcept {
  return LOBER_TEXT(LOBER_VERSION_MAJOR) "." LOBER_TEXT(LOBER_VERSION_MINOR) "." LOBER_TEXT(LOBER_VERSION_PATCH);
}

}  // namespace lober

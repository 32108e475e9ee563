#include "engine/batch/operations/provenance.hpp"

#include <unistd.h>

#include <array>

#include "lober_build.hpp"  // written by engine/batch/build_info.cmake at every build

namespace lober::detail {

std::string_view engine_version() {
  return LOBER_BUILD_VERSION;
}

Provenance provenance() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return {LOBER_BUILD_VERSION, LOBER_BUILD_COMMIT, LOBER_BUILD_COMPILER, LOBER_BUILD_FLAGS, host.data()};
}

}  // namespace lober::detail

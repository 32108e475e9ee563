// The program that computes, and the machine.
#pragma once

#include <string>
#include <string_view>

namespace lober::detail {

struct Provenance {
  std::string version, commit, compiler, flags, host;
};
[[nodiscard]] Provenance provenance();

/// The version in the keys of results, not the commit.
[[nodiscard]] std::string_view engine_version();

}  // namespace lober::detail

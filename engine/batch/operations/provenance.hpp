// Which program computes, and where.
#pragma once

#include <string>
#include <string_view>

namespace lober::detail {

struct Provenance {
  std::string version, commit, compiler, flags, host;
};
[[nodiscard]] Provenance provenance();

/// What goes into the keys of results: the version, not the commit.
[[nodiscard]] std::string_view engine_version();

}  // namespace lober::detail

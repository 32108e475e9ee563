// The program as it was built, and the libraries that it runs with.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

struct LibraryVersion {
  std::string name, version;
  std::string built_with = {};  ///< version of the headers, where it differs from that of the library that runs
};

/// Libraries of others: first those that are linked, then those of headers only.
[[nodiscard]] std::vector<LibraryVersion> library_versions();
/// "TBB 2021.8, SQLite 3.40.1, ...".
[[nodiscard]] std::string library_text();
/// "commit 0123456789ab, GNU 12.2.0, -O3 -DNDEBUG"; without the commit where the sources were not those of a
/// repository.
[[nodiscard]] std::string build_text();

}  // namespace lober::cli

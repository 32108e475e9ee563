// The hash of a file that is not needed otherwise.
#pragma once

#include <string>

namespace lober::detail {

/// SHA-256 of the bytes of a regular file, hexadecimal, as `sha256` of files.hpp gives it for the whole: a mebibyte is
/// in memory at a time. Throws DataError "path: reason", also for a file that changes meanwhile.
[[nodiscard]] std::string sha256_of_file(const std::string& path);

}  // namespace lober::detail

// Raw numbers bear no mark: whether bytes read as pairs of float64 can be meant so.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace lober::detail {

/// Why the bytes do not look like native float64 pairs, with the remedy, as the end of a message; empty when they do.
/// They do not when, as float32 pairs, they make a smooth curve or are all of ordinary size (the low halves of float64
/// are noise or zero); when most coordinates spread over more than 100 decades, or lie beyond 1e+-150, as bytes of
/// another type or order do. Looks at the first 4096 points. O(1).
[[nodiscard]] std::string implausible_raw(const std::string& path, std::span<const std::byte> bytes);

/// Whether the name ends in .f64, which says that the file is raw float64 pairs whatever it looks like.
[[nodiscard]] bool insists_on_raw(const std::string& path);

}  // namespace lober::detail

// The numbers and notes that writers add to their curves.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lober/curve/formats.hpp"

namespace lober::detail {

/// "key: value" lines.
[[nodiscard]] std::string provenance_text(const WriteOptions& options);
/// The same as comments: "# key: value".
[[nodiscard]] std::string comment_lines(const WriteOptions& options);

/// The names of numbers that zones have, in the order in which they appear first.
[[nodiscard]] std::vector<std::string> names_of_numbers(std::span<const Zone> zones);
/// One of these numbers for each zone; NaN for a zone without it.
[[nodiscard]] std::vector<double> numbers_called(std::string_view name, std::span<const Zone> zones);

}  // namespace lober::detail

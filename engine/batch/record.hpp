// What an operation finds about one job: named numbers, and lists of numbers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lober {

/// One number of a result. Counts are kept as doubles too: they are exact below 2^53.
struct Column {
  enum class Kind : std::uint8_t { real, count };
  std::string name;
  Kind kind = Kind::real;
};

/// The numbers in the order of the operation's columns, the lists in the order of its lists.
struct Record {
  std::vector<double> values;
  std::vector<std::vector<double>> lists;
  friend bool operator==(const Record&, const Record&) = default;
};

/// As bytes (native order) and back, bit for bit. `decode` throws DataError for bytes that are no record.
[[nodiscard]] std::string encode(const Record& record);
[[nodiscard]] Record decode(std::string_view bytes);

}  // namespace lober

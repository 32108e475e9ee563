// A table that reads well on a terminal and as Markdown.
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace lober::bench {

class Table {
 public:
  explicit Table(std::vector<std::string> header) : rows_{std::move(header)} {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  /// Columns are aligned: the first one to the left, all others to the right.
  friend std::ostream& operator<<(std::ostream& stream, const Table& table);

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// `value` with three significant digits, without exponent where that is readable.
[[nodiscard]] std::string digits3(double value);
/// The same of 1000 * seconds.
[[nodiscard]] std::string milliseconds(double seconds);
/// An error such as 3e-16; "0" when there is none.
[[nodiscard]] std::string one_digit(double error);

}  // namespace lober::bench

#include "bench/harness/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lober::bench {
namespace {

std::string formatted(const char* format, int precision, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, precision, value);
  return text;
}

}  // namespace

std::ostream& operator<<(std::ostream& stream, const Table& table) {
  std::vector<std::size_t> widths(table.rows_.front().size(), 4);
  for (const auto& row : table.rows_) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  for (std::size_t line = 0; line < table.rows_.size(); ++line) {
    const auto& row = table.rows_[line];
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string padding(widths[k] - row[k].size(), ' ');
      stream << "| " << (k == 0 ? row[k] + padding : padding + row[k]) << ' ';
    }
    stream << "|\n";
    if (line != 0) continue;
    for (std::size_t k = 0; k < row.size(); ++k) {
      stream << (k == 0 ? "|:" : "|-") << std::string(widths[k], '-') << (k == 0 ? "-" : ":");
    }
    stream << "|\n";
  }
  return stream << '\n';
}

std::string digits3(double value) {
  if (!std::isfinite(value)) return "-";
  if (value == 0) return "0";
  const int places = 2 - static_cast<int>(std::floor(std::log10(std::fabs(value))));
  return places > 6 ? formatted("%.*e", 1, value) : formatted("%.*f", std::max(places, 0), value);
}

std::string milliseconds(double seconds) {
  return digits3(seconds * 1000);
}

std::string one_digit(double error) {
  return error == 0 ? "0" : formatted("%.*e", 0, error);
}

}  // namespace lober::bench

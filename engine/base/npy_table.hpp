// Structured arrays of NumPy: a row of fields for each thing.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace lober::detail {

/// The head of a structured array of one axis, an NPY file whose rows follow it: its fields by name and type, as
/// {"x", "<f8"}, in their order in each row.
[[nodiscard]] inline std::string npy_table_head(std::span<const std::pair<std::string, std::string>> fields,
                                                std::size_t rows) {
  constexpr std::size_t before = 12;  // magic string, version 2.0, length of the header in four bytes
  constexpr std::size_t alignment = 64;
  std::string header = "{'descr': [";
  for (const auto& [name, type] : fields) header.append("('").append(name).append("', '").append(type).append("'), ");
  header += "], 'fortran_order': False, 'shape': (" + std::to_string(rows) + ",), }";
  header.append(alignment - 1 - (before + header.size()) % alignment, ' ');
  header += '\n';
  std::string head("\x93NUMPY\x02\x00", 8);
  for (int shift = 0; shift < 32; shift += 8) head += static_cast<char>(header.size() >> shift & 0xFF);
  return head + header;
}

}  // namespace lober::detail

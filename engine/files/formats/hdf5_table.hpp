// Tables of numbers and texts as HDF5, which h5py, pandas, xarray, MATLAB and Julia read.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lober::detail {

/// A column: float64 numbers where `width` is 0, else texts of that many bytes, filled up with zeros.
struct TableColumn {
  std::string name;
  std::size_t width = 0;
  std::string bytes = {};  ///< the elements, one behind the other, in this machine's byte order

  void add(double number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); }
  void add(std::string text) {
    text.resize(width, '\0');
    bytes += text;
  }
};

/// The bytes of a file with a dataset of one axis for each column, and attributes of its root that are texts. The same
/// columns give the same bytes. Throws DataError where the HDF5 library is not there.
[[nodiscard]] std::string hdf5_table(std::span<const TableColumn> columns,
                                     std::span<const std::pair<std::string, std::string>> attributes);

}  // namespace lober::detail

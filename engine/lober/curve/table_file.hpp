// Tables of numbers and texts as HDF5, which h5py, pandas, xarray, MATLAB and Julia read.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lober/base/export.hpp"

namespace lober {

/// A column of a table: float64 numbers where `width` is 0, else texts of that many bytes, filled up with zeros.
struct TableColumn {
  std::string name;        ///< name of the dataset
  std::size_t width = 0;   ///< bytes of a text; 0 for numbers
  std::string bytes = {};  ///< the elements, one behind the other, in this machine's byte order

  /// Adds a number to a column of numbers.
  void add(double number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); }
  /// Adds a text to a column of texts; what is longer than `width` is cut off.
  void add(std::string text) {
    text.resize(width, '\0');
    bytes += text;
  }
};

/// The bytes of an HDF5 file with a dataset of one axis for each column, and attributes of its root that are texts. The
/// same columns give the same bytes. Throws DataError where the HDF5 library is not there.
[[nodiscard]] LOBER_API std::string hdf5_table(std::span<const TableColumn> columns,
                                               std::span<const std::pair<std::string, std::string>> attributes);

}  // namespace lober

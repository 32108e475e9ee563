// Curves in files of named arrays: NPZ, MAT, HDF5, NetCDF.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lober/base/buffer.hpp"
#include "lober/curve/files.hpp"

namespace lober::detail {

/// An array of numbers in a file.
struct ArrayInfo {
  std::string name;
  std::vector<std::size_t> shape;      ///< empty for a single number
  std::vector<std::string> axes = {};  ///< names of the axes where the format has them: those of a grid differ

  /// Throws nothing; the largest std::size_t where the product does not fit.
  [[nodiscard]] std::size_t size() const;
};

/// A file of named arrays, as its library shows it.
class ArrayFile {
 public:
  virtual ~ArrayFile() = default;
  ArrayFile() = default;
  ArrayFile(const ArrayFile&) = delete;
  ArrayFile& operator=(const ArrayFile&) = delete;

  /// Arrays of real numbers, in the order of the file.
  [[nodiscard]] virtual const std::vector<ArrayInfo>& arrays() const = 0;
  /// The numbers of arrays()[index], the last axis fastest, NaN where the file says that none is there. Throws
  /// DataError.
  [[nodiscard]] virtual Buffer<double> numbers(std::size_t index) = 0;
  /// Texts of an array that is not among `arrays`, such as the titles of curves; empty where there is none.
  [[nodiscard]] virtual std::vector<std::string> texts(std::string_view /*name*/) { return {}; }
  /// Whether a table's columns are its curves, as MATLAB has them, not its rows.
  [[nodiscard]] virtual bool curves_are_columns() const { return false; }
};

/// Reads the curves that `choice` names into zones of `file`.
///
/// A choice is "X,Y", two arrays of one shape, or "XY", one array of N x 2 or 2 x N numbers. Behind it may stand
/// "by=ID", an array that says which curve each point belongs to, or "offsets=O", an array that says where each curve
/// begins and the last one ends. Names are whole (HDF5: "/group/x"), or the last parts of only one. Without a choice:
/// points and offsets, as lober writes them; or the only array of N x 2 or 2 x N numbers; or arrays called x and y, or
/// longitude and latitude. Arrays of two axes are one curve a row (curves_are_columns: a column), without the NaN at
/// its end. Rows of NaN part curves in an array of one axis. Throws DataError "path: what is wrong", which names the
/// arrays that are there.
void read_arrays(ArrayFile& arrays, std::string_view choice, CurveFile& file);

/// The numbers of an array that lies in memory with its first axis fastest, with the last one fastest.
[[nodiscard]] Buffer<double> last_axis_fastest(const Buffer<double>& numbers, const std::vector<std::size_t>& shape);

/// The conventions of NetCDF: numbers equal to one of `none`, and those that were never written, become NaN, then all
/// are scaled and shifted.
void apply_conventions(Buffer<double>& numbers, const std::array<std::optional<double>, 2>& none,
                       std::optional<double> scale, std::optional<double> shift);

/// Whether `size` bytes may come out of `stored` ones that were compressed by deflate, which gives at most 1032 for
/// one: a file of a few bytes can promise any size.
[[nodiscard]] bool can_hold(std::size_t stored, std::size_t size);

/// Throws DataError "path: ..." for an array that does not fit into a quarter of the machine's memory.
void require_fitting_memory(const std::string& path, const ArrayInfo& array);

}  // namespace lober::detail

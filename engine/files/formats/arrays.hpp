// Curves in files of named arrays: NPZ, MAT, HDF5, NetCDF.
#pragma once

#include <cstddef>
#include <cstdint>
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
  /// The role of the array in curves of different lengths, one behind the other, as CF has them: numbers of points of
  /// each curve, or the curve of each point.
  enum class Role : std::uint8_t { other, counts, instances };
  Role role = Role::other;
  bool is_complex = false;               ///< `numbers` are real and imaginary parts, one behind the other
  bool is_link = false;                  ///< another name of an array, perhaps
  std::vector<std::size_t> pieces = {};  ///< lengths of the curves of a list of arrays, which are one behind the other

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

  /// Arrays of numbers, in the order of the file.
  [[nodiscard]] virtual const std::vector<ArrayInfo>& arrays() const = 0;
  /// The numbers of arrays()[index], the last axis fastest, NaN where the file says that none is there; twice as many
  /// where they are complex. Throws DataError.
  [[nodiscard]] virtual Buffer<double> numbers(std::size_t index) = 0;
  /// Texts of an array that is not among `arrays`, such as the titles of curves; empty where there is none.
  [[nodiscard]] virtual std::vector<std::string> texts(std::string_view /*name*/) { return {}; }
  /// The name of the array of numbers or texts that names curves of different lengths; empty where there is none.
  [[nodiscard]] virtual std::string names_of_curves() const { return {}; }
  /// Whether a table's columns are its curves, as MATLAB has them, not its rows.
  [[nodiscard]] virtual bool curves_are_columns() const { return false; }
};

/// Reads the curves that `choice` names into zones of `file`.
///
/// A choice is "X,Y", two arrays of one shape, or "XY", one array of N x 2 or 2 x N numbers. Behind it may stand
/// "by=ID", an array that says which curve each point belongs to, "offsets=O", an array that says where each curve
/// begins and the last one ends, or "counts=N", the number of points of each. Names are whole (HDF5: "/group/x"), or
/// the last parts of only one, in the case of the file or else in any, in quotes where they have commas. Without a
/// choice: points and offsets, as lober writes them; or the only array of N x 2 or 2 x N numbers; or arrays called x
/// and y, or longitude and latitude. Arrays of two axes are one curve a row (curves_are_columns: a column), without the
/// points where a coordinate is NaN. An array of one axis is parted by an array with the role of counts or of
/// instances, or one called rowsize, that fits it; else by rows of NaN. Curves without a point are none, and the others
/// keep their numbers. Throws DataError "path: what is wrong", which names the arrays that are there.
void read_arrays(ArrayFile& arrays, std::string_view choice, CurveFile& file);

/// The numbers of an array that lies in memory with its first axis fastest, with the last one fastest.
[[nodiscard]] Buffer<double> last_axis_fastest(const Buffer<double>& numbers, const std::vector<std::size_t>& shape);

/// Real and imaginary parts, one behind the other.
[[nodiscard]] Buffer<double> interleaved(const Buffer<double>& real, const Buffer<double>& imaginary);

/// The arrays of a list, such as a cell array of MATLAB's, as one array in pieces: vectors, points (N x 2 or 2 x N), or
/// complex vectors. Nothing where they are something else, or several of these.
[[nodiscard]] std::optional<ArrayInfo> array_of_list(const std::string& name, const std::vector<ArrayInfo>& elements);

/// Adds the numbers of an element of such an array, points as N x 2.
void append_element(Buffer<double>& all, const Buffer<double>& numbers, const ArrayInfo& element,
                    const ArrayInfo& list);

/// Whether `size` bytes may come out of `stored` ones that were compressed by deflate, which gives at most 1032 for
/// one: a file of a few bytes can promise any size.
[[nodiscard]] bool can_hold(std::size_t stored, std::size_t size);

/// Throws DataError "path: ..." for an array that does not fit into a quarter of the machine's memory.
void require_fitting_memory(const std::string& path, const ArrayInfo& array);

}  // namespace lober::detail

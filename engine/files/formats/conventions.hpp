// The conventions by which attributes say what the numbers of a NetCDF variable mean: those of the NetCDF Users Guide
// and of CF.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/formats/arrays.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// The type of the stored numbers.
struct StoredType {
  std::size_t size = 8;  ///< bytes
  bool is_float = true;
  bool is_signed = true;
};

/// The attributes of a variable that are heeded.
struct Conventions {
  std::vector<double> none;               ///< _FillValue and missing_value
  std::optional<double> lowest, highest;  ///< valid_min and valid_max, or valid_range
  std::optional<double> scale, shift;     ///< scale_factor and add_offset
  bool has_fill = false;                  ///< whether _FillValue is there
  bool is_unsigned = false;               ///< _Unsigned = "true": signed integers stand for unsigned ones
  std::string samples;                    ///< sample_dimension: the variable counts the points of each curve
  std::string instances;                  ///< instance_dimension: the variable numbers the curve of each point
  bool is_name = false;                   ///< cf_role = "trajectory_id" and its like: the variable names curves
};

/// Takes note of an attribute; of others nothing.
void heed(Conventions& conventions, std::string_view name, std::span<const double> values);
void heed(Conventions& conventions, std::string_view name, std::string_view text);

/// The role of such a variable.
[[nodiscard]] ArrayInfo::Role role_by(const Conventions& conventions);

/// Turns stored numbers into those that they stand for: NaN where they equal a number that stands for none or lie
/// outside of the valid range; where no _FillValue is given and `is_netcdf`, also where they were never written. Those
/// of one byte have no such default. Then all are scaled and shifted.
void apply_conventions(Buffer<double>& numbers, const Conventions& conventions, StoredType type, bool is_netcdf);

}  // namespace lober::detail

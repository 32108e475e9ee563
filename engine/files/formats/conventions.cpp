#include "engine/files/formats/conventions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lober::detail {
namespace {

// The library's defaults for numbers that were never written: NC_FILL_SHORT and so on.
std::optional<double> default_fill(StoredType type) {
  if (type.is_float) return 9.969209968386869e+36;
  const double smallest = -std::ldexp(1.0, static_cast<int>(8 * type.size) - 1);
  const double largest = std::ldexp(1.0, static_cast<int>(8 * type.size)) - 1;
  switch (type.size) {
    case 2:
    case 4:
      return type.is_signed ? smallest + 1 : largest;
    case 8:
      return type.is_signed ? -9223372036854775806.0 : 18446744073709551614.0;
    default:
      return std::nullopt;
  }
}

}  // namespace

void heed(Conventions& conventions, std::string_view name, std::span<const double> values) {
  if (values.empty()) return;
  if (name == "missing_value") conventions.none.insert(conventions.none.end(), values.begin(), values.end());
  if (name == "valid_range" && values.size() == 2) {
    conventions.lowest = values[0];
    conventions.highest = values[1];
  }
  if (values.size() != 1) return;
  if (name == "_FillValue") {
    conventions.has_fill = true;
    conventions.none.push_back(values[0]);
  }
  if (name == "valid_min") conventions.lowest = values[0];
  if (name == "valid_max") conventions.highest = values[0];
  if (name == "scale_factor") conventions.scale = values[0];
  if (name == "add_offset") conventions.shift = values[0];
}

void heed(Conventions& conventions, std::string_view name, std::string_view text) {
  if (name == "_Unsigned") conventions.is_unsigned = text == "true" || text == "True" || text == "TRUE";
  if (name == "sample_dimension") conventions.samples = text;
  if (name == "instance_dimension") conventions.instances = text;
  if (name == "cf_role") conventions.is_name = text.ends_with("_id");
}

ArrayInfo::Role role_by(const Conventions& conventions) {
  if (!conventions.samples.empty()) return ArrayInfo::Role::counts;
  return conventions.instances.empty() ? ArrayInfo::Role::other : ArrayInfo::Role::instances;
}

void apply_conventions(Buffer<double>& numbers, const Conventions& conventions, StoredType type, bool is_netcdf) {
  Conventions all = conventions;
  const bool wraps = all.is_unsigned && !type.is_float && type.is_signed;
  if (!all.has_fill && (is_netcdf || type.is_float)) {
    if (const std::optional<double> fill = default_fill({type.size, type.is_float, type.is_signed && !wraps})) {
      all.none.push_back(*fill);
    }
  }
  // Attributes are of the variable's type, or are rounded to it.
  const double turn = std::ldexp(1.0, static_cast<int>(8 * type.size));
  const auto stored = [&](double value) {
    if (type.is_float && type.size == sizeof(float)) return static_cast<double>(static_cast<float>(value));
    return wraps && value < 0 ? value + turn : value;
  };
  for (double& none : all.none) none = stored(none);
  const double lowest = all.lowest ? stored(*all.lowest) : -std::numeric_limits<double>::infinity();
  const double highest = all.highest ? stored(*all.highest) : std::numeric_limits<double>::infinity();
  const double scale = all.scale.value_or(1), shift = all.shift.value_or(0);
  for (double& number : numbers) {
    if (wraps && number < 0) number += turn;
    const bool is_none = std::find(all.none.begin(), all.none.end(), number) != all.none.end();
    if (is_none || number < lowest || number > highest) {
      number = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    if (all.scale) number *= scale;
    if (all.shift) number += shift;
  }
}

}  // namespace lober::detail

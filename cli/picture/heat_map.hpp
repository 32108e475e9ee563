// Heat maps: values over two quantities, in classes of round limits.
#pragma once

#include <string>
#include <vector>

#include "cli/picture/figure.hpp"

namespace lober::cli {

/// The values that a quantity takes, in order, and where they lie on an axis.
struct HeatAxis {
  Axis axis{};
  std::vector<double> edges{};  ///< borders of the cells of the values, one more than there are values

  /// Numbers, ascending: the cells reach half way to the next ones. Where one step is more than three times another
  /// one, and where there are at most `max_names` at equal distances, they are names.
  [[nodiscard]] static HeatAxis of_numbers(std::string name, const std::vector<double>& numbers,
                                           std::size_t max_names = 12);
  /// Names at equal distances.
  [[nodiscard]] static HeatAxis of_names(std::string name, std::vector<std::string> names);
};

struct HeatCell {
  std::size_t column, row;  ///< numbers of the values along x and y
  double value;             ///< cells whose value is not finite are left out
};

/// Appends a layer for each class of values, from dark to light, and sets axes and window.
void add_heat_map(Figure& figure, const HeatAxis& x, const HeatAxis& y, const std::vector<HeatCell>& cells);

}  // namespace lober::cli

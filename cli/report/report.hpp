// Common parts of the reports of all commands on two closed curves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cli/report/table.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"
#include "lober/overlay/areas.hpp"
#include "lober/overlay/crossings.hpp"

namespace lober::cli {

/// The areas under the names that the program uses, in its order.
struct NamedArea {
  const char* key;    ///< in the JSON
  const char* label;  ///< in the table
  double Areas::*member;
};
inline constexpr std::array<NamedArea, 7> named_areas{{
    {"c1", "C1", &Areas::c1},
    {"c2", "C2", &Areas::c2},
    {"intersection", "C1 and C2", &Areas::intersection},
    {"union", "C1 or C2", &Areas::union_},
    {"c1_minus_c2", "C1 \\ C2", &Areas::c1_minus_c2},
    {"c2_minus_c1", "C2 \\ C1", &Areas::c2_minus_c1},
    {"symmetric_difference", "either, not both", &Areas::symmetric_difference},
}};

/// The first columns of a table of areas: the names of the areas, the areas, and the bounds of their rounding.
[[nodiscard]] Table areas_table(const std::string& of, const std::string& what);
[[nodiscard]] std::vector<std::string> area_cells(const NamedArea& area, const Areas& areas, const Areas& rounding);

/// "12 crossings, 1 touch, 0 shared arcs", or that the curves are one and the same.
[[nodiscard]] std::string meetings_text(const Crossings& nodes);

[[nodiscard]] std::string counted(std::size_t count, const char* one, const char* many);

/// The name that the user would give it: FILE, or FILE#ZONE where there are several.
[[nodiscard]] std::string spec_of(const NamedCurve& input);

/// Two aligned lines on the curves that were read, and one for each remark.
[[nodiscard]] std::string inputs_text(const std::array<NamedCurve, 2>& inputs,
                                      const std::array<Orientation, 2>& orientations);

/// The largest number of pieces of one kind, or of points, that a table lists.
inline constexpr std::size_t max_table_rows = 10;
/// The numbers of the largest pieces, largest first, at most max_table_rows.
[[nodiscard]] std::vector<std::uint32_t> largest(std::span<const double> areas);

}  // namespace lober::cli

// What the reports on closed curves that may cross themselves have in common (lober/regions.hpp).
#pragma once

#include <array>
#include <string>

#include "cli/report/json.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/report.hpp"
#include "lober/regions.hpp"

namespace lober::cli {

/// The text of the option --rule.
inline constexpr const char* rule_help =
    "The fill rule for curves that may cross themselves: a point is inside where the winding number of the curve is "
    "not "
    "zero (nonzero), odd (evenodd), positive or negative; a counter-clockwise turn counts +1 (default: the curves have "
    "to be simple).";

/// Signs of the signed areas.
[[nodiscard]] std::array<Orientation, 2> orientations_of(const Regions& regions);

/// Nodes and faces; the area of each pair of winding numbers.
[[nodiscard]] std::string windings_text(const Regions& regions);
/// The areas under the rule, with their bounds.
[[nodiscard]] std::string region_areas_text(const Regions& regions, FillRule rule);

[[nodiscard]] Json inputs_json(const std::array<NamedCurve, 2>& inputs, const Regions& regions);
/// The member `arrangement`.
[[nodiscard]] Json arrangement_json(const RegionCounts& counts);
/// Adds the member `winding`.
void list_windings(JsonFile& json, const Regions& regions);
/// The member `error`.
[[nodiscard]] Json region_errors_json(const Regions& regions, FillRule rule);
/// The member `statistics`.
[[nodiscard]] Json region_statistics_json(const RegionCounts& counts);
/// Members of `timing`.
[[nodiscard]] Json region_timing_json(const RegionTiming& timing);

}  // namespace lober::cli

// Everything that `lober interior` found, for the table and the JSON to show.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "cli/report/report.hpp"
#include "lober/agreement.hpp"
#include "lober/interior.hpp"
#include "lober/regions.hpp"

namespace lober::cli {

struct InteriorReport {
  std::array<NamedCurve, 2> inputs;
  InteriorOptions options;
  InteriorAreas result;
  /// When segments were not split: |area - area with segments split where the curves meet|.
  std::optional<Areas> splitting;
  /// When asked for: |area - area by the overlay|, and whether the bars explain it.
  std::optional<Areas> consistency;
  Agreement agreement;
  double read_seconds = 0, index_seconds = 0, verify_seconds = 0;
};

/// The areas by these options, and, where segments are not split, what that costs.
struct MeasuredAreas {
  InteriorAreas result;
  std::optional<Areas> splitting;
};
[[nodiscard]] MeasuredAreas measure_areas(const IndexedCurve& c1, const IndexedCurve& c2,
                                          const InteriorOptions& options);

/// The short aligned table for people.
[[nodiscard]] std::string interior_table(const InteriorReport& report);

/// What `lober interior --rule` found, of curves that may cross themselves.
struct RuledInteriorReport {
  std::array<NamedCurve, 2> inputs;
  FillRule rule = FillRule::nonzero;
  Regions result;
  double read_seconds = 0;
};
[[nodiscard]] std::string ruled_interior_table(const RuledInteriorReport& report);
void write_ruled_interior_json(const std::string& path, const RuledInteriorReport& report,
                               const std::function<double()>& seconds_so_far);

/// Writes the JSON object (docs/conventions.md, section 13); `seconds_so_far` gives the time since the program began.
void write_interior_json(const std::string& path, const InteriorReport& report,
                         const std::function<double()>& seconds_so_far);

/// The parts of both curves outside and inside of each other, the paths of Q1, Q2 and Q3, as an SVG picture.
void write_interior_picture(const std::string& path, const InteriorReport& report);

}  // namespace lober::cli

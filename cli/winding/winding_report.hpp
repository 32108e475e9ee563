// Everything that `lober winding` found, for the table, the JSON, the files and the picture to show.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "cli/picture/figure.hpp"
#include "lober/base/buffer.hpp"
#include "lober/curve/files.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

/// The cells whose centres are the points, row by row from below.
struct WindingGrid {
  Rectangle window;
  std::size_t columns = 0, rows = 0;
};

struct WindingReport {
  NamedCurve input;
  double signed_area = 0;
  std::optional<WindingGrid> grid;
  Buffer<Point> points;
  operations::Outcome outcome;
  double read_seconds = 0, index_seconds = 0, winding_seconds = 0, write_seconds = 0;

  [[nodiscard]] const operations::CurveWinding& found() const { return outcome.as<operations::CurveWinding>(); }
};

/// The short table for people.
[[nodiscard]] std::string winding_table(const WindingReport& report);
/// x, y, winding, on, j of each point, into a file whose ending says the format.
void write_winding_columns(const std::string& path, const WindingReport& report);
/// The field of winding numbers on the grid, and the curve, borrowed.
[[nodiscard]] Figure winding_figure(const WindingReport& report);
/// Writes the JSON object (docs/conventions.md, section 13); `seconds_so_far` gives the time since the program began.
void write_winding_json(const std::string& path, const WindingReport& report,
                        const std::function<double()>& seconds_so_far);

}  // namespace lober::cli

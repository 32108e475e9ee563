#include "cli/fixed_points/fixed_points_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <complex>

#include "cli/program/system_options.hpp"
#include "cli/report/report.hpp"
#include "cli/report/text.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

std::string multiplier_text(std::complex<double> value) {
  if (value.imag() == 0) return fmt::format("{:.12g}", value.real());
  return fmt::format("{:.9g} {} {:.9g} i", value.real(), value.imag() < 0 ? '-' : '+', std::fabs(value.imag()));
}

std::string box_text(const Rectangle& box) {
  return fmt::format("[{:.10g}, {:.10g}] x [{:.10g}, {:.10g}]", box.min_x, box.max_x, box.min_y, box.max_y);
}

std::string completeness_text(const FixedPointsReport& report) {
  const FixedPointSearch& search = report.result();
  if (!search.isolated) {
    return fmt::format(
        "NOT ISOLATED: fixed points fill a curve or an area; these are some, found on a grid of {} x {}\n", search.grid,
        search.grid);
  }
  std::string text =
      fmt::format("{} on grids up to {} x {}", search.settled ? "the same points were found twice" : "NOT SETTLED",
                  search.grid, search.grid);
  if (search.index_of_box) {
    text +=
        fmt::format("; the index of the box is {}, the sum of the points' {}", *search.index_of_box, search.index_sum);
  } else {
    text += "; the index of the box is not defined";
  }
  if (search.out_of_work) {
    text += "; points may be missing: more is more work than ";
    text += report.budget_given ? "--budget allows" : "is done unasked (--budget SECONDS allows more)";
  } else if (!search.settled)
    text += "; points may be missing, or the map may not be continuous: try a larger --max-grid";
  return text + "\n";
}

}  // namespace

std::string fixed_points_table(const FixedPointsReport& report) {
  const operations::SystemFixedPoints& found = report.result();
  std::string text = system_text(report.system) + "\n";
  text += fmt::format("points of period {} in {}{}\n", found.period, box_text(found.box),
                      found.turns == 0 ? "" : fmt::format(", {} turns", found.turns));
  text += fmt::format("\n{} found; {}", counted(found.points.size(), "point", "points"), completeness_text(report));
  if (found.points.empty()) return text;
  const Table table({{"x", 20, Align::right, 0},
                     {"y", 20},
                     {"period", 6},
                     {"type", 15, Align::left, 2},
                     {"residue", 14},
                     {"multiplier", 28},
                     {"residual", 9}});
  text += "\n" + table.head();
  for (const FixedPoint& point : found.points) {
    text +=
        table.row({fmt::format("{:.14g}", point.at.x), fmt::format("{:.14g}", point.at.y), std::to_string(point.period),
                   std::string(name(point.kind)), fmt::format("{:.8g}", residue(point)),
                   multiplier_text(point.multipliers[0]), fmt::format("{:.1e}", point.residual)});
  }
  return text;
}

void write_fixed_points_csv(const std::string& path, const FixedPointsReport& report) {
  std::string text =
      "x,y,period,type,residue,index,multiplier1_re,multiplier1_im,multiplier2_re,multiplier2_im,residual\n";
  for (const FixedPoint& point : report.result().points) {
    const auto& [first, second] = point.multipliers;
    append_all(text, point.at.x, ",", point.at.y, ",", point.period, ",\"", name(point.kind), "\",", residue(point),
               ",", index_of(point, report.result().period), ",", first.real(), ",", first.imag(), ",", second.real(),
               ",", second.imag(), ",", point.residual, "\n");
  }
  write_file(path, text);
}

}  // namespace lober::cli

#include "cli/fixed_points/fixed_points_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "cli/program/system_options.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/report.hpp"
#include "cli/report/text.hpp"
#include "lober/files.hpp"

namespace lober::cli {
namespace {

std::string multiplier_text(std::complex<double> value) {
  if (value.imag() == 0) return fmt::format("{:.12g}", value.real());
  return fmt::format("{:.9g} {} {:.9g} i", value.real(), value.imag() < 0 ? '-' : '+', std::fabs(value.imag()));
}

Json multiplier_json(std::complex<double> value) {
  return {value.real(), value.imag()};
}

// Of the points near by, in turns a period.
double rotation(const FixedPoint& point) {
  return std::arg(point.eigenvalues[0]) / (2 * std::numbers::pi);
}

std::string box_text(const Rectangle& box) {
  return fmt::format("[{:.10g}, {:.10g}] x [{:.10g}, {:.10g}]", box.min_x, box.max_x, box.min_y, box.max_y);
}

std::string completeness_text(const FixedPointsReport& report) {
  const FixedPointSearch& search = report.search;
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
    text += report.options.budget > 0 ? "--budget allows" : "is done unasked (--budget SECONDS allows more)";
  } else if (!search.settled)
    text += "; points may be missing, or the map may not be continuous: try a larger --max-grid";
  return text + "\n";
}

}  // namespace

std::string fixed_points_table(const FixedPointsReport& report) {
  std::string text = system_text(report.system) + "\n";
  text += fmt::format("points of period {} in {}{}\n", report.options.period, box_text(report.box),
                      report.turns == 0 ? "" : fmt::format(", {} turns", report.turns));
  text +=
      fmt::format("\n{} found; {}", counted(report.search.points.size(), "point", "points"), completeness_text(report));
  if (report.search.points.empty()) return text;
  text += fmt::format("\n{:>20} {:>20} {:>6} {:<16} {:>14} {:>28} {:>9}\n", "x", "y", "period", " type", "residue",
                      "multiplier", "residual");
  for (const FixedPoint& point : report.search.points) {
    text += fmt::format("{:>20.14g} {:>20.14g} {:>6}  {:<15} {:>14.8g} {:>28} {:>9.1e}\n", point.at.x, point.at.y,
                        point.period, name_of(point.kind), residue(point), multiplier_text(point.eigenvalues[0]),
                        point.residual);
  }
  return text;
}

void write_fixed_points_csv(const std::string& path, const FixedPointsReport& report) {
  std::string text =
      "x,y,period,type,residue,index,multiplier1_re,multiplier1_im,multiplier2_re,multiplier2_im,residual\n";
  for (const FixedPoint& point : report.search.points) {
    const auto& [first, second] = point.eigenvalues;
    append_all(text, point.at.x, ",", point.at.y, ",", point.period, ",\"", name_of(point.kind), "\",", residue(point),
               ",", index_of(point, report.options.period), ",", first.real(), ",", first.imag(), ",", second.real(),
               ",", second.imag(), ",", point.residual, "\n");
  }
  write_file(path, text);
}

void write_fixed_points_json(const std::string& path, const FixedPointsReport& report,
                             const std::function<double()>& seconds_so_far) {
  JsonFile json(path, "fixed-points");
  const FixedPointSearch& search = report.search;
  json.member("system", system_json(report.system, report.integration));
  json.member("options", {{"box", {report.box.min_x, report.box.min_y, report.box.max_x, report.box.max_y}},
                          {"period", report.options.period},
                          {"turns", report.turns},
                          {"shift", point_json(report.options.shift)},
                          {"grid", report.options.grid},
                          {"max_grid", report.max_grid}});
  json.member("search", {{"settled", search.settled},
                         {"out_of_work", search.out_of_work},
                         {"grid", search.grid},
                         {"index_sum", search.index_sum},
                         {"index_of_box", search.index_of_box ? Json(*search.index_of_box) : Json()}});
  Json points = Json::array();
  for (const FixedPoint& point : search.points) {
    const Matrix2& d = point.derivative;
    Json one{{"x", point.at.x},
             {"y", point.at.y},
             {"period", point.period},
             {"type", name_of(point.kind)},
             {"residue", residue(point)},
             {"index", index_of(point, report.options.period)},
             {"multipliers", {multiplier_json(point.eigenvalues[0]), multiplier_json(point.eigenvalues[1])}},
             {"derivative", {{d.xx, d.xy}, {d.yx, d.yy}}},
             {"residual", point.residual}};
    one["rotation"] = point.eigenvalues[0].imag() != 0 ? Json(rotation(point)) : Json();
    one["directions"] = point.eigenvalues[0].imag() != 0
                            ? Json()
                            : Json{point_json(point.directions[0]), point_json(point.directions[1])};
    points.push_back(std::move(one));
  }
  json.member("points", points);
  json.finish({{"search", report.search_seconds}, {"total", seconds_so_far()}});
}

}  // namespace lober::cli

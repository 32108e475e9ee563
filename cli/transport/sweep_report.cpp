#include "cli/transport/sweep_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "cli/picture/system_figure.hpp"
#include "cli/program/option_names.hpp"
#include "cli/program/system_options.hpp"
#include "cli/transport/transport_report.hpp"

namespace lober::cli {
namespace {

std::string fixed_text(const SweepReport& report) {
  System fixed;
  fixed.info.name = report.system.name;
  for (const Parameter& parameter : report.system.parameters) {
    if (parameter.name != report.result().parameter) fixed.info.parameters.push_back(parameter);
  }
  return system_text(fixed);
}

// The remarks of rows, each once, with the first value that has it.
std::string remarks_text(const SweepReport& report) {
  std::string text;
  std::set<std::string> said;
  for (const SweepRow& row : report.result().rows) {
    if (row.remark.empty() || !said.insert(row.remark).second) continue;
    text += fmt::format("no flux at {} = {:.6g}: {}\n", report.result().parameter, row.value,
                        with_option_names(row.remark));
  }
  return text;
}

double largest_difference(const SweepRow& row) {
  if (row.areas_by_action.empty()) return std::numeric_limits<double>::quiet_NaN();
  double largest = 0;
  for (std::size_t k = 0; k < row.areas.size(); ++k) {
    largest = std::max(largest, std::fabs(row.areas[k] - row.areas_by_action[k]));
  }
  return largest;
}

// Between which values pips could not be followed.
std::string breaks_text(const SweepReport& report) {
  const auto& rows = report.result().rows;
  const auto known = [](const SweepRow& row) { return row.failure.empty() && !std::isnan(row.difference); };
  std::string text;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    if (!known(rows[k - 1]) || !known(rows[k]) || rows[k].follows) continue;
    text += fmt::format("{}{:.6g} and {:.6g}", text.empty() ? "" : ", ", rows[k - 1].value, rows[k].value);
  }
  if (text.empty()) return text;
  return fmt::format(
      "W(q) - W(q') may be of other pips on either side, which could not be followed, between {} = {}; "
      "try a smaller step\n",
      report.result().parameter, text);
}

// The pip of the lobes: from the first value to the last, on whose way it may become an image of itself.
std::string bip_text(const SweepReport& report) {
  const auto& rows = report.result().rows;
  const auto known = [](const SweepRow& row) { return row.failure.empty(); };
  const auto first = std::find_if(rows.begin(), rows.end(), known);
  const auto last = std::find_if(rows.rbegin(), rows.rend(), known);
  if (first == rows.end()) return {};
  const auto text = [&](const SweepRow& row) {
    return fmt::format("({:.12g}, {:.12g}) at {} = {:.6g}", row.bip.x, row.bip.y, report.result().parameter, row.value);
  };
  return "bip " + text(*first) + (&*first == &*last ? "" : " to " + text(*last)) + "\n";
}

}  // namespace

std::string sweep_table(const SweepReport& report) {
  std::string text = fixed_text(report) + "\n\n";
  text += fmt::format("{:>10} {:>16} {:>15} {:>7} {:>18} {:>8} {:>18} {:>18} {:>18} {:>10}", report.result().parameter,
                      "multiplier", "saddle x", "lobes", "flux a21(1)", "+-", "lobes by geometry", "lobes by action",
                      "W(q) - W(q')", "worst lobe");
  text += report.result().first_order ? fmt::format(" {:>18}\n", "first order") : std::string("\n");
  for (std::size_t k = 0; k < report.result().rows.size(); ++k) {
    const SweepRow& row = report.result().rows[k];
    if (!row.failure.empty()) {
      text += fmt::format("{:>10.6g} failed: {}\n", row.value, with_option_names(row.failure));
      continue;
    }
    const bool flux = row.remark.empty();
    text += fmt::format("{:>10.6g} {:>16.10g} {:>15.10g} {:>7} {:>18} {:>8} {:>18.13g} {:>18.13g} {:>18.13g} {:>10.1e}",
                        row.value, row.multiplier, row.from.x, row.period,
                        flux ? fmt::format("{:.13g}", row.flux21.value) : "-",
                        flux ? fmt::format("{:.1e}", row.flux21.error) : "-", row.lobe_area21.value,
                        row.lobe_area21_by_action, row.difference, largest_difference(row));
    const bool estimate = report.result().first_order && !std::isnan((*report.result().first_order)[k]);
    if (report.result().first_order)
      text += fmt::format(" {:>18}", estimate ? fmt::format("{:.13g}", (*report.result().first_order)[k]) : "-");
    text += "\n";
  }
  text += bip_text(report);
  text += remarks_text(report);
  text += breaks_text(report);
  for (const SweepZero& zero : report.result().zeros) {
    text += fmt::format("\nW(q) - W(q') changes sign at {} = {:.12g} +- {:.1e}", report.result().parameter, zero.value,
                        zero.width);
    if (zero.evaluations > 0) {
      text += fmt::format(", where it is {:.1e} ({} more values)", zero.difference, zero.evaluations);
    }
    if (!zero.failure.empty()) text += ": " + with_option_names(zero.failure);
    text += "\n";
  }
  if (!report.result().no_zero.empty()) text += "\n" + report.result().no_zero + "\n";
  return text;
}

Figure sweep_figure(const SweepReport& report) {
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  Figure figure{.what = "Areas of the turnstile over " + report.result().parameter, .title = fixed_text(report)};
  figure.plane = false;
  figure.zero_line = true;
  figure.x = {report.result().parameter};
  figure.y = {"area"};
  std::vector<Point> difference, lobes, estimate;
  Layer flux = dot_layer("a21(1)", "flux a21(1)", {}, 1.5);
  flux.colour = palette::leaving;
  Rectangle box;
  for (std::size_t k = 0; k < report.result().rows.size(); ++k) {
    const SweepRow& row = report.result().rows[k];
    const bool there = row.failure.empty();
    difference.push_back({row.value, there ? row.difference : gap});
    lobes.push_back({row.value, there ? row.lobe_area21_by_action : gap});
    if (there && std::isfinite(row.flux21.value)) {
      flux.points.push_back({row.value, row.flux21.value});
      flux.errors.push_back(row.flux21.error);
    }
    if (report.result().first_order) estimate.push_back({row.value, (*report.result().first_order)[k]});
    box = include(box, std::array{Point{row.value, 0}});
  }
  const auto add_line = [&](const char* name, const char* legend, const char* colour, std::vector<Point>& points,
                            bool dashed) {
    Layer layer = line_layer(name, legend, colour, 0.8);
    layer.dashed = dashed;
    layer.lines.push_back(polyline(std::move(points), false));
    figure.layers.push_back(std::move(layer));
  };
  add_line("lobes", "area of the lobes that enter, by action", palette::entering, lobes, false);
  add_line("difference", "W(q) \u2212 W(q'), by action", palette::action, difference, false);
  if (report.result().first_order) {
    add_line("first order", "area of the lobes to first order in eps (Melnikov)", palette::estimate, estimate, true);
  }
  figure.layers.push_back(std::move(flux));
  for (const Layer& layer : figure.layers) {
    const auto add = [&](std::span<const Point> points) {
      for (const Point& point : points) {
        if (std::isfinite(point.y)) box.add(point);
      }
    };
    add(layer.points);
    for (const Polyline& line : layer.lines) add(line.points());
  }
  for (const SweepZero& zero : report.result().zeros) figure.x_marks.push_back(zero.value);
  if (!box.empty()) figure.window = widened_plot(box);
  return figure;
}

}  // namespace lober::cli

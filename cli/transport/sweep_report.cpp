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
#include "cli/report/report.hpp"
#include "cli/report/table.hpp"
#include "cli/transport/transport_report.hpp"

namespace lober::cli {
namespace {

System fixed_system(const SystemInfo& system, const std::string& varied) {
  System fixed;
  fixed.info.name = system.name;
  for (const Parameter& parameter : system.parameters) {
    if (parameter.name != varied) fixed.info.parameters.push_back(parameter);
  }
  return fixed;
}

Table table_of(const operations::SystemSweep& sweep) {
  Table table({{sweep.parameter, 10, Align::right, 0},
               {"multiplier", 16},
               {"saddle x", 15},
               {"lobes", 7},
               {"flux a21(1)", 18},
               {"+-", 8},
               {"lobes by geometry", 18},
               {"lobes by action", 18},
               {"W(q) - W(q')", 18},
               {"worst lobe", 10}});
  if (sweep.first_order) table.add({"first order", 18});
  return table;
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

// Why rows failed, each reason once, with the first value that has it and how many have.
std::string failures_text(const SweepReport& report) {
  constexpr std::size_t most = 10;
  struct Reason {
    const SweepRow* first;
    std::size_t rows = 0;
  };
  std::vector<Reason> reasons;
  for (const SweepRow& row : report.result().rows) {
    if (row.failure.empty()) continue;
    const auto known = std::find_if(reasons.begin(), reasons.end(),
                                    [&](const Reason& reason) { return reason.first->failure == row.failure; });
    ++(known == reasons.end() ? reasons.emplace_back(Reason{&row}) : *known).rows;
  }
  std::string text;
  for (std::size_t k = 0; k < std::min(most, reasons.size()); ++k) {
    const auto& [row, rows] = reasons[k];
    text += fmt::format("failed at {} = {:.6g}{}: {}\n", report.result().parameter, row->value,
                        rows > 1 ? fmt::format(" and {} more", rows - 1) : "", with_option_names(row->failure));
  }
  if (reasons.size() > most)
    text += fmt::format("and {}\n", counted(reasons.size() - most, "other reason", "other reasons"));
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

std::string sweep_head(const SystemInfo& system, const operations::SystemSweep& sweep) {
  return system_text(fixed_system(system, sweep.parameter)) + "\n\n" + table_of(sweep).head();
}

std::string sweep_row(const operations::SystemSweep& sweep, std::size_t k) {
  const SweepRow& row = sweep.rows[k];
  const std::string value = fmt::format("{:.6g}", row.value);
  if (!row.failure.empty()) return table_of(sweep).row({value}, " failed");
  const bool flux = row.remark.empty();
  std::vector<std::string> cells{value,
                                 fmt::format("{:.10g}", row.multiplier),
                                 fmt::format("{:.10g}", row.from.x),
                                 std::to_string(row.period),
                                 flux ? fmt::format("{:.13g}", row.flux21.value) : "-",
                                 flux ? fmt::format("{:.1e}", row.flux21.error) : "-",
                                 fmt::format("{:.13g}", row.lobe_area21.value),
                                 fmt::format("{:.13g}", row.lobe_area21_by_action),
                                 fmt::format("{:.13g}", row.difference),
                                 fmt::format("{:.1e}", largest_difference(row))};
  if (sweep.first_order) {
    const double estimate = (*sweep.first_order)[k];
    cells.push_back(std::isnan(estimate) ? "-" : fmt::format("{:.13g}", estimate));
  }
  return table_of(sweep).row(cells);
}

std::string sweep_table(const SweepReport& report) {
  std::string text = sweep_head(report.system, report.result());
  for (std::size_t k = 0; k < report.result().rows.size(); ++k) text += sweep_row(report.result(), k);
  return text + sweep_summary(report);
}

std::string sweep_summary(const SweepReport& report) {
  std::string text = failures_text(report) + bip_text(report);
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
  Figure figure{.what = "Areas of the turnstile over " + report.result().parameter,
                .title = system_title(fixed_system(report.system, report.result().parameter).info)};
  figure.plane = false;
  figure.zero_line = true;
  figure.x = {report.result().parameter};
  figure.y = {"area"};
  std::vector<Point> difference, lobes, estimate;
  Layer flux = dot_layer("a21(1)", "flux a21(1)", {}, 1.5);
  flux.colour = palette::flux;
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
  // A value between two that failed is a dot, as no line leads to it.
  const auto add_line = [&](const char* name, const char* legend, const char* colour, std::vector<Point>& points,
                            bool dashed) {
    const auto is_there = [&](std::size_t k) { return k < points.size() && std::isfinite(points[k].y); };
    std::vector<Point> alone;
    bool leads = false;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!is_there(k)) continue;
      if (is_there(k + 1) || (k > 0 && is_there(k - 1))) {
        leads = true;
      } else {
        alone.push_back(points[k]);
      }
    }
    if (leads) {
      Layer layer = line_layer(name, legend, colour, 0.8);
      layer.dashed = dashed;
      layer.lines.push_back(polyline(std::move(points), false));
      figure.layers.push_back(std::move(layer));
    }
    if (!alone.empty()) {
      Layer layer = dot_layer(name, leads ? "" : legend, std::move(alone), 1);
      layer.colour = colour;
      figure.layers.push_back(std::move(layer));
    }
  };
  add_line("lobes", "area of the lobes that enter, by action", palette::entering, lobes, false);
  add_line("difference", "W(q) \u2212 W(q'), by action", palette::action, difference, false);
  if (report.result().first_order) {
    add_line("first order", "area of the lobes to first order in eps (Melnikov)", palette::estimate, estimate, true);
  }
  if (!flux.points.empty()) figure.layers.push_back(std::move(flux));
  for (const Layer& layer : figure.layers) {
    const auto add = [&](std::span<const Point> points) {
      for (const Point& point : points) {
        if (std::isfinite(point.y)) box.add(point);
      }
    };
    add(layer.points);
    for (const Polyline& line : layer.lines) add(line.points());
  }
  for (const SweepZero& zero : report.result().zeros) {
    figure.x_marks.push_back(zero.value);
    figure.notes.push_back("vertical line: W(q) = W(q') at " + report.result().parameter + " = " + rounded(zero.value));
  }
  const auto& rows = report.result().rows;
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const SweepRow& row) { return !row.failure.empty(); });
  if (failed > 0) {
    figure.notes.push_back("no areas at " + std::to_string(failed) + " of " + counted(rows.size(), "value", "values"));
  }
  if (!box.empty()) figure.window = widened_plot(box);
  return figure;
}

}  // namespace lober::cli

#include "cli/transport/sweep_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "cli/program/option_names.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/plot.hpp"
#include "cli/report/svg.hpp"
#include "engine/base/even_values.hpp"
#include "lober/error.hpp"

namespace lober::cli {
namespace {

std::string fixed_text(const SweepReport& report) {
  System fixed;
  fixed.info.name = report.system.info.name;
  for (const Parameter& parameter : report.system.info.parameters) {
    if (parameter.name != report.range.name) fixed.info.parameters.push_back(parameter);
  }
  return system_text(fixed);
}

// The remarks of rows, each once, with the first value that has it.
std::string remarks_text(const SweepReport& report) {
  std::string text;
  std::set<std::string> said;
  for (const SweepRow& row : report.result.rows) {
    if (row.remark.empty() || !said.insert(row.remark).second) continue;
    text += fmt::format("no flux at {} = {:.6g}: {}\n", report.range.name, row.value, with_option_names(row.remark));
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

Json row_json(const SweepRow& row) {
  if (!row.failure.empty()) return {{"value", row.value}, {"failure", row.failure}};
  return {{"value", row.value},
          {"failure", nullptr},
          {"saddles", {point_json(row.from), point_json(row.to)}},
          {"eigenvalue", row.multiplier},
          {"period", row.period},
          {"areas", row.areas},
          {"errors", row.errors},
          {"actions", row.areas_by_action},
          {"flux12", row.flux12.value},
          {"flux12_error", row.flux12.error},
          {"flux21", row.flux21.value},
          {"flux21_error", row.flux21.error},
          {"lobe_area12", row.lobe_area12.value},
          {"lobe_area21", row.lobe_area21.value},
          {"lobe_area12_by_action", row.lobe_area12_by_action},
          {"lobe_area21_by_action", row.lobe_area21_by_action},
          {"remark", row.remark.empty() ? Json() : Json(row.remark)},
          {"difference", row.difference},
          {"follows", row.follows}};
}

// Between which values pips could not be followed.
std::string breaks_text(const SweepReport& report) {
  const auto& rows = report.result.rows;
  const auto known = [](const SweepRow& row) { return row.failure.empty() && !std::isnan(row.difference); };
  std::string text;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    if (!known(rows[k - 1]) || !known(rows[k]) || rows[k].follows) continue;
    text += fmt::format("{}{:.6g} and {:.6g}", text.empty() ? "" : ", ", rows[k - 1].value, rows[k].value);
  }
  if (text.empty()) return text;
  return fmt::format(
      "W(q) - W(q') may be of other pips on either side, which could not be followed, between {} = {}; "
      "a smaller step may do\n",
      report.range.name, text);
}

// The known differences next to the ends of the range.
std::string no_zero_text(const SweepReport& report) {
  const auto known = [](const SweepRow& row) { return row.failure.empty() && !std::isnan(row.difference); };
  const auto& rows = report.result.rows;
  const auto first = std::find_if(rows.begin(), rows.end(), known);
  if (first == rows.end()) {
    return "no zero of W(q) - W(q') was found: it is not known at any value (only maps with an action have it)";
  }
  const auto last = std::find_if(rows.rbegin(), rows.rend(), known);
  const std::string& name = report.range.name;
  if (std::next(first) == last.base()) {
    return fmt::format(
        "no zero of W(q) - W(q') was looked for: it is known at one value only, {} = {:.12g}, where it is {:.6g}; give "
        "a range of more values",
        name, first->value, first->difference);
  }
  const bool gaps = !std::all_of(first, last.base(), known);
  return fmt::format(
      "no zero of W(q) - W(q') was found: it does not change sign between {} = {:.12g}, where it is {:.6g}, and {} = "
      "{:.12g}, where it is {:.6g}{}; give another range, or a smaller step",
      name, first->value, first->difference, name, last->value, last->difference,
      gaps ? ", as far as it is known in between" : "");
}

Json zero_json(const SweepZero& zero) {
  return {{"between", {zero.low, zero.high}},
          {"value", zero.value},
          {"width", zero.width},
          {"difference", zero.difference},
          {"evaluations", zero.evaluations},
          {"failure", zero.failure.empty() ? Json() : Json(zero.failure)}};
}

}  // namespace

SweepRange sweep_range(const std::string& text) {
  const auto bad = [&](const char* why) -> UsageError {
    return UsageError("--sweep: \"" + text + "\" is not of the form NAME=FIRST:LAST:STEP" + why);
  };
  const std::size_t equals = text.find('='), first = text.find(':'), second = text.find(':', first + 1);
  if (equals == std::string::npos || first == std::string::npos || second == std::string::npos || first < equals) {
    throw bad("");
  }
  std::array<double, 3> numbers{};
  const std::array<std::string, 3> texts{text.substr(equals + 1, first - equals - 1),
                                         text.substr(first + 1, second - first - 1), text.substr(second + 1)};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::optional<double> number = number_of(texts[k]);
    if (!number || !std::isfinite(*number)) throw bad("");
    numbers[k] = *number;
  }
  const auto [from, to, step] = numbers;
  if (step == 0 || (to - from) / step < 0) throw bad(" with a step that leads from the first value to the last");
  const auto values = detail::even_values(from, to, step);
  if (!values) throw bad(" with at most 100000 values");
  return {text.substr(0, equals), *values, from == to || values->size() > 1};
}

std::string sweep_table(const SweepReport& report) {
  std::string text = fixed_text(report) + "\n\n";
  text += fmt::format("{:>10} {:>16} {:>15} {:>7} {:>18} {:>8} {:>18} {:>18} {:>18} {:>10}", report.range.name,
                      "eigenvalue", "saddle x", "lobes", "flux a21(1)", "+-", "lobes by geometry", "lobes by action",
                      "W(q) - W(q')", "worst lobe");
  text += report.first_order ? fmt::format(" {:>18}\n", "first order") : std::string("\n");
  for (std::size_t k = 0; k < report.result.rows.size(); ++k) {
    const SweepRow& row = report.result.rows[k];
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
    const bool estimate = report.first_order && !std::isnan((*report.first_order)[k]);
    if (report.first_order)
      text += fmt::format(" {:>18}", estimate ? fmt::format("{:.13g}", (*report.first_order)[k]) : "-");
    text += "\n";
  }
  text += remarks_text(report);
  text += breaks_text(report);
  for (const SweepZero& zero : report.result.zeros) {
    text +=
        fmt::format("\nW(q) - W(q') changes sign at {} = {:.12g} +- {:.1e}", report.range.name, zero.value, zero.width);
    if (zero.evaluations > 0) {
      text += fmt::format(", where it is {:.1e} ({} more values)", zero.difference, zero.evaluations);
    }
    if (!zero.failure.empty()) text += ": " + with_option_names(zero.failure);
    text += "\n";
  }
  if (report.find_zeros && report.result.zeros.empty()) text += "\n" + no_zero_text(report) + "\n";
  return text;
}

void write_sweep_json(const std::string& path, const SweepReport& report,
                      const std::function<double()>& seconds_so_far) {
  JsonFile json(path, "transport --sweep");
  Json system = system_json(report.system, report.integration);
  system["parameters"].erase(report.range.name);
  Json zeros = Json::array();
  for (const SweepZero& zero : report.result.zeros) zeros.push_back(zero_json(zero));
  json.member("system", system);
  json.member("options", {{"tolerance", report.tolerance}});
  json.member("parameter", report.range.name);
  json.list("rows", report.result.rows.size(), [&](std::string& text, std::size_t k) {
    Json row = row_json(report.result.rows[k]);
    if (report.first_order) row["first_order"] = (*report.first_order)[k];
    text += dumped(row);
  });
  json.member("zeros", zeros);
  json.member("no_zero", report.find_zeros && report.result.zeros.empty() ? Json(no_zero_text(report)) : Json());
  json.member("failures", report.result.failures());
  json.finish({{"total", seconds_so_far()}});
}

void write_sweep_curve(const std::string& path, const SweepReport& report) {
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  PlotSeries difference{"W(q) - W(q'), by action", "#1f5fa8", {}, true, false};
  PlotSeries lobes{"area of the lobes that enter, by action", "#3f8f6b", {}, true, false};
  PlotSeries flux{"flux a21(1)", "#c8701e", {}, false, true};
  for (const SweepRow& row : report.result.rows) {
    const bool there = row.failure.empty();
    difference.points.push_back({row.value, there ? row.difference : gap});
    lobes.points.push_back({row.value, there ? row.lobe_area21_by_action : gap});
    flux.points.push_back({row.value, there ? row.flux21.value : gap});
  }
  Plot plot{"Areas of the turnstile of " + fixed_text(report),
            report.range.name + "; " + fixed_text(report),
            {std::move(flux), std::move(lobes), std::move(difference)},
            {}};
  if (report.first_order) {
    PlotSeries estimate{"area of the lobes to first order in eps (Melnikov)", "#8a3d7c", {}, true, false};
    for (std::size_t k = 0; k < report.result.rows.size(); ++k) {
      estimate.points.push_back({report.result.rows[k].value, (*report.first_order)[k]});
    }
    plot.series.push_back(std::move(estimate));
  }
  for (const SweepZero& zero : report.result.zeros) plot.marks.push_back(zero.value);
  write_plot(path, plot);
}

}  // namespace lober::cli

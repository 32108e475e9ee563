#include "cli/program/curves_run.hpp"

#include "cli/program/log.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/outcome_json.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::cli {

CurvesReport run_on_curves(const std::string& operation, const std::array<std::string, 2>& curves,
                           const std::vector<operations::OptionSetting>& settings, Periods periods,
                           Progress& progress) {
  const operations::Operation& entry = operations::named(operation);
  const operations::Options options = checked_options(entry, settings);
  CurvesReport report;
  report.specs = curves;
  report.periods = periods;
  progress.phase("reading", 0, 0.25);
  const detail::Stopwatch read_watch;
  double points = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    progress.file(k, 2);
    report.inputs[k] = read_curve(curves[k], true, {.periods = periods});
    points += static_cast<double>(report.inputs[k].curve.points.size());
  }
  require_same_columns(report.inputs[0].curve, report.inputs[1].curve);
  warn_of_longitudes(report.inputs[0], report.inputs[1], periods);
  move_near(report.inputs[1].curve.points, report.inputs[0].curve.points, periods);
  const std::string apart = period_warning(report.inputs[0].curve, report.inputs[1].curve, periods);
  report.read_seconds = read_watch.seconds();
  progress.of(points, "points");
  progress.phase(operation, 0.25, 0.9);
  const detail::Stopwatch index_watch;
  const std::array<IndexedCurve, 2> indexed{IndexedCurve(report.inputs[0].curve), IndexedCurve(report.inputs[1].curve)};
  std::vector<operations::Input> inputs;
  for (std::size_t k = 0; k < 2; ++k) {
    inputs.emplace_back(operations::CurveInput{report.inputs[k].curve, curves[k], &indexed[k]});
  }
  report.index_seconds = index_watch.seconds();
  operations::Context context;
  context.progress = [&](double fraction, const std::string&) { return progress.advance(fraction); };
  try {
    report.outcome = entry.run(inputs, options, context);
  } catch (const NotSimpleError& error) {
    const auto curve = static_cast<std::size_t>(error.curve - 1);
    const std::string& remark = report.inputs[curve].remark;
    throw DataError(curves[curve] + ": " + error.what() + " (--rule takes such curves)" +
                    (remark.empty() ? "" : "; the curve " + remark));
  }
  if (!apart.empty()) report.outcome.remarks.push_back(apart);
  log_remarks(report.outcome.remarks);
  return report;
}

void warn_of_longitudes(const NamedCurve& first, const NamedCurve& second, Periods periods) {
  if (periods.any() || !first.warning.empty() || !second.warning.empty()) return;
  const std::string warning = longitudes_warning(first.curve, second.curve);
  if (warning.empty()) return;
  log_warning("warning: " + warning + "; give --periodic " + (first.curve.latitude_first.value_or(false) ? "y" : "x") +
              "=360");
}

void write_curves_json(const std::string& path, std::string_view command, const std::string& operation,
                       CurvesReport& report, const std::array<double, 2>& areas,
                       const std::array<Orientation, 2>& orientations, const Json& engine,
                       const std::function<double()>& seconds_so_far,
                       const std::function<void(detail::OutputFile&)>& more) {
  const detail::Stopwatch watch;
  Json inputs = Json::array();
  for (std::size_t k = 0; k < 2; ++k) {
    inputs.push_back(input_json(report.inputs[k], areas[k], orientations[k]));
    add_spec(inputs.back(), report.inputs[k], report.specs[k]);
  }
  std::vector<std::pair<std::string, Json>> members{{"inputs", std::move(inputs)}};
  if (report.periods.any()) members.emplace_back("periodic", periods_json(report.periods));
  write_outcome_json(
      path, command, members, operations::named(operation), report.outcome,
      [&] {
        Json seconds{{"read", report.read_seconds}, {"index", report.index_seconds}};
        seconds.update(engine);
        seconds["write"] = report.write_seconds + watch.seconds();
        seconds["total"] = seconds_so_far();
        return seconds;
      },
      more);
}

Option add_rule_option(OptionParser& parser, std::string& rule) {
  return parser
      .add("--rule", rule,
           "The fill rule for curves that may cross themselves: a point is inside where the winding number of the "
           "curve is not zero (nonzero), odd (evenodd), positive or negative; a counter-clockwise turn counts +1 "
           "(default: the curves have to be simple).")
      .value("RULE")
      .one_of({"nonzero", "evenodd", "positive", "negative"});
}

}  // namespace lober::cli

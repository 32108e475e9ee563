// The JSON object of `lober escape`.

#include "cli/escape/escape_report.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/json.hpp"

namespace lober::cli {
namespace {

Json state_json(const FlowState& state) {
  return {state[0], state[1], state[2], state[3]};
}

Json curves_json(const std::vector<TubeCurve>& curves) {
  Json list = Json::array();
  for (const TubeCurve& curve : curves) {
    list.push_back({{"points", curve.image.points.size()},
                    {"direction", curve.direction},
                    {"cut", curve.cut},
                    {"cut_off", curve.cut_off},
                    {"area", curve.cut ? Json(nullptr) : Json(curve.area)},
                    {"area_error", curve.area_error}});
  }
  return list;
}

Json bottleneck_json(const Bottleneck& bottleneck, const std::string& name) {
  const PeriodicOrbit& orbit = bottleneck.orbit;
  Json monodromy = Json::array();
  for (std::size_t k = 0; k < 4; ++k) monodromy.push_back(state_json(orbit.monodromy[k]));
  return {{"name", name},
          {"saddle",
           {{"at", state_json(orbit.saddle.at)},
            {"energy", orbit.saddle.energy},
            {"rate", orbit.saddle.rate},
            {"frequency", orbit.saddle.frequency}}},
          {"orbit",
           {{"state", state_json(orbit.state)},
            {"turning", {state_json(orbit.turning[0]), state_json(orbit.turning[1])}},
            {"brake", orbit.brake},
            {"period", orbit.period},
            {"action", orbit.action},
            {"multipliers", {orbit.multiplier, 1, 1, 1 / orbit.multiplier}},
            {"monodromy", monodromy},
            {"trace_defect", orbit.trace_defect},
            {"residual", orbit.residual},
            {"continuation_steps", orbit.continuation_steps}}},
          {"area", bottleneck.area},
          {"area_defect", bottleneck.area_defect},
          {"entry_curves", curves_json(bottleneck.entry)},
          {"exit_curves", curves_json(bottleneck.exit)}};
}

Json table_json(const EscapeReport& report, const std::vector<std::string>& names) {
  Json table = Json::array();
  for (std::size_t k = 0; k < report.result.table.size(); ++k) {
    const EscapeFraction& row = report.result.table[k];
    Json entry{{"entrance", names[row.entry]},
               {"exit", names[row.exit]},
               {"crossings", row.crossings},
               {"iterates", row.iterates},
               {"fraction", number_json(row.fraction)},
               {"error", number_json(row.error)},
               {"cut", row.cut},
               {"split", {row.forward, row.backward}},
               {"other", number_json(row.other)},
               {"other_error", number_json(row.other_error)},
               {"other_split", {row.other_forward, row.other_backward}}};
    if (report.check) {
      const MonteCarloFraction& counted = report.check->table[k];
      entry["counted"] = {
          {"count", counted.count}, {"fraction", counted.fraction}, {"standard_error", counted.standard_error}};
    }
    table.push_back(std::move(entry));
  }
  return table;
}

// Null for a table that goes as far as was asked for.
Json stop_json(const EscapeReport& report) {
  const Escape& result = report.result;
  Json stop{{"why", stop_text(report)}};
  switch (result.stop) {
    case EscapeStop::done:
      return nullptr;
    case EscapeStop::points:
      stop["reason"] = "points";
      stop["points_ahead"] = result.points_ahead;
      break;
    case EscapeStop::work:
      stop["reason"] = "work";
      stop["work_spent"] = result.work_spent;
      stop["work_ahead"] = result.work_ahead;
      break;
    case EscapeStop::budget:
      stop["reason"] = "budget";
      stop["seconds_spent"] = result.seconds_spent;
      stop["seconds_ahead"] = result.seconds_ahead == 0 ? Json() : Json(result.seconds_ahead);  // null: broken off
      break;
    case EscapeStop::lost:
      stop["reason"] = "lost";
      break;
    case EscapeStop::cancelled:
      stop["reason"] = "interrupted";
      break;
  }
  return stop;
}

Json survival_json(const EscapeReport& report, const std::vector<std::string>& names) {
  Json list = Json::array();
  for (std::size_t entry = 0; entry < names.size(); ++entry) {
    for (const Survival& step : survival(report.result, entry)) {
      list.push_back({{"entrance", names[entry]},
                      {"crossings", step.crossings},
                      {"left", step.left},
                      {"remains", step.remains},
                      {"error", step.error}});
    }
  }
  return list;
}

}  // namespace

void write_escape_json(const std::string& path, const EscapeReport& report,
                       const std::function<double()>& seconds_so_far) {
  const Escape& result = report.result;
  const std::vector<std::string> names = bottleneck_names(result);
  const Section& section = result.section;
  Json parameters;
  for (const Parameter& parameter : report.system.parameters) parameters[parameter.name] = parameter.value;
  Json bottlenecks = Json::array();
  for (std::size_t k = 0; k < names.size(); ++k)
    bottlenecks.push_back(bottleneck_json(result.bottlenecks[k], names[k]));
  Json also_open = Json::array();
  for (const SaddlePoint& saddle : result.also_open) {
    also_open.push_back({{"at", state_json(saddle.at)}, {"energy", saddle.energy}});
  }
  Json object{{"command", "escape"},
              {"program", program_json()},
              {"system", {{"name", report.system.name}, {"parameters", parameters}}},
              {"energy", result.energy},
              {"options",
               {{"crossings", report.options.crossings},
                {"tolerance", report.options.tolerance},
                {"strip", report.options.strip},
                {"max_points", report.options.max_points},
                {"max_work", report.options.max_work},
                {"budget", report.options.budget}}},
              {"section",
               {{"coordinate", section.coordinate},
                {"value", section.value},
                {"direction", section.direction},
                {"chart", {section.chart_x, section.chart_y}},
                {"bound", section.bound_side == 0 ? Json(nullptr)
                                                  : Json{{"coordinate", section.bound_coordinate},
                                                         {"value", section.bound},
                                                         {"side", section.bound_side}}}}},
              {"bottlenecks", bottlenecks},
              {"also_open", also_open},
              {"crossings", result.crossings},
              {"stop", stop_json(report)},
              {"table", table_json(report, names)},
              {"survival", survival_json(report, names)},
              {"consistency", {{"largest_split_difference", result.largest_split_difference}}}};
  add_agreement(object, result.agreement);
  if (report.check) {
    object["monte_carlo"] = {{"trajectories", report.check->trajectories},
                             {"seed", report.check_options.seed},
                             {"lost", report.check->lost},
                             {"largest_deviation", report.check->largest_deviation}};
  }
  object["timing"] = {
      {"escape", report.escape_seconds}, {"monte_carlo", report.check_seconds}, {"total", seconds_so_far()}};
  write_file(path, dumped(object) + "\n");
}

}  // namespace lober::cli

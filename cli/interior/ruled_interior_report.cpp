// The table and the JSON of `lober interior --rule`. Q1, Q2 and Q3 are the areas that they are by definition
// (docs/conventions.md, section 7).

#include <spdlog/fmt/fmt.h>

#include "cli/interior/interior_report.hpp"
#include "cli/report/regions_parts.hpp"

namespace lober::cli {

std::string ruled_interior_table(const RuledInteriorReport& report) {
  const Areas areas = report.result.areas(report.rule);
  std::string text = inputs_text(report.inputs, orientations_of(report.result));
  text += windings_text(report.result);
  text += region_areas_text(report.result, report.rule);
  text += fmt::format("\nQ1 {:.16g}, Q2 {:.16g}, Q3 {:.16g}\n", areas.symmetric_difference, areas.union_,
                      areas.intersection);
  return text;
}

void write_ruled_interior_json(const std::string& path, const RuledInteriorReport& report,
                               const std::function<double()>& seconds_so_far) {
  const Regions& result = report.result;
  const Areas areas = result.areas(report.rule);
  JsonFile json(path, "interior");
  json.member("inputs", inputs_json(report.inputs, result));
  json.member("options", {{"method", "regions"}, {"rule", name(report.rule)}});
  json.member("rule", name(report.rule));
  json.member("arrangement", arrangement_json(result.counts()));
  list_windings(json, result);
  json.member("q1", areas.symmetric_difference);
  json.member("q2", areas.union_);
  json.member("q3", areas.intersection);
  json.member("areas", areas_json(areas));
  json.member("error", region_errors_json(result, report.rule));
  json.member("statistics", region_statistics_json(result.counts()));
  Json seconds{{"read", report.read_seconds}};
  seconds.update(region_timing_json(result.timing()));
  seconds["total"] = seconds_so_far();
  json.finish(seconds);
}

}  // namespace lober::cli

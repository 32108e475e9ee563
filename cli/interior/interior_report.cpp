#include "cli/interior/interior_report.hpp"

#include <spdlog/fmt/fmt.h>

#include "cli/report/agreement_report.hpp"
#include "cli/report/json_file.hpp"

namespace lober::cli {
namespace {

const char* method_name(InteriorMethod method) {
  return method == InteriorMethod::split ? "split" : "ends";
}

std::string method_text(const InteriorReport& report) {
  const InteriorOptions& options = report.options;
  if (options.method == InteriorMethod::split) return "segments are split where the curves meet";
  if (options.passes == 0 || options.points == 0) return "a segment counts by its two ends";
  return fmt::format("a segment counts by its two ends; {} where they differ, {} with {}",
                     counted(report.result.statistics.points_inserted, "point inserted", "points inserted"),
                     counted(static_cast<std::size_t>(options.passes), "pass", "passes"), options.points);
}

Json error_json(const InteriorReport& report) {
  Json error{{"rounding", areas_json(report.result.rounding)}};
  Json meaning{{"rounding", report.splitting ? "bound on what the sums lose in double-double"
                                             : "bound on |area - exact area of the polygons as given|"}};
  if (report.splitting) {
    error["splitting"] = areas_json(*report.splitting);
    meaning["splitting"] = "|area - area with segments split where the curves meet|";
  }
  if (report.consistency) {
    error["consistency"] = areas_json(*report.consistency);
    meaning["consistency"] = "|area - area by the overlay|";
  }
  error["meaning"] = std::move(meaning);
  return error;
}

Json statistics_json(const InteriorStatistics& statistics) {
  Json object{{"index", name(statistics.index)},
              {"arcs", statistics.arcs},
              {"queries", statistics.queries},
              {"points_inserted", statistics.points_inserted}};
  object.update(counts_json(statistics.counts));
  object["simple_check"] = simple_check_json(statistics.simple_check, statistics.simple_check_pairs);
  return object;
}

}  // namespace

MeasuredAreas measure_areas(const IndexedCurve& c1, const IndexedCurve& c2, const InteriorOptions& options) {
  MeasuredAreas measured{interior_areas(c1, c2, options), std::nullopt};
  if (options.method != InteriorMethod::split) {
    InteriorOptions split = options;
    split.method = InteriorMethod::split;
    split.check_simple = false;
    split.progress = {};
    measured.splitting = distance(measured.result.areas, interior_areas(c1, c2, split).areas);
  }
  return measured;
}

std::string interior_table(const InteriorReport& report) {
  const InteriorAreas& result = report.result;
  std::string text = agreement_text(report.agreement);
  text += inputs_text(report.inputs, {result.orientation1, result.orientation2});
  text += fmt::format("\n{}\n{}\n", meetings_text(result.nodes), method_text(report));
  text += fmt::format("\n{:<16} {:>23}  {:>10}{}{}\n", "area of", "", "+- rounding",
                      report.splitting ? "   splitting" : "", report.consistency ? " consistency" : "");
  for (const NamedArea& area : named_areas) {
    text += fmt::format("{:<16} {:>23.16g}  {:>11.1e}", area.label, result.areas.*area.member,
                        result.rounding.*area.member);
    if (report.splitting) text += fmt::format(" {:>11.1e}", (*report.splitting).*area.member);
    if (report.consistency) text += fmt::format(" {:>11.1e}", (*report.consistency).*area.member);
    text += "\n";
  }
  text += fmt::format("\nQ1 {:.16g}, Q2 {:.16g}, Q3 {:.16g}; delta {:.1e} (zero by algebra, no error bar)\n", result.q1,
                      result.q2, result.q3, result.delta);
  return text;
}

void write_interior_json(const std::string& path, const InteriorReport& report,
                         const std::function<double()>& seconds_so_far) {
  const InteriorAreas& result = report.result;
  JsonFile json(path, "interior");
  json.member("inputs", Json::array({input_json(report.inputs[0], result.areas.c1, result.orientation1),
                                     input_json(report.inputs[1], result.areas.c2, result.orientation2)}));
  json.member("options", {{"method", method_name(report.options.method)},
                          {"passes", report.options.passes},
                          {"points", report.options.points},
                          {"check_simple", report.options.check_simple}});
  json.member("crossings", meetings_json(result.nodes));
  json.member("q1", result.q1);
  json.member("q2", result.q2);
  json.member("q3", result.q3);
  json.member("areas", areas_json(result.areas));
  json.member("delta", result.delta);
  json.member("error", error_json(report));
  if (report.consistency) {
    add_agreement(json, report.agreement);
  }
  json.member("statistics", statistics_json(result.statistics));
  const InteriorTiming& timing = result.timing;
  json.finish({{"read", report.read_seconds},
               {"index", report.index_seconds},
               {"check", timing.check},
               {"crossings", timing.crossings},
               {"order", timing.order},
               {"labels", timing.labels},
               {"sums", timing.sums},
               {"verify", report.verify_seconds},
               {"total", seconds_so_far()}});
}

}  // namespace lober::cli

#include "cli/densify/densify_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <array>

#include "cli/report/json_file.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

Json options_json(const DensifySteps& steps) {
  Json options{{"interpolation", name(steps.interpolation)}, {"max_points", steps.max_points}};
  if (steps.simplify) {
    options["simplify"] = {{"tolerance", steps.simplify->tolerance},
                           {"max_length", number_json(steps.simplify->max_length)}};
  }
  if (steps.criteria) {
    options["criteria"] = {{"max_length", number_json(steps.criteria->max_length)},
                           {"alpha", number_json(steps.criteria->angle)},
                           {"distance_angle", number_json(steps.criteria->distance_angle)},
                           {"min_length", steps.criteria->min_length}};
  }
  if (steps.passes > 0) options["near"] = {{"passes", steps.passes}, {"points", steps.points}};
  options["crossings"] = steps.crossings;
  return options;
}

Json diagnostic_counts_json(const DensifyReport& report) {
  Json counts = Json::object();
  for (std::size_t k = 0; k < report.diagnostic_counts.size(); ++k) {
    if (report.diagnostic_counts[k] != 0) {
      counts[std::string(name(static_cast<DiagnosticCause>(k)))] = report.diagnostic_counts[k];
    }
  }
  return counts;
}

void write_diagnostics(detail::OutputFile& file, const DensifyReport& report) {
  std::string text;
  append_all(text, "\"diagnostics\": {\"counts\":", dumped(diagnostic_counts_json(report)), ",\"list\":[");
  for (std::size_t k = 0; k < report.diagnostics.size(); ++k) {
    const Diagnostic& diagnostic = report.diagnostics[k];
    append_all(text, k == 0 ? "\n  " : ",\n  ", "{\"segment\":", diagnostic.first, ",\"count\":", diagnostic.count,
               ",\"cause\":\"", name(diagnostic.cause), "\"}");
    if (text.size() > (std::size_t{1} << 20)) {
      file.write(text);
      text.clear();
    }
  }
  file.write(text + "]},\n");
}

}  // namespace

std::string densify_summary(const DensifyReport& report) {
  std::string text = fmt::format("{:<20} {:>12} points\n", "given", report.inputs[0].curve.points.size());
  for (const NamedCurve& input : report.inputs) {
    if (!input.remark.empty()) text += input.file + " " + input.remark + "\n";
  }
  for (const DensifyReport::Step& step : report.done) {
    text += fmt::format("{:<20} {:>12} points  {} {}\n", step.name, step.points, step.rounds,
                        step.rounds == 1 ? "round" : "rounds");
  }
  for (std::size_t k = 0; k < report.diagnostic_counts.size(); ++k) {
    if (report.diagnostic_counts[k] == 0) continue;
    text += fmt::format("criteria not met     {:>12} places  ({})\n", report.diagnostic_counts[k],
                        name(static_cast<DiagnosticCause>(k)));
  }
  return text;
}

void write_densify_json(const std::string& path, const DensifyReport& report,
                        const std::function<double()>& seconds_so_far) {
  JsonFile json(path, "densify");
  Json inputs = Json::array();
  for (const NamedCurve& input : report.inputs) {
    inputs.push_back({{"file", input.file},
                      {"zone", input.zone},
                      {"sha256", input.sha256},
                      {"points", input.curve.points.size()},
                      {"closed", input.curve.closed}});
  }
  Json steps = Json::array();
  for (const DensifyReport::Step& step : report.done) {
    steps.push_back({{"step", step.name}, {"points", step.points}, {"rounds", step.rounds}});
  }
  json.member("inputs", inputs);
  json.member("options", options_json(report.steps));
  json.member("steps", steps);
  json.member("result", {{"points", report.result.points.size()}, {"closed", report.result.closed}});
  write_diagnostics(json.file(), report);
  json.finish({{"read", report.timing.read},
               {"densify", report.timing.densify},
               {"write", report.timing.write},
               {"total", seconds_so_far()}});
}

}  // namespace lober::cli

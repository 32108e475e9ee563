#include "cli/densify/densify_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <array>

#include "cli/report/json_file.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

// Criteria that are off are infinite, which JSON cannot say.
Json number(double value) {
  return value < Criteria::off ? Json(value) : Json(nullptr);
}

Json options_json(const DensifySteps& steps) {
  Json options{{"interpolation", name(steps.interpolation)}, {"max_points", steps.most_points}};
  if (steps.thin) {
    options["simplify"] = {{"tolerance", steps.thin->tolerance}, {"max_length", number(steps.thin->longest)}};
  }
  if (steps.criteria) {
    options["criteria"] = {{"max_length", number(steps.criteria->longest)},
                           {"alpha", number(steps.criteria->angle)},
                           {"distance_angle", number(steps.criteria->distance_angle)},
                           {"min_length", steps.criteria->shortest}};
  }
  if (steps.passes > 0) options["near"] = {{"passes", steps.passes}, {"points", steps.points}};
  options["crossings"] = steps.crossings;
  return options;
}

Json flaw_counts_json(const DensifyReport& report) {
  Json counts = Json::object();
  for (std::size_t k = 0; k < report.flaw_counts.size(); ++k) {
    if (report.flaw_counts[k] != 0) {
      counts[std::string(name(static_cast<FlawCause>(k)))] = report.flaw_counts[k];
    }
  }
  return counts;
}

void write_flaws(OutputFile& file, const DensifyReport& report) {
  std::string text;
  append_all(text, "\"flaws\": {\"counts\":", dumped(flaw_counts_json(report)), ",\"list\":[");
  for (std::size_t k = 0; k < report.flaws.size(); ++k) {
    const Flaw& flaw = report.flaws[k];
    append_all(text, k == 0 ? "\n  " : ",\n  ", "{\"segment\":", flaw.first, ",\"count\":", flaw.count, ",\"cause\":\"",
               name(flaw.cause), "\"}");
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
  for (const DensifyReport::Step& step : report.done) {
    text += fmt::format("{:<20} {:>12} points  {} {}\n", step.name, step.points, step.rounds,
                        step.rounds == 1 ? "round" : "rounds");
  }
  for (std::size_t k = 0; k < report.flaw_counts.size(); ++k) {
    if (report.flaw_counts[k] == 0) continue;
    text += fmt::format("criteria not met     {:>12} places  ({})\n", report.flaw_counts[k],
                        name(static_cast<FlawCause>(k)));
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
  write_flaws(json.file(), report);
  json.finish({{"read", report.timing.read},
               {"densify", report.timing.densify},
               {"write", report.timing.write},
               {"total", seconds_so_far()}});
}

}  // namespace lober::cli

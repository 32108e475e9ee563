// The JSON object of `lober transport --manifolds`. Its members are a contract; more may be added, none renamed.

#include <algorithm>

#include "cli/report/agreement_report.hpp"
#include "cli/report/outcome_json.hpp"
#include "cli/transport/transport_report.hpp"

namespace lober::cli {
namespace {

Json measured_json(Measured value) {
  return {{"value", value.value}, {"error", value.error}};
}

Json regions_json(std::span<const Region> regions) {
  Json list = Json::array();
  for (const Region& region : regions) {
    list.push_back({{"bounded", region.bounded}, {"area", region.area.value}, {"error", region.area.error}});
  }
  return list;
}

Json error_json(std::span<const TransportStep> steps, Measured flux12, Measured flux21) {
  double discretisation = 0, boundaries = 0, consistency = 0;
  for (const TransportStep& step : steps) {
    const Measured lobes = step.total(1, 0), other = step.by_boundaries(1, 0);
    discretisation = std::max(discretisation, lobes.error);
    boundaries = std::max(boundaries, other.error);
    consistency = std::max(consistency, std::abs(lobes.value - other.value));
  }
  return {
      {"discretisation", discretisation},
      {"boundaries", boundaries},
      {"consistency", consistency},
      {"area_conservation", std::abs(flux12.value - flux21.value)},
      {"meaning",
       {{"discretisation", "estimate of |T - true T| by lobes, integration and rounding included; of the worst step"},
        {"boundaries", "the same by boundaries"},
        {"consistency", "|T by lobes - T by boundaries|; of the worst step"},
        {"area_conservation", "|flux12 - flux21| of the turnstile, by geometry"}}}};
}

}  // namespace

void write_transport_json(const std::string& path, const CurvesTransportReport& report,
                          const std::function<double()>& seconds_so_far) {
  const TransportOfCurves& result = report.result;
  JsonFile json(path, "transport");
  add_agreement(json, result.agreement);
  Json inputs = Json::array();
  for (const NamedCurve& input : report.inputs)
    inputs.push_back({{"file", spec_of(input)}, {"points", input.curve.points.size()}});
  json.member("inputs", inputs);
  json.member("period", report.tangle->images.period);
  json.member("regions", regions_json(result.regions));
  json.member("turnstile", Json{{"flux12", measured_json(result.flux12)},
                                {"flux21", measured_json(result.flux21)},
                                {"lobe_area12", measured_json(result.lobe_area12)},
                                {"lobe_area21", measured_json(result.lobe_area21)}});
  const operations::Field& steps = field_at(operations::named("transport").result, "steps");
  json.list("steps", result.steps.size(),
            [&](std::string& text, std::size_t k) { text += json_object(steps.members, &result.steps[k]); });
  json.member("stop", result.limit.empty()
                          ? Json()
                          : Json{{"reason", "curves"}, {"why", rows_text(report) + ": " + result.limit}});
  json.member("remarks", result.remarks);
  json.member("error", error_json(result.steps, result.flux12, result.flux21));
  json.finish({{"total", seconds_so_far()}});
}

}  // namespace lober::cli

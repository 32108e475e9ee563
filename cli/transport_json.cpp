// The JSON object of `lober transport`. Its members are a contract; more may be added, none renamed.

#include <algorithm>

#include "cli/json_file.hpp"
#include "cli/transport_report.hpp"
#include "cli/turnstile_report.hpp"

namespace lober::cli {
namespace {

Json options_json(const TransportReport& report) {
  const Connection& connection = report.connection;
  return {{"iterates", report.options.iterates},
          {"tolerance", report.options.tolerance},
          {"from", point_json(connection.from)},
          {"to", point_json(connection.to)},
          {"u_direction", point_json(connection.u_direction)},
          {"s_direction", point_json(connection.s_direction)},
          {"bip", connection.bip ? point_json(*connection.bip) : Json()}};
}

Json region_json(const TransportReport& report) {
  const Boundary& boundary = *report.tangle().boundary;
  return {{"area", boundary.crosses_itself ? Json() : Json(report.result.region)},
          {"crosses_itself", boundary.crosses_itself},
          {"bip", point_json(report.manifolds().orbits.back().at)},
          {"orientation", boundary.orientation > 0 ? "counter_clockwise" : "clockwise"}};
}

Json all_turnstile_json(const TransportReport& report) {
  Json json = turnstile_json(report.manifolds());
  json["area12"] = report.result.area12;
  json["area21"] = report.result.area21;
  json["action12"] = report.result.action12;
  json["action21"] = report.result.action21;
  return json;
}

Json error_json(const Transport& result) {
  double discretisation = 0, boundaries = 0, consistency = 0;
  for (const TransportStep& step : result.steps) {
    discretisation = std::max(discretisation, step.discretisation);
    boundaries = std::max(boundaries, step.boundary_error);
    consistency = std::max(consistency, step.consistency);
  }
  return {{"discretisation", discretisation},
          {"boundaries", boundaries},
          {"consistency", consistency},
          {"area_conservation", std::abs(result.area12 - result.area21)},
          {"meaning",
           {{"discretisation", "estimate of |T - true T| by lobes; of the worst step"},
            {"boundaries", "the same by boundaries"},
            {"consistency", "|T by lobes - T by boundaries|; of the worst step"},
            {"area_conservation", "|area12 - area21| of the turnstile, by geometry"}}}};
}

Json statistics_json(const TransportReport& report) {
  const ManifoldTangle& manifolds = report.manifolds();
  Json json{{"points", {manifolds.u.points.size(), manifolds.s.points.size()}},
            {"images", {manifolds.u.images, manifolds.s.images}},
            {"pips", manifolds.tangle.pips.size()}};
  json.update(meetings_json(manifolds.tangle.nodes));
  return json;
}

void format_step(std::string& text, const TransportStep& step) {
  put(text, "{\"n\":", step.n, ",\"a\":", step.flux, ",\"T\":", step.total, ",\"overlap\":", step.overlap,
      ",\"discretisation\":", step.discretisation, ",\"T_by_boundaries\":", step.by_boundaries,
      ",\"boundary_error\":", step.boundary_error, ",\"consistency\":", step.consistency, "}");
}

}  // namespace

void write_transport_json(const std::string& path, const TransportReport& report,
                          const std::function<double()>& seconds_so_far) {
  JsonFile json(path, "transport");
  json.member("system", system_json(report.system, report.integration));
  json.member("options", options_json(report));
  json.member("saddles", saddles_json(report.manifolds()));
  json.member("region", region_json(report));
  json.member("turnstile", all_turnstile_json(report));
  json.list("steps", report.result.steps.size(),
            [&](std::string& text, std::size_t k) { format_step(text, report.result.steps[k]); });
  json.member("remarks", report.tangle().remarks);
  json.member("error", error_json(report.result));
  json.member("statistics", statistics_json(report));
  json.finish({{"transport", report.timing.transport}, {"write", report.timing.write}, {"total", seconds_so_far()}});
}

}  // namespace lober::cli

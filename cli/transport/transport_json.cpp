// The JSON object of `lober transport`. Its members are a contract; more may be added, none renamed.

#include <algorithm>

#include "cli/report/agreement_report.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/turnstile_report.hpp"
#include "cli/transport/transport_report.hpp"

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

Json measured_json(Measured value) {
  return {{"value", value.value}, {"error", value.error}};
}

Json region_json(const TransportReport& report) {
  const Boundary& boundary = *report.tangle().boundary;
  const Region& region = report.result.regions.front();
  return {{"area", region.area.value},
          {"error", region.area.error},
          {"crosses_itself", boundary.crosses_itself},
          {"bip", point_json(report.manifolds().orbits.back().at)},
          {"orientation", boundary.orientation > 0 ? "counter_clockwise" : "clockwise"}};
}

Json regions_json(std::span<const Region> regions) {
  Json list = Json::array();
  for (const Region& region : regions) {
    list.push_back({{"bounded", region.bounded}, {"area", region.area.value}, {"error", region.area.error}});
  }
  return list;
}

Json all_turnstile_json(const TransportBoundary& boundary) {
  Json json = turnstile_json(*boundary.manifolds);
  json["flux12"] = boundary.flux12.value;
  json["flux21"] = boundary.flux21.value;
  json["flux12_error"] = boundary.flux12.error;
  json["flux21_error"] = boundary.flux21.error;
  json["lobe_area12"] = boundary.lobe_area12.value;
  json["lobe_area21"] = boundary.lobe_area21.value;
  json["lobe_area12_error"] = boundary.lobe_area12.error;
  json["lobe_area21_error"] = boundary.lobe_area21.error;
  json["lobe_area12_by_action"] = boundary.lobe_area12_by_action;
  json["lobe_area21_by_action"] = boundary.lobe_area21_by_action;
  return json;
}

Json boundaries_json(const Transport& result) {
  Json list = Json::array();
  for (const TransportBoundary& boundary : result.boundaries) {
    list.push_back({{"saddles", saddles_json(*boundary.manifolds)},
                    {"turnstile", all_turnstile_json(boundary)},
                    {"point_error", boundary.point_error}});
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

Json statistics_json(const TransportReport& report) {
  const ManifoldTangle& manifolds = report.manifolds();
  Json json{{"points", {manifolds.u.points.size(), manifolds.s.points.size()}},
            {"images", {manifolds.u.images, manifolds.s.images}},
            {"pips", manifolds.tangle.pips.size()}};
  json.update(meetings_json(manifolds.tangle.nodes));
  return json;
}

void format_matrix(std::string& text, const char* name, const RegionMatrix& matrix) {
  put(text, ",\"", name, "\":[");
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    put(text, i == 0 ? "[" : ",[");
    for (std::size_t j = 0; j < matrix.size(); ++j) put(text, j == 0 ? "" : ",", matrix(i, j).value);
    put(text, "]");
  }
  put(text, "],\"", name, "_error\":[");
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    put(text, i == 0 ? "[" : ",[");
    for (std::size_t j = 0; j < matrix.size(); ++j) put(text, j == 0 ? "" : ",", matrix(i, j).error);
    put(text, "]");
  }
  put(text, "]");
}

// Of the first two regions, `a` and `T` of what enters the first one; then the matrices of all.
void format_step(std::string& text, const TransportStep& step) {
  const Measured in = step.total(1, 0), boundaries = step.by_boundaries(1, 0);
  const auto overlap = [&](std::size_t i, std::size_t j) { return step.overlaps[i][j].value; };
  put(text, "{\"n\":", step.n, ",\"a\":", step.flux(1, 0).value, ",\"T\":", in.value, ",\"overlap\":", overlap(0, 1),
      ",\"discretisation\":", in.error, ",\"T_by_boundaries\":", boundaries.value,
      ",\"boundary_error\":", boundaries.error, ",\"consistency\":", std::abs(in.value - boundaries.value));
  put(text, ",\"a_error\":", step.flux(1, 0).error, ",\"a12\":", step.flux(0, 1).value,
      ",\"a21\":", step.flux(1, 0).value, ",\"T12\":", step.total(0, 1).value, ",\"T21\":", in.value,
      ",\"overlaps\":{\"L12_L12\":", overlap(0, 0), ",\"L12_L21\":", overlap(0, 1), ",\"L21_L12\":", overlap(1, 0),
      ",\"L21_L21\":", overlap(1, 1), "}");
  if (step.by_particles.size() > 0) {
    put(text, ",\"T_by_particles\":", step.by_particles(1, 0).value,
        ",\"particle_error\":", step.by_particles(1, 0).error);
  }
  format_matrix(text, "a_ij", step.flux);
  format_matrix(text, "T_ij", step.total);
  format_matrix(text, "T_ij_by_boundaries", step.by_boundaries);
  if (step.by_particles.size() > 0) format_matrix(text, "T_ij_by_particles", step.by_particles);
  put(text, "}");
}

}  // namespace

void write_transport_json(const std::string& path, const TransportReport& report,
                          const std::function<double()>& seconds_so_far) {
  const Transport& result = report.result;
  const TransportBoundary& first = result.boundaries.front();
  JsonFile json(path, "transport");
  add_agreement(json, result.agreement);
  json.member("system", system_json(report.system, report.integration));
  json.member("options", options_json(report));
  json.member("saddles", saddles_json(report.manifolds()));
  json.member("region", region_json(report));
  json.member("regions", regions_json(result.regions));
  json.member("turnstile", all_turnstile_json(first));
  json.member("boundaries", boundaries_json(result));
  if (report.melnikov) json.member("melnikov", melnikov_json(*report.melnikov));
  json.member("iterates_a_step", result.iterates_a_step);
  json.list("steps", result.steps.size(),
            [&](std::string& text, std::size_t k) { format_step(text, result.steps[k]); });
  json.member("remarks", result.remarks);
  json.member("error", error_json(result.steps, first.flux12, first.flux21));
  json.member("statistics", statistics_json(report));
  json.finish({{"transport", report.timing.transport}, {"write", report.timing.write}, {"total", seconds_so_far()}});
}

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
  json.list("steps", result.steps.size(),
            [&](std::string& text, std::size_t k) { format_step(text, result.steps[k]); });
  json.member("stop", result.limit.empty()
                          ? Json()
                          : Json{{"reason", "curves"}, {"why", rows_text(report) + ": " + result.limit}});
  json.member("remarks", result.remarks);
  json.member("error", error_json(result.steps, result.flux12, result.flux21));
  json.finish({{"total", seconds_so_far()}});
}

}  // namespace lober::cli

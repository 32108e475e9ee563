// The JSON object of `lober tangle`. Its members are a contract; more may be added, none renamed.

#include <cstdlib>

#include "cli/report/agreement_report.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/turnstile_report.hpp"
#include "cli/tangle/tangle_report.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::cli {
namespace {

Json manifold_json(const TangleReport& report, std::size_t k) {
  const NamedCurve& input = report.inputs[k];
  if (report.origin) return {{"grown", input.file}, {"points", input.curve.points.size()}};
  return {{"file", input.file},
          {"zone", input.zone},
          {"sha256", input.sha256},
          {"points", input.curve.points.size()},
          {"reversed", report.reversed[k]}};
}

Json options_json(const TangleReport& report) {
  const TangleOptions& options = report.options;
  Json bip;
  if (options.bip) bip = *options.bip;
  if (options.bip_near) bip = {options.bip_near->x, options.bip_near->y};
  return {{"index", name(options.index)},
          {"bip", std::move(bip)},
          {"period", options.period == 0 ? Json() : Json(options.period)},
          {"overlaps", report.overlaps.has_value()},
          {"smooth", options.smooth},
          {"check_simple", options.check_simple}};
}

void put_position(std::string& text, Position at) {
  put(text, "{\"segment\":", at.segment, ",\"t\":", at.t, "}");
}

void format_pip(std::string& text, const Pip& pip) {
  put(text, "{\"x\":", pip.at.x, ",\"y\":", pip.at.y, ",\"u\":");
  put_position(text, pip.u);
  put(text, ",\"s\":");
  put_position(text, pip.s);
  put(text, ",\"rho\":", pip.rho, ",\"crossing\":", pip.node, "}");
}

// A label, quoted, or null.
std::string label_json(const LobeLabel& label) {
  const std::string letters = text(label);
  return letters.empty() ? "null" : "\"" + letters + "\"";
}

void format_lobe(std::string& text, const TangleReport& report, std::size_t k) {
  const Lobe& lobe = report.result.lobes[k];
  const LobeShape& shape = report.shapes[k];
  put(text, "{\"index\":", k, ",\"area\":", lobe.area, ",\"inside\":", lobe.inside, ",\"outside\":", lobe.outside,
      ",\"perimeter\":", shape.perimeter, ",\"simple\":", lobe.simple ? "true" : "false",
      ",\"label\":", label_json(report.result.images.labels[k]), ",\"width\":", shape.width, ",\"centroid\":[",
      shape.centroid.x, ",", shape.centroid.y, "],\"rounding\":", report.result.rounding(lobe.area),
      ",\"discretisation\":", discretisation(report, k));
  if (report.options.smooth) put(text, ",\"polygon_area\":", lobe.polygon_area);
  if (!lobe.simple) {
    put(text, ",\"pieces\":[");
    const std::vector<double> pieces = lobe_pieces(report.result, k);
    for (std::size_t m = 0; m < pieces.size(); ++m) put(text, m == 0 ? "" : ",", pieces[m]);
    put(text, "]");
  }
  put(text, "}");
}

Json bip_json(const Tangle& result) {
  if (!result.boundary) return nullptr;
  const std::size_t bip = result.boundary->bip;
  return {{"index", bip}, {"x", result.pips[bip].at.x}, {"y", result.pips[bip].at.y}};
}

Json boundary_json(const Tangle& result) {
  if (!result.boundary) return nullptr;
  Json closure = Json::array();
  for (const Point corner : result.closure) closure.push_back(point_json(corner));
  return {{"area", result.boundary->area},
          {"points", boundary_outline(result).size()},
          {"orientation", result.boundary->orientation > 0 ? "counter_clockwise" : "clockwise"},
          {"crosses_itself", result.boundary->crosses_itself},
          {"closure", std::move(closure)}};
}

Json images_json(const Images& images) {
  Json object{{"period", images.period == 0 ? Json() : Json(images.period)}, {"given", images.given}};
  object["reason"] = images.reason.empty() ? Json() : Json(images.reason);
  object["compared"] = images.compared;
  return object;
}

// The lobes between f^-1(bip) and the bip, or why they are not known.
Json turnstile_lobes_json(const Images& images) {
  Json lobes = Json::array();
  for (std::size_t k = images.turnstile_begin; k < images.turnstile_end; ++k) lobes.push_back(k);
  const bool known = !lobes.empty();
  Json reason;
  if (images.period == 0) {
    reason = images.reason;
  } else if (!known) {
    reason = "fewer pips before the bip than from a pip to its image";
  }
  return {{"lobes", std::move(lobes)},
          {"lobe_area12", known ? Json(images.lobe_area12) : Json()},
          {"lobe_area21", known ? Json(images.lobe_area21) : Json()},
          {"reason", std::move(reason)}};
}

Json error_json(const TangleReport& report) {
  const TangleErrors errors = errors_of(report);
  const Images& images = report.result.images;
  const bool boundary = report.result.boundary.has_value(), paired = images.period != 0;
  return {
      {"rounding", {{"lobe", errors.lobe_rounding}, {"boundary", boundary ? Json(errors.boundary_rounding) : Json()}}},
      {"discretisation",
       {{"lobe", errors.lobe_discretisation}, {"boundary", boundary ? Json(errors.boundary_discretisation) : Json()}}},
      {"consistency",
       {{"inside_plus_outside", errors.split},
        {"area_change", paired && images.compared > 0 ? Json(images.area_change) : Json()},
        {"turnstile_sum", paired ? Json(images.turnstile_sum) : Json()}}},
      {"meaning",
       {{"rounding", "bound on |area - exact area of the polygons as given|; of the worst lobe"},
        {"discretisation", report.options.smooth
                               ? "estimate of |area - area between the smooth curves|; of the worst lobe"
                               : "estimate of |area of the polygon - area between smooth curves through the same "
                                 "points|; of the worst lobe"},
        {"inside_plus_outside", "largest | |area| - inside - outside | of a lobe"},
        {"area_change",
         "largest difference in signed area of a lobe and its image, relative to the mean lobe; 0 if the map "
         "preserves area"},
        {"turnstile_sum",
         "largest sum of signed areas from a pip to its image, relative to the mean lobe; likewise"}}}};
}

Json statistics_json(const TangleReport& report) {
  const Tangle& result = report.result;
  Json object{{"index", name(result.index)}};
  if (report.options.smooth) {
    object["fallback_segments"] = result.fallback_segments;
    object["fallback_pips"] = result.fallback_pips;
  }
  object.update(counts_json(result.nodes.counts()));
  object["simple_check"] = simple_check_json(result.simple_check.search, result.simple_check.pairs);
  return object;
}

}  // namespace

void write_tangle_json(const std::string& path, TangleReport& report, const std::function<double()>& seconds_so_far) {
  const detail::Stopwatch watch;
  const Tangle& result = report.result;
  JsonFile json(path, "tangle");
  json.member("inputs", Json::array({manifold_json(report, 0), manifold_json(report, 1)}));
  if (report.origin) {
    const TangleOrigin& origin = *report.origin;
    json.member("system", system_json(origin.system, origin.integration));
    json.member("tolerance", origin.tolerance);
    json.member("saddles", saddles_json(*origin.manifolds));
    const LocalManifold& local = origin.manifolds->local_u;
    json.member("reflection", local.multiplier < 0);
    json.member("steps_of_image", std::abs(local.image().steps));
    json.member("turnstile_by_action", turnstile_json(*origin.manifolds));
  }
  add_agreement(json, report.agreement);
  json.member("options", options_json(report));
  json.member("crossings", meetings_json(result.nodes));
  json.list("pips", result.pips.size(), [&](std::string& text, std::size_t k) { format_pip(text, result.pips[k]); });
  json.list("lobes", result.lobes.size(), [&](std::string& text, std::size_t k) { format_lobe(text, report, k); });
  json.member("bip", bip_json(result));
  json.member("boundary", boundary_json(result));
  json.member("images", images_json(result.images));
  json.member("turnstile", turnstile_lobes_json(result.images));
  if (report.overlaps) {
    json.list("overlaps", report.overlaps->size(), [&](std::string& text, std::size_t k) {
      const LobeOverlap& both = (*report.overlaps)[k];
      put(text, "{\"i\":", both.i, ",\"j\":", both.j, ",\"area\":", both.area, "}");
    });
  } else {
    json.member("overlaps", nullptr);  // not asked for
  }
  json.member("remarks", result.remarks);
  json.member("error", error_json(report));
  json.member("statistics", statistics_json(report));
  TangleReportTiming& own = report.timing;
  const TangleTiming& timing = result.timing;
  own.write += watch.seconds();
  const Json seconds{
      {"read", own.read},         {"index", timing.index},    {"check", timing.check}, {"crossings", timing.crossings},
      {"order", timing.order},    {"pips", timing.pips},      {"areas", timing.areas}, {"tangle", timing.total},
      {"measures", own.measures}, {"overlaps", own.overlaps}, {"write", own.write},    {"total", seconds_so_far()}};
  json.finish(seconds);
}

}  // namespace lober::cli

#include "cli/grow/grow_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <cstdlib>

#include "cli/program/system_options.hpp"
#include "cli/report/growth_diagnostics.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

std::string_view growth_cause_text(GrowthDiagnosticCause cause) {
  switch (cause) {
    case GrowthDiagnosticCause::failed:
      return "the map fails between their ends, which are joined by a straight line";
    case GrowthDiagnosticCause::spacing:
      return "the tolerance is not met, and their ends lie as close as rounding allows";
    case GrowthDiagnosticCause::max_rounds:
      return "the tolerance is not met";
    case GrowthDiagnosticCause::left_box:
      return "outside of the box, where the manifold is followed coarsely";
  }
  return {};
}

Json options_json(const GrowReport& report) {
  const GrowthOptions& options = report.options;
  Json json{{"side", report.local.side == ManifoldSide::unstable ? "unstable" : "stable"},
            {"branch", report.branch == Branch::plus ? "+" : "-"},
            {"tolerance", options.tolerance},
            {"iterates", options.iterates < 0 ? Json(nullptr) : Json(options.iterates)},
            {"length", number_json(options.length)},
            {"max_points", options.max_points}};
  if (!options.box.empty()) {
    json["box"] = {options.box.min_x, options.box.min_y, options.box.max_x, options.box.max_y};
  }
  return json;
}

Json local_json(const LocalManifold& local) {
  return {{"saddle", point_json(local.saddle)},
          {"tangent", point_json(local.tangent)},
          {"multiplier", local.multiplier},
          {"reflection", local.multiplier < 0},
          {"steps_of_image", std::abs(local.image().steps)},
          {"degree", local.coefficients.size() - 1},
          {"reach", local.reach},
          {"defect", local.defect},
          {"defect_across", local.defect_across}};
}

Json result_json(const GrownManifold& manifold) {
  Json generations = Json::array();
  for (std::size_t k = 0; k + 1 < manifold.generation_begin.size(); ++k) {
    generations.push_back(manifold.generation_begin[k]);
  }
  return {{"points", manifold.points.size()},
          {"length", manifold.length},
          {"iterates", manifold.generation_begin.size() - 2},
          {"stop", name(manifold.stop)},
          {"generations", generations},
          {"images", manifold.images}};
}

void write_diagnostics(detail::OutputFile& file, const GrownManifold& manifold) {
  Json counts = Json::object();
  for (const GrowthDiagnosticCause cause : growth_causes) {
    if (const std::size_t count = segments_with(manifold.diagnostics, cause)) counts[std::string(name(cause))] = count;
  }
  std::string text;
  append_all(text, "\"diagnostics\": {\"counts\":", dumped(counts), ",\"list\":[");
  for (std::size_t k = 0; k < manifold.diagnostics.size(); ++k) {
    const GrowthDiagnostic& diagnostic = manifold.diagnostics[k];
    const Point at = manifold.points[diagnostic.first];
    append_all(text, k == 0 ? "\n  " : ",\n  ", "{\"segment\":", diagnostic.first, ",\"count\":", diagnostic.count,
               ",\"cause\":\"", name(diagnostic.cause), "\",\"at\":[", at.x, ",", at.y, "]}");
    if (text.size() > (std::size_t{1} << 20)) {
      file.write(text);
      text.clear();
    }
  }
  file.write(text + "]},\n");
}

}  // namespace

bool ends_as_asked(const GrowReport& report) {
  return report.manifold.stop == GrowthStop::iterates || report.manifold.stop == GrowthStop::length;
}

std::string end_of_growth(const GrowReport& report) {
  switch (report.manifold.stop) {
    case GrowthStop::iterates:
      return "after the iterates asked for";
    case GrowthStop::length:
      return "at the length asked for";
    case GrowthStop::points:
      return "at a limit, of --max-points or --memory, before what was asked for";
    case GrowthStop::ended:
      return "in another fixed point: two iterates added less than the tolerance";
    case GrowthStop::failed:
      return "early: no point of the last iterate has an image in the box";
    case GrowthStop::cancelled:
      return "early: it was interrupted";
  }
  return {};
}

std::string grow_summary(const GrowReport& report) {
  const LocalManifold& local = report.local;
  const GrownManifold& manifold = report.manifold;
  std::string text = system_text(report.system) + "\n";
  text +=
      fmt::format("manifold             {}, branch {}\n", local.side == ManifoldSide::unstable ? "unstable" : "stable",
                  report.branch == Branch::plus ? "+" : "-");
  text += fmt::format("saddle               ({:.15g}, {:.15g})\n", local.saddle.x, local.saddle.y);
  text += fmt::format("multiplier           {:.15g}\n", local.multiplier);
  if (local.multiplier < 0) {
    text += fmt::format(
        "reflection           both multipliers are negative: images are those of f^{}, which keeps the branch\n",
        std::abs(local.image().steps));
  }
  text += fmt::format("local manifold       reach {:.4g}, defect {:.2g}\n", local.reach, local.defect);
  text +=
      fmt::format("grown                {} points, length {:.10g}: the local manifold and {}\n", manifold.points.size(),
                  manifold.length, counted(manifold.generation_begin.size() - 2, "image of it", "images of it"));
  text += fmt::format("growing ended        {}\n", end_of_growth(report));
  for (const GrowthDiagnosticCause cause : growth_causes) {
    const std::size_t count = segments_with(manifold.diagnostics, cause);
    if (count == 0) continue;
    const Point at = first_point_with(manifold, cause);
    text += fmt::format("{:<20} {}, the first at ({:.6g}, {:.6g}): {}\n", name(cause),
                        counted(count, "segment", "segments"), at.x, at.y, growth_cause_text(cause));
  }
  return text;
}

void write_grow_json(const std::string& path, const GrowReport& report, const std::function<double()>& seconds_so_far) {
  JsonFile json(path, "grow");
  json.member("system", system_json(report.system, report.integration));
  json.member("options", options_json(report));
  json.member("local_manifold", local_json(report.local));
  json.member("result", result_json(report.manifold));
  write_diagnostics(json.file(), report.manifold);
  json.finish({{"local_manifold", report.timing.local},
               {"growth", report.timing.growth},
               {"write", report.timing.write},
               {"total", seconds_so_far()}});
}

}  // namespace lober::cli

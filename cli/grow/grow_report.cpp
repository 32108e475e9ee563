#include "cli/grow/grow_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <cstdlib>
#include <limits>

#include "cli/program/system_options.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr std::array causes{GrowthDiagnosticCause::failed, GrowthDiagnosticCause::spacing,
                            GrowthDiagnosticCause::max_rounds, GrowthDiagnosticCause::left_box};

// Segments with a diagnostic of this cause.
std::size_t with_diagnostic(const GrownManifold& manifold, GrowthDiagnosticCause cause) {
  std::size_t sum = 0;
  for (const GrowthDiagnostic& diagnostic : manifold.diagnostics)
    sum += diagnostic.cause == cause ? diagnostic.count : 0;
  return sum;
}

// What is off is infinite, which JSON cannot say.
Json number(double value) {
  return value < std::numeric_limits<double>::infinity() ? Json(value) : Json(nullptr);
}

Json options_json(const GrowReport& report) {
  const GrowthOptions& options = report.options;
  Json json{{"side", report.local.side == ManifoldSide::unstable ? "unstable" : "stable"},
            {"branch", report.branch == Branch::plus ? "+" : "-"},
            {"tolerance", options.tolerance},
            {"iterates", options.iterates < 0 ? Json(nullptr) : Json(options.iterates)},
            {"length", number(options.length)},
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
          {"stop", name(manifold.stop)},
          {"generations", generations},
          {"images", manifold.images}};
}

void write_diagnostics(detail::OutputFile& file, const GrownManifold& manifold) {
  Json counts = Json::object();
  for (const GrowthDiagnosticCause cause : causes) {
    if (const std::size_t count = with_diagnostic(manifold, cause)) counts[std::string(name(cause))] = count;
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

std::string grow_summary(const GrowReport& report) {
  const LocalManifold& local = report.local;
  const GrownManifold& manifold = report.manifold;
  std::string text = fmt::format("saddle               ({:.15g}, {:.15g})\n", local.saddle.x, local.saddle.y);
  text += fmt::format("multiplier           {:.15g}\n", local.multiplier);
  if (local.multiplier < 0) {
    text += fmt::format(
        "reflection           both multipliers are negative: images are those of f^{}, which keeps the branch\n",
        std::abs(local.image().steps));
  }
  text += fmt::format("local manifold       reach {:.4g}, defect {:.2g}\n", local.reach, local.defect);
  text +=
      fmt::format("grown                {} points, length {:.10g}, {} generations, stopped by {}\n",
                  manifold.points.size(), manifold.length, manifold.generation_begin.size() - 1, name(manifold.stop));
  for (const GrowthDiagnosticCause cause : causes) {
    const std::size_t count = with_diagnostic(manifold, cause);
    if (count == 0) continue;
    const auto first = std::find_if(manifold.diagnostics.begin(), manifold.diagnostics.end(),
                                    [&](const GrowthDiagnostic& diagnostic) { return diagnostic.cause == cause; });
    const Point at = manifold.points[first->first];
    text += fmt::format("{:<20} {} segments, the first at ({:.6g}, {:.6g})\n", name(cause), count, at.x, at.y);
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

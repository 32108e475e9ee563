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

constexpr std::array causes{GrowthFlawCause::failed, GrowthFlawCause::spacing, GrowthFlawCause::most_rounds,
                            GrowthFlawCause::left_box};

// Segments with a flaw of this cause.
std::size_t flawed(const GrownManifold& manifold, GrowthFlawCause cause) {
  std::size_t sum = 0;
  for (const GrowthFlaw& flaw : manifold.flaws) sum += flaw.cause == cause ? flaw.count : 0;
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
            {"max_points", options.most_points}};
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

void write_flaws(OutputFile& file, const GrownManifold& manifold) {
  Json counts = Json::object();
  for (const GrowthFlawCause cause : causes) {
    if (const std::size_t count = flawed(manifold, cause)) counts[std::string(name(cause))] = count;
  }
  std::string text;
  append_all(text, "\"flaws\": {\"counts\":", dumped(counts), ",\"list\":[");
  for (std::size_t k = 0; k < manifold.flaws.size(); ++k) {
    const GrowthFlaw& flaw = manifold.flaws[k];
    const Point at = manifold.points[flaw.first];
    append_all(text, k == 0 ? "\n  " : ",\n  ", "{\"segment\":", flaw.first, ",\"count\":", flaw.count, ",\"cause\":\"",
               name(flaw.cause), "\",\"at\":[", at.x, ",", at.y, "]}");
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
  for (const GrowthFlawCause cause : causes) {
    const std::size_t count = flawed(manifold, cause);
    if (count == 0) continue;
    const auto first = std::find_if(manifold.flaws.begin(), manifold.flaws.end(),
                                    [&](const GrowthFlaw& flaw) { return flaw.cause == cause; });
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
  write_flaws(json.file(), report.manifold);
  json.finish({{"local_manifold", report.timing.local},
               {"growth", report.timing.growth},
               {"write", report.timing.write},
               {"total", seconds_so_far()}});
}

}  // namespace lober::cli

// The table and the JSON of `lober image`.

#include "cli/image/image_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "cli/program/system_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/growth_diagnostics.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/report.hpp"

namespace lober::cli {
namespace {

const char* cause_text(GrowthDiagnosticCause cause) {
  switch (cause) {
    case GrowthDiagnosticCause::failed:
      return "gaps, where points have no image";
    case GrowthDiagnosticCause::spacing:
      return "segments that rounding keeps from meeting the tolerance";
    case GrowthDiagnosticCause::max_rounds:
      return "segments that do not meet the tolerance after the last round";
    case GrowthDiagnosticCause::left_box:
      break;
  }
  return "segments outside the box, where the tolerance does not hold";
}

std::string remarks(const ImageReport& report) {
  std::string text;
  for (std::size_t k = 0; k < report.images.size(); ++k) {
    const CurveImage& image = report.images[k];
    const std::string of = image_name(image.iterate, report.curve_of(k));
    for (const GrowthDiagnosticCause cause : all_growth_causes) {
      const std::size_t count = segments_with(image.diagnostics, cause);
      if (count == 0) continue;
      const Point at = first_point_with(image, cause);
      text += fmt::format("{:<6} {} {}, the first at ({:.6g}, {:.6g})\n", of, count, cause_text(cause), at.x, at.y);
    }
    if (image.stop == GrowthStop::points) {
      text += fmt::format("{:<6} ends early: --max-points is reached\n", of);
    }
  }
  return text;
}

Json part_json(const ImagePart& part) {
  return {{"points", part.points.size()}, {"closed", part.closed}};
}

Json diagnostics_json(const CurveImage& image) {
  Json list = Json::array();
  for (const GrowthDiagnosticCause cause : all_growth_causes) {
    if (const std::size_t count = segments_with(image.diagnostics, cause)) {
      list.push_back(
          {{"cause", name(cause)}, {"count", count}, {"first_at", point_json(first_point_with(image, cause))}});
    }
  }
  return list;
}

}  // namespace

std::string image_name(int iterate, std::size_t curve) {
  return curve == 0 ? fmt::format("f^{}", iterate) : fmt::format("f^{} boundary {}", iterate, curve + 1);
}

std::string image_table(const ImageReport& report) {
  std::string text = agreement_text(report.agreement) + system_text(report.system) + "\n";
  text += fmt::format("curve      {}, {}\n", report.curve, report.closed ? "closed" : "open");
  if (report.input && !report.input->remark.empty()) text += "curve      " + report.input->remark + "\n";
  text += fmt::format("tolerance  {:g}\n", report.options.tolerance);
  const std::size_t width =
      image_name(report.first, report.images.empty() ? 0 : report.curve_of(report.images.size() - 1)).size();
  const std::size_t names = std::max<std::size_t>(width, 6);
  text += fmt::format("\n{:<{}} {:>10} {:>6} {:>16} {:>23} {:>9}\n", "", names, "points", "parts", "length",
                      "signed area", "+-");
  for (std::size_t k = 0; k < report.images.size(); ++k) {
    text += fmt::format("{:<{}} {:>10} {:>6} {:>16.9g}", image_name(report.images[k].iterate, report.curve_of(k)),
                        names, report.images[k].points.size(), report.parts[k].size(), report.lengths[k]);
    if (report.areas[k]) text += fmt::format(" {:>23.15g} {:>9.1e}", *report.areas[k], report.area_error(k));
    text += "\n";
  }
  const std::string more = remarks(report);
  return more.empty() ? text : text + "\n" + more;
}

void write_image_json(const std::string& path, const ImageReport& report,
                      const std::function<double()>& seconds_so_far) {
  JsonFile json(path, "image");
  json.member("system", system_json(report.system, report.integration));
  Json curve{{"what", report.curve}, {"closed", report.closed}};
  if (report.input) {
    curve.update({{"file", report.input->file},
                  {"zone", report.input->zone},
                  {"sha256", report.input->sha256},
                  {"points", report.input->curve.points.size()}});
  }
  json.member("curve", curve);
  const Rectangle& box = report.options.box;
  json.member("options", {{"first", report.first},
                          {"last", report.last},
                          {"tolerance", report.options.tolerance},
                          {"max_points", report.options.max_points},
                          {"box", {box.min_x, box.min_y, box.max_x, box.max_y}}});
  Json images = Json::array();
  for (std::size_t k = 0; k < report.images.size(); ++k) {
    const CurveImage& image = report.images[k];
    Json parts = Json::array();
    for (const ImagePart& part : report.parts[k]) parts.push_back(part_json(part));
    images.push_back({{"iterate", image.iterate},
                      {"curve", report.curve_of(k)},
                      {"points", image.points.size()},
                      {"length", report.lengths[k]},
                      {"area", report.areas[k] ? Json(*report.areas[k]) : Json()},
                      {"area_error", report.areas[k] ? Json(report.area_error(k)) : Json()},
                      {"complete", image.stop != GrowthStop::points},
                      {"parts", parts},
                      {"diagnostics", diagnostics_json(image)}});
  }
  json.member("images", images);
  add_agreement(json, report.agreement);
  json.finish({{"curve", report.curve_seconds},
               {"images", report.image_seconds},
               {"write", report.write_seconds},
               {"total", seconds_so_far()}});
}

}  // namespace lober::cli

// The table and the JSON of `lober image`.

#include "cli/image/image_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "cli/program/system_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/growth_diagnostics.hpp"
#include "cli/report/outcome_json.hpp"
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
  return "segments outside the box, where the tolerance does not hold: what comes back may be wrong or missing";
}

std::string remarks(const ImageReport& report) {
  std::string text;
  for (const auto& one : report.found().images) {
    for (const GrowthDiagnosticCause cause : all_growth_causes) {
      const std::size_t count = segments_with(one.image.diagnostics, cause);
      if (count == 0) continue;
      const Point at = first_point_with(one.image, cause);
      text +=
          fmt::format("{:<6} {} {}, the first at ({:.6g}, {:.6g})\n", one.name(), count, cause_text(cause), at.x, at.y);
    }
    if (one.image.stop == GrowthStop::points) {
      text += fmt::format("{:<6} ends early: --max-points is reached\n", one.name());
    } else if (one.image.stop == GrowthStop::work) {
      text += fmt::format("{:<6} is left out: --max-work is reached\n", one.name());
    }
  }
  return text;
}

}  // namespace

std::string image_table(const ImageReport& report) {
  const operations::CurveImages& found = report.found();
  std::string text = agreement_text(found.agreement) + system_text(*report.system.system) + "\n";
  text += fmt::format("curve      {}, {}\n", report.curve(), found.closed ? "closed" : "open");
  if (report.input && !report.input->remark.empty()) text += "curve      " + report.input->remark + "\n";
  text += fmt::format("tolerance  {:g}\n", found.tolerance);
  std::size_t names = 6;
  if (!found.images.empty()) {
    operations::CurveImages::One widest;
    widest.image.iterate = found.images.front().image.iterate;
    widest.curve = found.images.back().curve;
    names = std::max(names, widest.name().size());
  }
  const Table table(
      {{"", names, Align::left, 0}, {"points", 10}, {"parts", 6}, {"length", 16}, {"signed area", 23}, {"+-", 9}});
  text += "\n" + table.head();
  for (const auto& one : found.images) {
    std::vector<std::string> cells{one.name(), std::to_string(one.image.points.size()),
                                   std::to_string(one.parts.size()), fmt::format("{:.9g}", one.length)};
    if (one.area) {
      cells.push_back(fmt::format("{:.15g}", one.area->value));
      cells.push_back(fmt::format("{:.1e}", one.area->error));
    }
    text += table.row(cells);
  }
  const std::string more = remarks(report);
  return more.empty() ? text : text + "\n" + more;
}

void write_image_json(const std::string& path, ImageReport& report, const std::function<double()>& seconds_so_far) {
  const operations::CurveImages& found = report.found();
  Json curve{{"what", report.curve()}, {"closed", found.closed}};
  if (report.input) {
    curve.update({{"file", report.input->file},
                  {"zone", report.input->zone},
                  {"sha256", report.input->sha256},
                  {"points", report.input->curve.points.size()}});
  }
  write_outcome_json(path, "image",
                     {{"system", system_json(*report.system.system, report.system.integration)}, {"curve", curve}},
                     operations::named("image"), report.outcome, [&] {
                       return Json{{"curve", found.curve_seconds},
                                   {"images", found.image_seconds},
                                   {"write", report.write_seconds},
                                   {"total", seconds_so_far()}};
                     });
}

}  // namespace lober::cli

#include "cli/grow/grow_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <cstdlib>

#include "cli/program/system_options.hpp"
#include "cli/report/growth_diagnostics.hpp"
#include "cli/report/report.hpp"

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
      return "outside of the box, where the manifold is followed coarsely: what comes back may be wrong or missing";
  }
  return {};
}

}  // namespace

bool ends_as_asked(const GrownManifold& manifold) {
  return manifold.stop == GrowthStop::iterates || manifold.stop == GrowthStop::length;
}

std::string end_of_growth(const GrownManifold& manifold) {
  switch (manifold.stop) {
    case GrowthStop::iterates:
      return "after the iterates asked for";
    case GrowthStop::length:
      return "at the length asked for";
    case GrowthStop::points:
      return "at a limit, of --max-points or --memory, before what was asked for";
    case GrowthStop::work:
      return "at the limit of work, before what was asked for; --max-work allows more";
    case GrowthStop::ended:
      return "in a fixed point: two iterates added less than the tolerance";
    case GrowthStop::failed:
      return "early: no point of the last iterate has an image in the box";
    case GrowthStop::cancelled:
      return "early: it was interrupted";
  }
  return {};
}

std::string grow_summary(const System& system, const operations::SystemManifold& manifold) {
  const LocalManifold& local = manifold.local;
  std::string text = system_text(system) + "\n";
  text +=
      fmt::format("manifold             {}, branch {}\n", local.side == ManifoldSide::unstable ? "unstable" : "stable",
                  manifold.branch == Branch::plus ? "+" : "-");
  text += fmt::format("saddle               ({:.15g}, {:.15g})\n", local.saddle.x, local.saddle.y);
  text += fmt::format("multiplier           {:.15g}\n", local.multiplier);
  if (local.multiplier < 0) {
    text += fmt::format(
        "reflection           both multipliers are negative: images are those of f^{}, which keeps the branch\n",
        std::abs(local.image().steps));
  }
  text += fmt::format("local manifold       reach {:.4g}, defect {:.2g}\n", local.reach, local.defect);
  text += fmt::format("grown                {} points, length {:.10g} in the box: the local manifold and {}\n",
                      manifold.points.size(), manifold.length,
                      counted(manifold.generation_begin.size() - 2, "image of it", "images of it"));
  text += fmt::format("growing ended        {}\n", end_of_growth(manifold));
  for (const GrowthDiagnosticCause cause : all_growth_causes) {
    const std::size_t count = segments_with(manifold.diagnostics, cause);
    if (count == 0) continue;
    const Point at = first_point_with(manifold, cause);
    text += fmt::format("{:<20} {}, the first at ({:.6g}, {:.6g}): {}\n", name(cause),
                        counted(count, "segment", "segments"), at.x, at.y, growth_cause_text(cause));
  }
  return text;
}

}  // namespace lober::cli

#include "lober/dynamics/manifolds.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "engine/dynamics/manifolds/manifold_growth.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

void require_sensible(const LocalManifold& local, const GrowthOptions& options) {
  if (!(options.tolerance > 0)) throw UsageError("grow: the tolerance has to be positive");
  if (!(options.max_length >= 0)) throw UsageError("grow: the maximum length of a segment cannot be negative");
  if (!(options.length > 0)) throw UsageError("grow: the length has to be positive");
  if (options.iterates < 0 && !std::isfinite(options.length)) {
    throw UsageError("grow: either the number of iterates or the length has to be given");
  }
  if (!(std::fabs(local.multiplier) > 1) || !(local.reach > 0)) {
    throw UsageError("grow: this is not a local manifold of a saddle");
  }
}

}  // namespace

Branch branch_towards(const LocalManifold& local, Point direction) {
  return local.tangent.x * direction.x + local.tangent.y * direction.y < 0 ? Branch::minus : Branch::plus;
}

std::string_view name(GrowthDiagnosticCause cause) {
  switch (cause) {
    case GrowthDiagnosticCause::failed:
      return "failed";
    case GrowthDiagnosticCause::spacing:
      return "spacing";
    case GrowthDiagnosticCause::max_rounds:
      return "most-rounds";
    case GrowthDiagnosticCause::left_box:
      return "left-box";
  }
  return "";
}

std::string_view name(GrowthStop stop) {
  switch (stop) {
    case GrowthStop::iterates:
      return "iterates";
    case GrowthStop::length:
      return "length";
    case GrowthStop::points:
      return "points";
    case GrowthStop::work:
      return "work";
    case GrowthStop::ended:
      return "ended";
    case GrowthStop::failed:
      return "failed";
    case GrowthStop::cancelled:
      return "cancelled";
  }
  return "";
}

GrownManifold grow(const PlanarMap& map, const LocalManifold& local, Branch branch, const GrowthOptions& options) {
  require_sensible(local, options);
  ManifoldGrowth growth(map, local, branch, options);
  growth.grow_to(std::numeric_limits<double>::infinity());
  return std::move(growth.grown());
}

}  // namespace lober

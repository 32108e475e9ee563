#include "cli/tangle/tangle_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "cli/program/log.hpp"

namespace lober::cli {

const operations::Operation& TangleReport::operation() const {
  return operations::named(origin ? "manifold_tangle" : "tangle");
}

const operations::CurveTangle& TangleReport::result() const {
  if (origin) return outcome.as<operations::SystemTangle>();
  return outcome.as<operations::CurveTangle>();
}

const ManifoldTangle* TangleReport::manifolds() const {
  return origin ? outcome.as<operations::SystemTangle>().manifolds.get() : nullptr;
}

NamedCurve read_manifold(const std::string& spec, bool reverse, Periods periods) {
  NamedCurve input = read_curve(spec, false, {.periods = periods});
  if (reverse) std::reverse(input.curve.points.begin(), input.curve.points.end());
  return input;
}

void with_names_of(const NamedCurve& u, const NamedCurve& s, const std::function<void()>& make) {
  try {
    make();
  } catch (const NotSimpleError& error) {
    const bool first = error.curve == 1;
    throw DataError(
        fmt::format("{}: {} crosses or touches itself: segments {} and {} meet at ({}, {}) (lober tangle "
                    "--no-check-simple takes such curves)",
                    spec_of(first ? u : s), first ? "U" : "S", error.segment1, error.segment2, error.at.x, error.at.y));
  }
}

Tangle tangle_of(const NamedCurve& u, const NamedCurve& s, const TangleOptions& options) {
  Tangle result;
  with_names_of(
      u, s, [&] { result = tangle(OpenCurve::borrow(u.curve.points), OpenCurve::borrow(s.curve.points), options); });
  for (const std::string& remark : result.remarks) log_warning(fmt::format("warning: {}", remark));
  return result;
}

std::vector<Point> pips_of(const Tangle& tangle) {
  std::vector<Point> points;
  points.reserve(tangle.pips.size());
  for (const Pip& pip : tangle.pips) points.push_back(pip.at);
  return points;
}

}  // namespace lober::cli

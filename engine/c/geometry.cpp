// Overlay, interior, regions, winding, densify and simplify for C.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/c/call.hpp"
#include "lober/densify.hpp"
#include "lober/error.hpp"
#include "lober/interior.hpp"
#include "lober/overlay.hpp"
#include "lober/regions.hpp"

namespace lober::detail::c {
namespace {

using Work = std::function<void(lober_result&)>;

void add_pieces(lober_result& result, Pairing pairing, std::span<const double> areas) {
  result.add("pieces." + std::string(name(pairing)), lober_result::Doubles(areas.begin(), areas.end()));
}

void add_crossings(lober_result& result, const Crossings& nodes) {
  lober_result::Doubles rows;
  rows.reserve(6 * nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node node = nodes[k];
    for (const double value :
         {node.begin.x, node.begin.y, static_cast<double>(node.rho), static_cast<double>(node.shared),
          static_cast<double>(node.begin1.segment), static_cast<double>(node.begin2.segment)}) {
      rows.push_back(value);
    }
  }
  result.add("crossings", std::move(rows), 6);
}

Work overlay_work(const double* points1, std::size_t n1, const double* points2, std::size_t n2, Options& given) {
  OverlayOptions options;
  options.pieces = given.flag("pieces", options.pieces);
  options.check_simple = given.flag("check_simple", options.check_simple);
  options.progress = progress();
  const bool outlines = given.flag("outlines", false);
  return [=](lober_result& result) {
    const auto curve = outlines ? kept_closed_curve : closed_curve;
    auto found =
        std::make_shared<const Overlay>(overlay(curve(points1, n1, "curve 1"), curve(points2, n2, "curve 2"), options));
    result.add("areas", found->areas);
    result.add("rounding", found->rounding);
    for (const Pairing pairing : all_pairings) add_pieces(result, pairing, found->pieces(pairing).areas());
    add_crossings(result, found->nodes);
    lober_result::Integers classes;
    classes.reserve(found->classes.size());
    for (const std::uint32_t one : found->classes)
      classes.push_back(one == Overlay::no_class ? -1 : static_cast<std::int64_t>(one));
    result.add("classes", std::move(classes));
    if (outlines) result.overlay = std::move(found);
  };
}

Work interior_work(const double* points1, std::size_t n1, const double* points2, std::size_t n2, Options& given) {
  static constexpr std::array methods{InteriorMethod::split, InteriorMethod::ends};
  InteriorOptions options;
  options.method = given.choice<InteriorMethod>("method", options.method, methods, [](InteriorMethod method) {
    return std::string_view(method == InteriorMethod::split ? "split" : "ends");
  });
  options.passes = static_cast<int>(given.integer("passes", options.passes));
  options.points = static_cast<int>(given.integer("points", options.points));
  options.check_simple = given.flag("check_simple", options.check_simple);
  options.progress = progress();
  return [=](lober_result& result) {
    const InteriorAreas found =
        interior_areas(closed_curve(points1, n1, "curve 1"), closed_curve(points2, n2, "curve 2"), options);
    result.add("areas", found.areas);
    result.add("rounding", found.rounding);
    result.add("q1", found.q1);
    result.add("q2", found.q2);
    result.add("q3", found.q3);
    result.add("delta", found.delta);
  };
}

Work regions_work(const double* points1, std::size_t n1, const double* points2, std::size_t n2, Options& given) {
  const auto rule =
      given.choice<FillRule>("rule", FillRule::nonzero, all_fill_rules, [](FillRule one) { return name(one); });
  RegionOptions options;
  options.progress = progress();
  return [=](lober_result& result) {
    const ClosedCurve first = closed_curve(points1, n1, "curve 1");
    const Regions found =
        n2 == 0 ? regions(first, options) : regions(first, closed_curve(points2, n2, "curve 2"), options);
    lober_result::Integers numbers;
    lober_result::Doubles areas;
    for (const WindingArea& entry : found.table()) {
      numbers.insert(numbers.end(), {entry.w1, entry.w2});
      areas.push_back(entry.area);
    }
    result.add("windings", std::move(numbers), 2);
    result.add("winding_areas", std::move(areas));
    result.add("areas", found.areas(rule));
    result.add("rounding", found.rounding(rule));
    for (const Pairing pairing : all_pairings) {
      const RegionPieces pieces = found.pieces(rule, pairing);
      add_pieces(result, pairing, pieces.areas());
    }
  };
}

Work winding_work(const double* curve, std::size_t n, const double* points, std::size_t count) {
  const std::span<const Point> at = points_of(points, count, "points");
  return [=](lober_result& result) {
    const ClosedCurve closed = closed_curve(curve, n, "curve");
    validate(closed, "curve");
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (!std::isfinite(at[k].x) || !std::isfinite(at[k].y)) {
        throw DataError("points: point " + std::to_string(k) + " is not finite");
      }
    }
    const IndexedCurve indexed(closed);
    lober_result::Integers numbers, on;
    lober_result::Doubles values;
    for (const Winding& one : windings(indexed, at)) {
      numbers.push_back(one.number);
      on.push_back(one.on ? 1 : 0);
    }
    for (const InteriorValue& one : interior_function(indexed, at)) values.push_back(one.j);
    result.add("number", std::move(numbers));
    result.add("on", std::move(on));
    result.add("j", std::move(values));
  };
}

// Throws where a limit left criteria unmet. The shortest length and corners are what the caller asked for.
void require_criteria(const std::vector<Diagnostic>& diagnostics, std::size_t points) {
  const auto ended_by = [&](DiagnosticCause cause) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [&](const Diagnostic& one) { return one.cause == cause; });
  };
  const std::string count = "the curve has " + std::to_string(points) + " points and does not meet the criteria";
  if (ended_by(DiagnosticCause::max_points)) {
    throw WithResult{LOBER_INCOMPLETE, count + ", since max_points allows no more; give a larger max_points"};
  }
  if (ended_by(DiagnosticCause::max_rounds)) {
    throw WithResult{LOBER_INCOMPLETE, count + " after all rounds; give a larger min_length"};
  }
}

Work densify_work(const double* points, std::size_t n, Options& given) {
  static constexpr std::array interpolations{Interpolation::linear, Interpolation::dritschel, Interpolation::spline};
  Criteria criteria;
  criteria.max_length = given.number("max_length", criteria.max_length);
  criteria.angle = given.number("angle", criteria.angle);
  criteria.distance_angle = given.number("distance_angle", criteria.distance_angle);
  criteria.min_length = given.number("min_length", criteria.min_length);
  DensifyOptions options;
  options.interpolation = given.choice<Interpolation>("interpolation", options.interpolation, interpolations,
                                                      [](Interpolation one) { return name(one); });
  options.max_points = given.count("max_points", options.max_points);
  const CurveView view{points_of(points, n, "curve"), given.flag("closed", true)};
  return [=](lober_result& result) {
    validate(view, "curve");
    DensifiedCurve dense = densify(view, criteria, options);
    lober_result::Integers segments;
    std::string causes;
    for (const Diagnostic& one : dense.diagnostics) {
      segments.insert(segments.end(), {one.first, one.count});
      causes += (causes.empty() ? "" : "\n") + std::string(name(one.cause));
    }
    result.add("diagnostics", std::move(segments), 2);
    result.add("causes", std::move(causes));
    const std::size_t count = dense.points.size();
    result.add_points("points", std::move(dense.points));
    require_criteria(dense.diagnostics, count);
  };
}

Work simplify_work(const double* points, std::size_t n, Options& given) {
  SimplifyOptions options;
  options.tolerance = given.number("tolerance", options.tolerance);
  options.max_length = given.number("max_length", options.max_length);
  const CurveView view{points_of(points, n, "curve"), given.flag("closed", true)};
  return [=](lober_result& result) {
    validate(view, "curve");
    result.add_points("points", simplify(view, options).points);
  };
}

}  // namespace
}  // namespace lober::detail::c

int lober_overlay(const double* curve1, size_t n1, const double* curve2, size_t n2, const char* options,
                  lober_result** result) {
  using namespace lober::detail::c;
  return operation(options, result, [=](Options& given) { return overlay_work(curve1, n1, curve2, n2, given); });
}

int lober_interior(const double* curve1, size_t n1, const double* curve2, size_t n2, const char* options,
                   lober_result** result) {
  using namespace lober::detail::c;
  return operation(options, result, [=](Options& given) { return interior_work(curve1, n1, curve2, n2, given); });
}

int lober_regions(const double* curve1, size_t n1, const double* curve2, size_t n2, const char* options,
                  lober_result** result) {
  using namespace lober::detail::c;
  return operation(options, result, [=](Options& given) { return regions_work(curve1, n1, curve2, n2, given); });
}

int lober_winding(const double* curve, size_t n, const double* points, size_t count, const char* options,
                  lober_result** result) {
  using namespace lober::detail::c;
  return operation(options, result, [=](Options&) { return winding_work(curve, n, points, count); });
}

int lober_signed_area(const double* curve, size_t n, double* area) {
  using namespace lober::detail::c;
  return guarded([&] {
    if (!area) throw lober::UsageError("area is a null pointer");
    const lober::ClosedCurve closed = closed_curve(curve, n, "curve");
    lober::validate(closed, "curve");
    *area = lober::signed_area(closed);
  });
}

int lober_densify(const double* curve, size_t n, const char* options, lober_result** result) {
  using namespace lober::detail::c;
  return operation(options, result, [=](Options& given) { return densify_work(curve, n, given); });
}

int lober_simplify(const double* curve, size_t n, const char* options, lober_result** result) {
  using namespace lober::detail::c;
  return operation(options, result, [=](Options& given) { return simplify_work(curve, n, given); });
}

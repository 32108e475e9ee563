// Overlay, interior, regions and winding for C.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/c/call.hpp"
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

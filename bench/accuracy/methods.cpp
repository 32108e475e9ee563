#include <array>
#include <random>
#include <span>
#include <vector>

#include "bench/accuracy/accuracy.hpp"
#include "engine/geometry/index/box_tree.hpp"
#include "kernels/box.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/smooth.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

double by_overlay(const Scene& scene) {
  return overlay(ClosedCurve::borrow(scene.first), ClosedCurve::borrow(scene.second), {.pieces = false, .progress = {}})
      .areas.c1_minus_c2;
}

double by_interior(const Scene& scene, const InteriorOptions& options) {
  return interior_areas(ClosedCurve::borrow(scene.first), ClosedCurve::borrow(scene.second), options).areas.c1_minus_c2;
}

auto densified(int passes, int points) {
  return [=](const Scene& scene) {
    return by_interior(scene, {.method = InteriorMethod::ends, .passes = passes, .points = points});
  };
}

// As many random points in the box of C1 as the curves have vertices, told apart by exact winding numbers.
double by_monte_carlo(const Scene& scene) {
  const IndexedCurve c1(CurveView{scene.first}), c2(CurveView{scene.second});
  const Box& box = c1.tree().box();
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> x(box.min_x(), box.max_x()), y(box.min_y(), box.max_y());
  std::vector<Point> points(scene.first.size() + scene.second.size());
  for (Point& point : points) point = {x(engine), y(engine)};
  const Buffer<Side> in1 = label_points(c1, points), in2 = label_points(c2, points);
  std::size_t hits = 0;
  for (std::size_t k = 0; k < points.size(); ++k) hits += in1[k] == Side::inside && in2[k] == Side::outside;
  return box.width() * box.height() * static_cast<double>(hits) / static_cast<double>(points.size());
}

const std::array<AccuracyMethod, 8> methods{{
    {"Monte Carlo", {palette::boundary}, by_monte_carlo},
    {"interior, no densifying", {palette::unstable}, densified(0, 0)},
    {"interior, -DENS 1 10", {palette::leaving}, densified(1, 10)},
    {"interior, -DENS 3 10", {palette::flux}, densified(3, 10)},
    {"interior, -DENS 5 100", {palette::entering}, densified(5, 100)},
    {"interior, exact split", {palette::right_of_unstable}, [](const Scene& scene) { return by_interior(scene, {}); }},
    {"overlay, polygon", {palette::stable}, by_overlay},
    {"overlay, smooth",
     {palette::common},
     [](const Scene& scene) {
       const OverlayOptions options{.pieces = false, .progress = {}};
       return smooth_areas(overlay(ClosedCurve::borrow(scene.first), ClosedCurve::borrow(scene.second), options))
           .areas.c1_minus_c2;
     }},
}};

}  // namespace

std::span<const AccuracyMethod> accuracy_methods() {
  return methods;
}

}  // namespace lober::bench

#include "bench/batch/sets.hpp"

#include <cmath>
#include <numbers>

#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"

namespace lober::bench {
namespace {

std::vector<Point> wavy(std::size_t points, int number) {
  std::vector<Point> curve(points);
  for (std::size_t k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points);
    const double radius = 1 + 0.3 * std::sin((3 + number % 5) * angle + number);
    curve[k] = {radius * std::cos(angle) + 0.01 * number, radius * std::sin(angle)};
  }
  return curve;
}

}  // namespace

CurveSet wavy_set(std::string name, std::size_t curves, std::size_t points) {
  CurveSet set{std::move(name), {}};
  for (std::size_t k = 0; k < curves; ++k) set.curves.push_back(wavy(points, static_cast<int>(k)));
  return set;
}

CurveSet iterates(std::string name, std::size_t curves, std::size_t points) {
  CurveSet set{std::move(name), {}};
  std::vector<Point> curve(points);
  for (std::size_t k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points);
    curve[k] = {std::numbers::pi + 2.8 * std::cos(angle), 2.8 * std::sin(angle)};
  }
  for (std::size_t n = 0; n < curves; ++n) {
    set.curves.push_back(curve);
    for (Point& point : curve) {  // on the plane, not folded back: the curve stays closed
      point.y += 1.2 * std::sin(point.x);
      point.x += point.y;
    }
  }
  return set;
}

CurveSet mixed_set(std::string name) {
  CurveSet set{std::move(name), {}};
  int number = 0;
  for (const auto& [curves, points] : {std::pair{60, 1'000}, {10, 10'000}, {2, 1'000'000}}) {
    for (int k = 0; k < curves; ++k) set.curves.push_back(wavy(static_cast<std::size_t>(points), number++));
  }
  return set;
}

void write_set(const CurveSet& set, const std::filesystem::path& folder) {
  for (std::size_t k = 0; k < set.curves.size(); ++k) {
    write_npy(folder / ("curve." + std::to_string(k)), set.curves[k]);
  }
  write_file(folder / "job.toml", "operation = \"overlay\"\ncurves = \"curve.*\"\npairs = \"all\"\n");
}

}  // namespace lober::bench

#include "bench/scenes/shapes.hpp"

#include <algorithm>

namespace lober::bench {
namespace {

// Abscissae and weights of the Gauss-Legendre rule with 5 points on [-1, 1].
constexpr std::array<double, 5> node{-0.90617984593866399, -0.53846931010568309, 0, 0.53846931010568309,
                                     0.90617984593866399};
constexpr std::array<double, 5> weight{0.23692688505618909, 0.47862867049936647, 0.56888888888888889,
                                       0.47862867049936647, 0.23692688505618909};

template <typename Function>
double integral(const Function& function, double from, double to) {
  constexpr int cells = 200;  // error far below 1e-16 for the few waves of our curves
  const double half = (to - from) / (2 * cells);
  double sum = 0;
  for (int cell = 0; cell < cells; ++cell) {
    const double middle = from + half * (2 * cell + 1);
    for (std::size_t k = 0; k < node.size(); ++k) sum += weight[k] * function(middle + half * node[k]);
  }
  return sum * half;
}

}  // namespace

Polygon started_at(const Polygon& polygon, std::size_t shift) {
  Polygon result = polygon;
  std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(shift), result.end());
  return result;
}

void append_line(Polygon& polygon, Point from, Point to, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(count);
    polygon.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
  }
}

std::array<double, 4> areas_from_overlap(double area1, double area2, double overlap) {
  return {area1 - overlap, area2 - overlap, overlap, area1 + area2 - overlap};
}

std::array<double, 4> areas_of_unit_discs(double distance) {
  const double overlap = 2 * std::acos(distance / 2) - distance / 2 * std::sqrt((2 - distance) * (2 + distance));
  return areas_from_overlap(std::numbers::pi, std::numbers::pi, overlap);
}

std::array<double, 4> areas_between(RadiusFunction r1, RadiusFunction r2, std::span<const double> cuts) {
  std::array<double, 4> areas{};
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const auto sector = [&](RadiusFunction r) {
      return integral([r](double angle) { return r(angle) * r(angle) / 2; }, cuts[k], cuts[k + 1]);
    };
    const double gap = integral([=](double angle) { return (r1(angle) - r2(angle)) * (r1(angle) + r2(angle)) / 2; },
                                cuts[k], cuts[k + 1]);
    areas[0] += std::max(gap, 0.0);
    areas[1] += std::max(-gap, 0.0);
    areas[2] += sector(gap > 0 ? r2 : r1);
    areas[3] += sector(gap > 0 ? r1 : r2);
  }
  return areas;
}

}  // namespace lober::bench

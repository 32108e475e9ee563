// The resonance region of the Henon map with k = 0 (reference values: area by action, 110-digit arithmetic).
#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/accuracy/accuracy.hpp"
#include "bench/scenes/shapes.hpp"

namespace lober::bench {
namespace {

constexpr double lobe_area = 0.36598843872559148801;

Point image(Point p) {
  return {p.x * p.x - p.y, p.x};
}

// A point of the unstable manifold at `time` iterates from 1e-8 beside the saddle, where the manifold is straight to
// 1e-16: left and downwards along the eigenvector (lambda, 1), lambda = 2 + sqrt 3.
Point unstable(double time) {
  const double lambda = 2 + std::sqrt(3.0), whole = std::floor(time);
  const double distance = 1e-8 * std::pow(lambda, time - whole);
  Point p{2 - distance * lambda, 2 - distance};
  for (double k = 0; k < whole; ++k) p = image(p);
  return p;
}

// When the manifold, which leaves the saddle to the left of the diagonal, first meets it again.
double time_on_diagonal() {
  const auto right_of_it = [](double time) { return unstable(time).y < unstable(time).x; };
  double high = 8;
  while (!right_of_it(high)) high += 0.05;
  double low = high - 0.05;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (right_of_it(middle) ? high : low) = middle;
  }
  return high;
}

// Times at equal distances along the manifold, up to `end`.
std::vector<double> equidistant_times(double end, std::size_t count) {
  const std::size_t samples = 64 * 1024;
  std::vector<double> length(samples + 1, 0), time(samples + 1);
  for (std::size_t k = 0; k <= samples; ++k) {
    time[k] = end * static_cast<double>(k) / static_cast<double>(samples);
    if (k == 0) continue;
    const Point a = unstable(time[k - 1]), b = unstable(time[k]);
    length[k] = length[k - 1] + std::hypot(b.x - a.x, b.y - a.y);
  }
  std::vector<double> times;
  std::size_t k = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const double wanted = length[samples] * (static_cast<double>(n) + 0.5) / static_cast<double>(count);
    while (length[k + 1] < wanted) ++k;
    const double part = (wanted - length[k]) / (length[k + 1] - length[k]);
    times.push_back(time[k] + part * (time[k + 1] - time[k]));
  }
  return times;
}

}  // namespace

Scene make_henon_lobe(std::size_t points) {
  const double end = time_on_diagonal();
  const std::vector<double> times = equidistant_times(end, points / 2 - 1);
  // Up the unstable manifold to the diagonal and back along its mirror image, the stable one.
  Polygon boundary{{2, 2}};
  for (const double time : times) boundary.push_back(unstable(time));
  boundary.push_back(unstable(end));
  for (std::size_t k = times.size(); k-- > 0;) boundary.push_back({unstable(times[k]).y, unstable(times[k]).x});
  Polygon moved;
  for (const Point& p : boundary) moved.push_back(image(p));
  return {boundary, moved, std::array{lobe_area, lobe_area, 0.0, 0.0}, std::nullopt};
}

}  // namespace lober::bench

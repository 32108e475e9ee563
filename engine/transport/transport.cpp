#include "engine/transport/transport.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "engine/smooth/smooth.hpp"
#include "engine/text.hpp"

namespace lober {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// Areas that two lobes have in common, found by their numbers.
class OverlapTable {
 public:
  explicit OverlapTable(const Tangle& tangle) : list_(overlaps(tangle)) {}
  [[nodiscard]] double operator()(std::size_t i, std::size_t j) const {
    if (i > j) std::swap(i, j);
    const auto at = std::lower_bound(
        list_.begin(), list_.end(), std::pair(i, j),
        [](const LobeOverlap& x, const auto& y) { return std::pair<std::size_t, std::size_t>(x.i, x.j) < y; });
    return at != list_.end() && at->i == i && at->j == j ? at->area : 0;
  }

 private:
  std::vector<LobeOverlap> list_;
};

class Turnstile {
 public:
  explicit Turnstile(const ManifoldTangle& manifolds)
      : manifolds_(manifolds), tangle_(manifolds.tangle), common_(manifolds.tangle) {
    for (std::size_t k = manifolds.image_of_bip(-1); k < manifolds.bip; ++k) {
      (tangle_.images.labels[k].from == 1 ? lobes12_ : lobes21_).push_back(k);
    }
  }
  [[nodiscard]] const std::vector<std::size_t>& lobes12() const { return lobes12_; }
  [[nodiscard]] const std::vector<std::size_t>& lobes21() const { return lobes21_; }

  // mu(L12(1) n f^m(L21(1))), with f^-(m / 2) applied to both.
  [[nodiscard]] double common(int m) const {
    double sum = 0;
    for (const std::size_t i : lobes12_) {
      for (const std::size_t j : lobes21_) sum += common_(moved(i, -(m / 2)), moved(j, m - m / 2));
    }
    return sum;
  }
  // What the smooth areas of those lobes may be wrong by.
  [[nodiscard]] double error(int m) const {
    double sum = 0;
    for (const std::size_t i : lobes12_) sum += tangle_.lobes[moved(i, -(m / 2))].smooth_error;
    for (const std::size_t j : lobes21_) sum += tangle_.lobes[moved(j, m - m / 2)].smooth_error;
    return sum;
  }

 private:
  [[nodiscard]] std::size_t moved(std::size_t lobe, int images) const {
    return lobe + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(manifolds_.period()) * images);
  }

  const ManifoldTangle& manifolds_;
  const Tangle& tangle_;
  OverlapTable common_;
  std::vector<std::size_t> lobes12_, lobes21_;
};

// Whether the chord meets a region between the boundaries at two pips. What they enclose has no meaning then.
bool chord_in_the_way(const Tangle& tangle, std::size_t first, std::size_t last) {
  bool met = tangle.boundary->crosses_itself;
  for (std::size_t lobe = first; lobe < last; ++lobe) met = met || tangle.lobes[lobe].meets_chord;
  return met;
}

// The formulas hold for maps that preserve area. The determinant of the derivative at a saddle tells, to what its
// cancellation leaves of it.
void require_areas_preserved(const PlanarMap& map, Point saddle) {
  Matrix2 a;
  map.iterate_with_derivative(saddle, 1, a);
  const double largest = std::max({std::fabs(a.xx), std::fabs(a.xy), std::fabs(a.yx), std::fabs(a.yy)});
  const double factor = std::fabs(a.xx * a.yy - a.xy * a.yx);
  if (std::fabs(factor - 1) <= 1e-3 + 1e-10 * largest * largest) return;
  throw DataError("transport: the map does not preserve area, it multiplies it by " + shortest(factor) +
                  " at the saddle " + place_text(saddle) + "; lober tangle lists its lobes");
}

double sum_of_areas(const Tangle& tangle, const std::vector<std::size_t>& lobes) {
  double sum = 0;
  for (const std::size_t k : lobes) sum += std::fabs(tangle.lobes[k].area);
  return sum;
}

}  // namespace

Transport transport(const PlanarMap& map, const Connection& connection, const TransportOptions& options) {
  if (options.iterates < 1) throw UsageError("transport takes at least one iterate");
  const int n = options.iterates;
  ManifoldTangleOptions growth;
  growth.tolerance = options.tolerance;
  growth.bip_near = options.bip_near;
  growth.most_points = options.most_points;
  growth.progress = options.progress;
  growth.before = std::max(1 + (n - 1) / 2, n / 2);
  growth.after = n - n / 2;
  Transport result;
  result.manifolds = grow_tangle(map, connection, growth);
  const ManifoldTangle& manifolds = *result.manifolds;
  require_areas_preserved(map, manifolds.local_u.saddle);
  const Tangle& tangle = manifolds.tangle;
  const Turnstile turnstile(manifolds);
  result.region = tangle.boundary->area;
  result.area12 = sum_of_areas(tangle, turnstile.lobes12());
  result.area21 = sum_of_areas(tangle, turnstile.lobes21());
  result.action12 = result.action21 = manifolds.areas_by_action.empty() ? unknown : 0;
  for (std::size_t k = 0; k < manifolds.areas_by_action.size(); ++k) {
    const bool leaves = tangle.images.labels[manifolds.image_of_bip(-1) + k].from == 1;
    (leaves ? result.action12 : result.action21) += std::fabs(manifolds.areas_by_action[k]);
  }

  result.steps.resize(static_cast<std::size_t>(n));
  double overlapped = 0, total = 0, error = 0;
  for (int k = 1; k <= n; ++k) {
    TransportStep& step = result.steps[static_cast<std::size_t>(k - 1)];
    step.n = k;
    step.overlap = turnstile.common(k - 1);
    overlapped += step.overlap;
    step.flux = result.area21 - overlapped;
    step.total = total += step.flux;
    step.discretisation = error += turnstile.error(k - 1);
  }
  for_each_block(result.steps.size(), 1, [&](std::size_t k, std::size_t) {
    TransportStep& step = result.steps[k];
    const std::size_t first = manifolds.image_of_bip(-(step.n / 2)), last = manifolds.image_of_bip(step.n - step.n / 2);
    if (chord_in_the_way(tangle, first, last)) {
      step.by_boundaries = step.boundary_error = step.consistency = unknown;
      return;
    }
    const std::vector<Point> earlier = boundary_outline(tangle, first), later = boundary_outline(tangle, last);
    const CommonArea stays = common_area(CurveView{earlier}, CurveView{later});
    step.by_boundaries = result.region - stays.area;
    step.boundary_error = stays.error;
    step.consistency = std::fabs(step.total - step.by_boundaries);
  });
  return result;
}

}  // namespace lober

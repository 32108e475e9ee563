#include "engine/dynamics/transport/turnstile/turnstile.hpp"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/transport/turnstile/cylinder.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

namespace {

bool leaves(const std::vector<Point>& polygon, const Box& box) {
  return std::any_of(polygon.begin(), polygon.end(), [&](Point p) { return !meet(Box::of(p, p), box); });
}

Measured area_of_both(const std::vector<Point>& first, const std::vector<Point>& second) {
  const Measured product = product_of_windings(first, second).with(0);
  return {std::fabs(product.value), product.error};
}

}  // namespace

Turnstile::Turnstile(Barrier barrier) : barrier_(barrier) {
  if (barrier_.period == 0 || barrier_.images_before() < 1) {
    throw DataError("transport: the lobes between the bip and its pre-image are not all there");
  }
  const Tangle& tangle = *barrier_.tangle;
  const int orientation = sign_of(barrier_);
  for (std::size_t k = barrier_.pip(-1); k < barrier_.bip; ++k) {
    // Before the bip a lobe lies inside if its left is the boundary's left: next it will be outside.
    lobes_[tangle.lobes[k].orientation() == orientation ? 0 : 1].push_back(k);
  }
  common_ = barrier_.lattice == Point{} ? lober::overlaps(tangle) : overlaps_on_cylinder(barrier_);
  if (!(barrier_.fine.min_x() < barrier_.fine.max_x())) return;
  far_.resize(tangle.lobes.size());
  for (std::size_t k = 0; k < far_.size(); ++k) far_[k] = leaves(lobe_outline(tangle, k), barrier_.fine);
}

Measured Turnstile::area(std::size_t lobe) const {
  const Lobe& found = barrier_.tangle->lobes[lobe];
  const double beside =
      barrier_.errors_u.empty() ? barrier_.curve_error * perimeter(lobe_outline(*barrier_.tangle, lobe)) : 0;
  return {std::fabs(found.area), found.smooth_error + beside};
}

Measured Turnstile::common(std::size_t i, std::size_t j) const {
  Measured found = i == j ? area(i) : Measured{};
  if (i > j) std::swap(i, j);
  const auto at = std::lower_bound(
      common_.begin(), common_.end(), std::pair(i, j),
      [](const LobeOverlap& x, const auto& y) { return std::pair<std::size_t, std::size_t>(x.i, x.j) < y; });
  if (at == common_.end() || at->i != i || at->j != j) return found;
  const double curve_error = std::max(barrier_.error_of_lobe(i), barrier_.error_of_lobe(j));
  return found + within_reason({at->area, at->error + curve_error * at->perimeter}, i, j);
}

// The common area of two lobes far outside, where manifolds are followed coarsely, is not known: at most the part of
// either of them that the map, which preserves area, leaves out there.
Measured Turnstile::within_reason(Measured common, std::size_t i, std::size_t j) const {
  if (far_.empty() || !far_[i] || !far_[j]) return common;
  const std::vector<Point> first = lobe_outline(*barrier_.tangle, i), second = lobe_outline(*barrier_.tangle, j);
  const std::vector<Point> first_in = clipped(first, barrier_.fine), second_in = clipped(second, barrier_.fine);
  const Measured inside = area_of_both(first_in, second_in);
  const double outside = std::max(common.value - inside.value, 0.0);
  const bool bounded = std::isfinite(common.error);
  if (bounded && outside <= common.error + inside.error)
    return {common.value, common.error + std::min(outside, inside.error)};
  const double most = std::min(area_here(i) - area_of_both(first_in, first_in).value,
                               area_here(j) - area_of_both(second_in, second_in).value);
  const bool distorted = leaves(first, barrier_.true_size) && leaves(second, barrier_.true_size);
  const double unknown = std::max(distorted || !bounded ? most : std::min(outside, most), 0.0);
  return {std::min(common.value, common.value - outside + unknown), (bounded ? common.error : 0) + unknown};
}

// The area of a lobe, which is that of the lobe of the turnstile that it is an image of.
double Turnstile::area_here(std::size_t lobe) const {
  const std::size_t first = barrier_.pip(-1), period = barrier_.period;
  const std::size_t number = first + (lobe + period * (first / period + 1) - first) % period;
  return std::fabs(barrier_.tangle->lobes[number].area);
}

TurnstileOverlaps Turnstile::overlaps(int m) const {
  const int back = split_images(m, barrier_.images_before() - 1, barrier_.images_after());
  TurnstileOverlaps sums{};
  for (std::size_t first = 0; first < 2; ++first) {
    for (std::size_t second = 0; second < 2; ++second) {
      Measured& sum = sums[first][second];
      for (const std::size_t i : lobes_[first]) {
        for (const std::size_t j : lobes_[second]) sum = sum + common(moved(i, -back), moved(j, m - back));
      }
    }
  }
  return sums;
}

Measured Turnstile::lobe_area(bool leaving) const {
  Measured sum{};
  for (const std::size_t k : lobes(leaving)) sum = sum + area(k);
  return sum;
}

Measured Turnstile::flux12() const {
  const Measured square = balance(overlaps(0));
  const Measured sum = lobe_area12() - lobe_area21();
  return {(square.value + sum.value) / 2, std::max(square.error, sum.error)};
}

Measured Turnstile::flux21() const {
  const Measured square = balance(overlaps(0)), leaving = flux12();
  return {square.value - leaving.value, leaving.error};
}

int split_images(int m, int before, int after) {
  return std::clamp(m / 2, std::max(0, m - after), std::max(0, std::min(m, before)));
}

Measured balance(const Turnstile& c, const Turnstile& d, int m) {
  // f^-back is applied to d, which has to have been there before; f^(m - back) to c.
  const int back = split_images(m, d.barrier().images_before() - 1, c.barrier().images_after());
  Measured sum{};
  for (const bool leaves_c : {true, false}) {
    for (const std::size_t i : c.lobes(leaves_c)) {
      const std::size_t image = c.moved(i, m - back);
      const std::vector<Point> one = lobe_outline(*c.barrier().tangle, image);
      for (const bool leaves_d : {true, false}) {
        for (const std::size_t j : d.lobes(leaves_d)) {
          const std::size_t source = d.moved(j, -back);
          const std::vector<Point> other = lobe_outline(*d.barrier().tangle, source);
          const double curve_error = std::max(c.barrier().error_of_lobe(image), d.barrier().error_of_lobe(source));
          const Measured common = area_in_common(one, other, curve_error, c.barrier().lattice);
          sum = leaves_c == leaves_d ? sum + common : sum - common;
        }
      }
    }
  }
  return sum;
}

Measured first_gain(const Turnstile& c, const Turnstile& d) {
  Measured sum{};
  for (const bool leaving : {true, false}) {
    for (const std::size_t k : c.lobes(leaving)) {
      const std::size_t image = c.moved(k, 1);
      const double curve_error = std::max(c.barrier().error_of_lobe(image), d.barrier().error_up_to(d.barrier().bip));
      const Measured common = area_inside(lobe_outline(*c.barrier().tangle, image), d.barrier(), curve_error);
      sum = leaving ? sum + common : sum - common;
    }
  }
  return sum;
}

}  // namespace lober::detail

#include "engine/dynamics/fixed_points/newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace lober::detail {

namespace {

/// Solves (D - 1) s = -gap; if `singular`, where D - 1 is so to rounding, the shortest s that comes nearest to that.
Point newton_step(const Displacement& here, bool singular) {
  const Matrix2 a = less_1(here.derivative);
  const double d = determinant(a);
  const double squares = a.xx * a.xx + a.xy * a.xy + a.yx * a.yx + a.yy * a.yy;
  if (singular && std::abs(d) <= 1e-15 * squares && squares > 0) return shortest_step(a, here.gap);
  return {(a.xy * here.gap.y - a.yy * here.gap.x) / d, (a.yx * here.gap.x - a.xx * here.gap.y) / d};
}

// Newton's method from one guess, one displacement at a time.
class Iteration {
 public:
  Iteration(Point guess, double extent, const Rectangle* within, bool may_creep, bool any_point)
      : extent_(extent), within_(within), may_creep_(may_creep), any_point_(any_point), next_(guess) {}

  [[nodiscard]] bool ended() const { return ended_; }
  /// Where the displacement is wanted next.
  [[nodiscard]] Point next() const { return next_; }
  /// Whether its derivative is wanted too: a shortened step is tried without, which takes a fraction of the work.
  [[nodiscard]] bool wants_derivative() const { return halvings_ == 0 || accepted_; }
  [[nodiscard]] const NewtonEnd& best() const { return best_; }
  [[nodiscard]] bool stalled() const { return stalled_; }

  void take(const Displacement& here, double reach) {
    if (!accepted_) count_evaluation();
    if (ended_) return;
    const double residual = length(here.gap);
    const bool lower = residual < best_.residual, better = lower || is_nearer(here.gap);
    if (!wants_derivative() && better) {
      accepted_ = true;
      return;
    }
    if (round_ == 0) {
      z_ = next_;
      best_ = {z_, residual};
    } else if (close_ || better || accepted_) {
      z_ = next_;
      if (lower) {
        best_ = {z_, residual};
      } else if (!std::isfinite(residual) || (!better && round_ > min_rounds)) {
        ended_ = true;
        return;
      }
    } else {
      // Far from the point each step has to bring it nearer. Close to it rounding decides, and the best of some is
      // taken.
      stalled_ = ended_ = halvings_ == max_halvings;
      ++halvings_;
      step_ = {0.5 * step_.x, 0.5 * step_.y};
      next_ = {z_.x + step_.x, z_.y + step_.y};
      return;
    }
    step_from(here, reach);
  }

 private:
  // An iteration that has not converged by then is on its way to nowhere, where orbits may be long. One that creeps
  // mostly follows a valley of the displacement whose floor is above zero.
  static constexpr int max_rounds = 60, min_rounds = 8, max_halvings = 12, max_evaluations = 150;
  static constexpr int creep_evaluations = 15;
  static constexpr double creep = 0.9;

  void count_evaluation() {
    ++evaluations_;
    if (evaluations_ == max_evaluations) ended_ = stalled_ = true;
    if (evaluations_ % creep_evaluations != 1) return;
    if (!may_creep_ && evaluations_ > 1 && !close_ && best_.residual > creep * earlier_residual_) {
      ended_ = stalled_ = true;
    }
    earlier_residual_ = evaluations_ > 1 ? best_.residual : std::numeric_limits<double>::infinity();
  }

  /// Whether the step that the derivative at the last point asks for is shorter from here: the natural test of
  /// monotonicity (Deuflhard, Newton Methods for Nonlinear Problems, 2004, section 3.3), which does not depend on the
  /// units of the two components. The floor of a valley of the displacement bends: along it, as in thin resonances,
  /// steps that the residual itself allows are shorter than the valley by as much as that is narrower than it.
  [[nodiscard]] bool is_nearer(Point gap) const {
    if (!any_point_ || round_ == 0 || !is_finite(gap)) return false;
    const double part = std::min(1.0, length(step_) / full_step_);
    return length(newton_step({gap, derivative_}, any_point_)) < (1 - 0.25 * part) * full_step_;
  }

  void step_from(const Displacement& here, double reach) {
    ++round_;
    halvings_ = 0;
    accepted_ = false;
    derivative_ = here.derivative;
    step_ = newton_step(here, any_point_);
    const double size = full_step_ = length(step_);
    if (z_ == best_.at) {
      best_.step = size;
      best_.norm = norm_of(here.derivative);
    }
    ended_ = round_ == max_rounds || !(best_.residual > 0) || !std::isfinite(size);
    close_ = size <= 1e-8 * size_at(z_, extent_);
    if (size > reach) step_ = {step_.x * reach / size, step_.y * reach / size};
    next_ = {z_.x + step_.x, z_.y + step_.y};
    if (within_ != nullptr && !within_->contains(next_)) ended_ = stalled_ = true;
  }

  double extent_;
  const Rectangle* within_;
  bool may_creep_, any_point_;
  Point z_{}, step_{}, next_;
  Matrix2 derivative_{};  // at z_
  double full_step_ = 0;  // length of the step that it asks for
  NewtonEnd best_{};
  double earlier_residual_ = std::numeric_limits<double>::infinity();
  int round_ = 0, halvings_ = 0, evaluations_ = 0;
  bool accepted_ = false;  // a shortened step, whose derivative is wanted now
  bool close_ = false, ended_ = false, stalled_ = false;
};

/// Marks those that have converged, if the map is defined all round them: at the edge of the chart of a section it has
/// limits that look like fixed points.
void mark_converged(const PlanarMap& map, const FixedPointOptions& options, std::span<const Iteration> iterations,
                    std::vector<NewtonEnd>& ends) {
  constexpr double rounding = 1e-14, small = 1e-7, close = 1e-5, largest = 1e-5;
  const double noise = noise_of(map);
  std::vector<std::size_t> candidates;
  std::vector<Point> around;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    ends[k] = iterations[k].best();
    // The residual is noise, which may ask for any step where the derivative is nearly 1; or else the next step is
    // short: along the floor of a valley the residual is small, and steps are long. No step gets below rounding.
    const double size = size_at(ends[k].at, options.extent), residual = ends[k].residual;
    const double scale = size * std::min(1 + ends[k].norm, largest / noise);
    const bool is_near = residual <= noise * scale || (residual <= small * size && ends[k].step <= close * size);
    if (iterations[k].stalled() ? residual > rounding * scale : !is_near) continue;
    candidates.push_back(k);
    const Point z = ends[k].at;
    const double h = 1e-6 * size_at(z, options.extent);
    around.insert(around.end(), {{z.x + h, z.y}, {z.x - h, z.y}, {z.x, z.y + h}, {z.x, z.y - h}});
  }
  map.iterate(around, options.period);
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const auto first = around.begin() + static_cast<std::ptrdiff_t>(4 * k);
    ends[candidates[k]].converged = std::all_of(first, first + 4, is_finite);
  }
}

}  // namespace

NewtonEnd newton(const PlanarMap& map, Point guess, const FixedPointOptions& options, double reach) {
  return newton(map, std::span<const Point>(&guess, 1), options, reach)[0];
}

std::vector<NewtonEnd> newton(const PlanarMap& map, std::span<const Point> guesses, const FixedPointOptions& options,
                              double reach, const Rectangle* within, bool any_point) {
  std::vector<Iteration> iterations;
  iterations.reserve(guesses.size());
  // In searches of flows the work is better spent on a finer grid than on iterations that creep.
  const bool may_creep = within == nullptr || by_formula(map);
  for (const Point guess : guesses) iterations.emplace_back(guess, options.extent, within, may_creep, any_point);
  std::vector<std::size_t> open(guesses.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  std::vector<std::size_t> with_derivative, without;
  while (!open.empty()) {
    with_derivative.clear();
    without.clear();
    for (const std::size_t k : open) (iterations[k].wants_derivative() ? with_derivative : without).push_back(k);
    for (const std::vector<std::size_t>* const some : {&with_derivative, &without}) {
      if (some->empty()) continue;
      std::vector<Point> points;
      points.reserve(some->size());
      for (const std::size_t k : *some) points.push_back(iterations[k].next());
      std::vector<Matrix2> derivatives(points.size());
      if (some == &without) {
        map.iterate(points, options.period);
      } else {
        map.iterate_with_derivatives(points, options.period, derivatives);
      }
      for (std::size_t i = 0; i < some->size(); ++i) {
        Iteration& iteration = iterations[(*some)[i]];
        iteration.take({gap_between(iteration.next(), points[i], options), derivatives[i]}, reach);
      }
    }
    std::erase_if(open, [&](std::size_t k) { return iterations[k].ended(); });
  }
  std::vector<NewtonEnd> ends(guesses.size());
  mark_converged(map, options, iterations, ends);
  return ends;
}

}  // namespace lober::detail

// A curve that a function knows, sampled as finely as the criteria ask for.

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/finite.hpp"
#include "engine/base/parallel/insertion.hpp"
#include "engine/geometry/densify/criteria.hpp"

namespace lober {
namespace {

bool finite(Point point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

class Sampling {
 public:
  Sampling(std::span<const double> parameters, const CurveFunction& function, const SampledOptions& options)
      : function_(function), options_(options), parameters_(parameters.begin(), parameters.end()) {
    points_ = evaluated(parameters_);
    if (const std::size_t bad = first_not_finite(points_); bad != points_.size()) {
      throw DataError("densify: the function gives no finite point for parameter " + std::to_string(parameters_[bad]));
    }
    fates_.assign(segments(), Fate::open);
  }

  SampledCurve run() {
    SampledCurve result;
    while (true) {
      const Buffer<std::uint32_t> broken = gathered<std::uint32_t>(
          segments(), [&](std::size_t k) { return to_be_halved(k); },
          [](std::size_t k) { return static_cast<std::uint32_t>(k); });
      if (broken.empty()) return finish(std::move(result), FlawCause::most_rounds);
      if (result.rounds >= options_.most_rounds) return finish(std::move(result), FlawCause::most_rounds);
      const std::size_t most = std::min<std::size_t>(options_.most_points, (std::size_t{1} << 31) - 1);
      if (points_.size() + broken.size() > most) {
        return finish(std::move(result), FlawCause::most_points);
      }
      halve(broken);
      ++result.rounds;
    }
  }

 private:
  enum class Fate : std::uint8_t { open, not_finite };

  [[nodiscard]] bool closed() const { return options_.period != 0; }
  [[nodiscard]] std::size_t segments() const { return points_.size() - (closed() ? 0 : 1); }
  [[nodiscard]] Point point(std::size_t k) const { return points_[k < points_.size() ? k : k - points_.size()]; }
  [[nodiscard]] double parameter_after(std::size_t k) const {
    return k + 1 < parameters_.size() ? parameters_[k + 1] : parameters_.front() + options_.period;
  }

  // Batches side by side; which batch a parameter comes in depends on its place only.
  [[nodiscard]] Buffer<Point> evaluated(const Buffer<double>& parameters) const {
    Buffer<Point> points(parameters.size());
    for_each_block(parameters.size(), options_.batch, [&](std::size_t first, std::size_t last) {
      function_(std::span(parameters).subspan(first, last - first), std::span(points).subspan(first, last - first));
    });
    return points;
  }

  [[nodiscard]] bool breaks_criterion(std::size_t k) const {
    const Point a = point(k), b = point(k + 1);
    const double length = distance(a, b);
    if (length > options_.criteria.longest) return true;
    const std::size_t size = points_.size();
    const Criteria& criteria = options_.criteria;
    const auto breaks_at = [&](Point before, Point here, Point after, double other) {
      if (angle_surely_holds(criteria, before, here, after, length)) return false;
      return need_at_vertex(criteria, turning_angle(before, here, after), 0, length, other).growth > 1;
    };
    if (closed() || k > 0) {
      const Point before = point(k + size - 1);
      if (breaks_at(before, a, b, distance(before, a))) return true;
    }
    if (closed() || k + 2 < size) {
      const Point after = point(k + 2);
      if (breaks_at(a, b, after, distance(b, after))) return true;
    }
    return false;
  }

  // Why a segment cannot be halved, if it cannot.
  [[nodiscard]] bool too_short(std::size_t k) const {
    return distance(point(k), point(k + 1)) < 2 * options_.criteria.shortest;
  }
  [[nodiscard]] double middle(std::size_t k) const {
    const double from = parameters_[k];
    return from + (parameter_after(k) - from) / 2;
  }
  [[nodiscard]] bool too_close(std::size_t k) const {
    const double from = parameters_[k], to = parameter_after(k), between = middle(k);
    return !(between > from && between < to) || to - from < 2 * options_.least_spacing;
  }

  [[nodiscard]] bool to_be_halved(std::size_t k) const {
    return fates_[k] == Fate::open && breaks_criterion(k) && !too_short(k) && !too_close(k);
  }

  void halve(const Buffer<std::uint32_t>& broken) {
    Buffer<double> middles(broken.size());
    for_each_block(broken.size(), pass_grain, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) middles[k] = middle(broken[k]);
    });
    const Buffer<Point> fresh = evaluated(middles);
    for_each_block(broken.size(), pass_grain, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        if (!finite(fresh[k])) fates_[broken[k]] = Fate::not_finite;
      }
    });
    struct Insertion {
      std::uint32_t segment;
      Point point;
      double parameter;
    };
    const auto insertions = gathered<Insertion>(
        broken.size(), [&](std::size_t k) { return finite(fresh[k]); },
        [&](std::size_t k) {
          return Insertion{broken[k], fresh[k], middles[k]};
        });
    points_ = with_inserted(std::span<const Point>(points_), insertions, [](const Insertion& i) { return i.point; });
    parameters_ =
        with_inserted(std::span<const double>(parameters_), insertions, [](const Insertion& i) { return i.parameter; });
    fates_ = with_inserted(std::span<const Fate>(fates_), insertions, [](const Insertion&) { return Fate::open; });
  }

  // `open_cause` is why segments that could still be halved are not.
  SampledCurve finish(SampledCurve result, FlawCause open_cause) {
    const Buffer<Flaw> flaws = gathered<Flaw>(
        segments(), [&](std::size_t k) { return breaks_criterion(k); },
        [&](std::size_t k) {
          FlawCause cause = open_cause;
          if (fates_[k] == Fate::not_finite) {
            cause = FlawCause::not_finite;
          } else if (too_short(k)) {
            cause = FlawCause::shortest;
          } else if (too_close(k)) {
            cause = FlawCause::spacing;
          }
          return Flaw{static_cast<std::uint32_t>(k), 1, cause};
        });
    result.flaws.assign(flaws.begin(), flaws.end());
    result.points = std::move(points_);
    result.parameters = std::move(parameters_);
    result.closed = closed();
    return result;
  }

  const CurveFunction& function_;
  const SampledOptions& options_;
  Buffer<double> parameters_;
  Buffer<Point> points_;
  Buffer<Fate> fates_;  // of each segment
};

}  // namespace

SampledCurve densify_sampled(std::span<const double> parameters, const CurveFunction& function,
                             const SampledOptions& options) {
  require_sensible(options.criteria);
  if (options.batch == 0) throw UsageError("densify: a batch has to hold a parameter");
  if (!(options.least_spacing >= 0)) throw UsageError("densify: the least spacing cannot be negative");
  if (parameters.size() < 2) throw UsageError("densify: at least two parameters are needed to begin with");
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    if (!std::isfinite(parameters[k]) || (k > 0 && !(parameters[k] > parameters[k - 1]))) {
      throw UsageError("densify: parameters have to be finite and strictly ascending");
    }
  }
  if (options.period != 0 && !(parameters.front() + options.period > parameters.back())) {
    throw UsageError("densify: the period has to be longer than the range of the parameters");
  }
  return Sampling(parameters, function, options).run();
}

}  // namespace lober

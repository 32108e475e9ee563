#include "lober/dynamics/local_manifold.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/text.hpp"
#include "engine/dynamics/manifolds/saddle.hpp"
#include "engine/dynamics/maps/linear_algebra.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "kernels/chebyshev.hpp"
#include "kernels/elementary.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

struct ImagesOfPoints {
  std::vector<Point> points;
  std::vector<Matrix2> derivatives;
};

constexpr std::size_t points_together = 16;  // points that are followed together

// F^steps at many points, side by side.
ImagesOfPoints images_with_derivative(const PlanarMap& map, int steps, std::span<const Point> points) {
  ImagesOfPoints images{{points.begin(), points.end()}, std::vector<Matrix2>(points.size())};
  for_each_block(points.size(), std::max(points_together, map.batch()), [&](std::size_t first, std::size_t last) {
    map.iterate_with_derivatives(std::span(images.points).subspan(first, last - first), steps,
                                 std::span(images.derivatives).subspan(first, last - first));
  });
  return images;
}

void iterate_all(const PlanarMap& map, int steps, std::vector<Point>& points) {
  for_each_block(points.size(), std::max(points_together, map.batch()), [&](std::size_t first, std::size_t last) {
    map.iterate(std::span(points).subspan(first, last - first), steps);
  });
}

// T_0, ..., T_n at x and, if wanted, their derivatives.
void chebyshev_basis(double x, std::span<double> values, std::span<double> slopes = {}) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = k == 0 ? 1 : k == 1 ? x : 2 * x * values[k - 1] - values[k - 2];
    if (slopes.empty()) continue;
    slopes[k] = k == 0 ? 0 : k == 1 ? 1 : 2 * values[k - 1] + 2 * x * slopes[k - 1] - slopes[k - 2];
  }
}

// P on [-reach, reach] together with lambda, and how well they solve the equation.
struct Candidate {
  double reach = 0;
  double multiplier = 0;
  std::vector<Point> coefficients;
  double defect = std::numeric_limits<double>::infinity();
  double defect_across = std::numeric_limits<double>::infinity();
  double noise = 0, noise_across = 0;  // as in LocalManifold

  [[nodiscard]] std::vector<Point> at(std::span<const double> parameters) const {
    std::vector<Point> points(parameters.size());
    chebyshev_points(coefficients, 0, reach, parameters, points);
    return points;
  }
};

class Solver {
 public:
  Solver(const PlanarMap& map, int steps, const Saddle& saddle, int degree)
      : map_(map), steps_(steps), saddle_(saddle), size_(static_cast<std::size_t>(degree) + 1) {}

  [[nodiscard]] Candidate linear(double reach) const {
    Candidate result{reach, saddle_.multiplier, std::vector<Point>(size_)};
    result.coefficients[0] = saddle_.at;
    result.coefficients[1] = {saddle_.tangent.x * reach, saddle_.tangent.y * reach};
    return result;
  }

  // The same curve to a smaller reach.
  [[nodiscard]] Candidate shortened(const Candidate& from, double reach) const {
    std::vector<double> parameters(size_);
    for (std::size_t k = 0; k < size_; ++k) parameters[k] = reach * chebyshev_node(k, size_);
    Candidate result{reach, from.multiplier, std::vector<Point>(size_)};
    chebyshev_coefficients(from.at(parameters), result.coefficients);
    return result;
  }

  // The curve of another map, moved to this saddle.
  [[nodiscard]] Candidate shifted(const LocalManifold& other) const {
    std::vector<double> parameters(size_);
    for (std::size_t k = 0; k < size_; ++k) parameters[k] = other.reach * chebyshev_node(k, size_);
    std::vector<Point> points(size_);
    other.points_at(parameters, points);
    const Point from = other.at(0);
    for (Point& point : points) point = {point.x + saddle_.at.x - from.x, point.y + saddle_.at.y - from.y};
    Candidate result{other.reach, other.multiplier, std::vector<Point>(size_)};
    chebyshev_coefficients(points, result.coefficients);
    return result;
  }

  // The same curve, continued by the map to a larger reach.
  [[nodiscard]] Candidate continued(const Candidate& from, double reach) const {
    int images = 0;
    double scale = 1;
    for (; reach * scale > from.reach; ++images) scale /= std::fabs(from.multiplier);
    if (from.multiplier < 0 && images % 2 != 0) scale = -scale;
    std::vector<double> parameters(size_);
    for (std::size_t k = 0; k < size_; ++k) parameters[k] = reach * chebyshev_node(k, size_) * scale;
    std::vector<Point> points = from.at(parameters);
    iterate_all(map_, images * steps_, points);
    Candidate result{reach, from.multiplier, std::vector<Point>(size_)};
    chebyshev_coefficients(points, result.coefficients);
    return result;
  }

  // The same from close by, until the residual is below `enough` or falls no further. Derivatives take three times as
  // long as images do: those of a guess whose residual is below `close`, as a fraction of the reach, are improved by
  // the steps themselves in each further round (Broyden's method for the equation that they linearise).
  [[nodiscard]] std::optional<Candidate> solved_nearby(Candidate from, double enough) const {
    constexpr double close = 1e-2;
    std::optional<Candidate> best;
    std::optional<LeastSquares> linearised;
    std::vector<std::vector<double>> steps;
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 20; ++round) {
      const bool anew = !linearised || least > close * from.reach;
      Matrix jacobian(anew ? 4 * size_ + 1 : 1, 2 * size_ + 1);
      const std::vector<double> residual = residual_of(from, anew ? &jacobian : nullptr);
      const double size = length_of(residual), before = std::exchange(least, std::min(size, least));
      if (!(size < before)) break;
      best = from;
      if (!(size < 0.5 * before)) break;
      if (anew) {
        linearised.emplace(jacobian);
        steps.clear();
      }
      steps.push_back(broyden_step(linearised->solve(residual), steps));
      correct(from, steps.back());
      // The next round gains by as much as this one did, or more.
      if (round == 0 || size * (size / before) > enough) continue;
      best = from;
      break;
    }
    if (best) measure_between_nodes(*best);
    return best;
  }

  // Gauss-Newton as long as it gains; nothing when the map fails on the way.
  [[nodiscard]] std::optional<Candidate> solved(Candidate from) const {
    std::optional<Candidate> best;
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 20; ++round) {
      const double residual = step(from, best, least);
      if (!std::isfinite(residual)) return std::nullopt;
      if (residual < least) {
        const bool gains = residual < 0.5 * least;
        least = residual;
        if (!gains) break;
      } else {
        break;
      }
    }
    if (best) measure(*best);
    return best;
  }

 private:
  // The residual of `from`, kept in `best` if that is the least so far; then `from` is replaced by the next guess.
  double step(Candidate& from, std::optional<Candidate>& best, double least) const {
    Matrix jacobian(4 * size_ + 1, 2 * size_ + 1);
    const std::vector<double> residual = residual_of(from, &jacobian);
    const double size = length_of(residual);
    if (!std::isfinite(size)) return size;
    if (size < least) best = from;
    correct(from, least_squares(jacobian, residual));
    return size;
  }

  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  }
  static double length_of(const std::vector<double>& residual) { return std::sqrt(dot(residual, residual)); }

  // The step that follows `steps`, if the first linearisation alone would make it `step`: each of those corrects the
  // linearisation by what it led to (Kelley 1995, Iterative Methods, 7.3).
  static std::vector<double> broyden_step(std::vector<double> step, const std::vector<std::vector<double>>& steps) {
    const auto add = [&](const std::vector<double>& to, double times) {
      for (std::size_t k = 0; k < step.size(); ++k) step[k] += times * to[k];
    };
    for (std::size_t j = 0; j + 1 < steps.size(); ++j) add(steps[j + 1], dot(steps[j], step) / dot(steps[j], steps[j]));
    if (steps.empty()) return step;
    const double part = dot(steps.back(), step) / dot(steps.back(), steps.back());
    if (!(part < 0.5)) return step;
    for (double& x : step) x /= 1 - part;
    return step;
  }

  void correct(Candidate& from, const std::vector<double>& change) const {
    for (std::size_t k = 0; k < size_; ++k) {
      const std::size_t column = 2 * k;
      from.coefficients[k].x -= change[column];
      from.coefficients[k].y -= change[column + 1];
    }
    from.multiplier -= change[2 * size_];
  }

  // F(P(s)) - P(lambda s) at the nodes, and how far P'(0) is from 1 along the tangent; with derivatives by the
  // coefficients and lambda, if they are wanted.
  std::vector<double> residual_of(const Candidate& from, Matrix* jacobian) const {
    const std::size_t nodes = 2 * size_;
    std::vector<double> parameters(nodes);
    for (std::size_t j = 0; j < nodes; ++j) {
      parameters[j] = from.reach * chebyshev_node(j, nodes) / std::fabs(saddle_.multiplier);
    }
    ImagesOfPoints images;
    if (jacobian != nullptr) {
      images = images_with_derivative(map_, steps_, from.at(parameters));
    } else {
      images.points = from.at(parameters);
      iterate_all(map_, steps_, images.points);
    }
    const std::size_t rows = 2 * nodes + 1, columns = 2 * size_ + 1;
    std::vector<double> residual(rows);
    std::vector<double> here(size_), there(size_), slope(size_);
    for (std::size_t j = 0; j < nodes; ++j) {
      const double x = parameters[j] / from.reach;
      chebyshev_basis(x, here);
      chebyshev_basis(from.multiplier * x, there, slope);
      const std::size_t row = 2 * j;
      Point p, velocity;
      for (std::size_t k = 0; k < size_; ++k) {
        const Point c = from.coefficients[k];
        p = {p.x + c.x * there[k], p.y + c.y * there[k]};
        velocity = {velocity.x + c.x * slope[k], velocity.y + c.y * slope[k]};
        if (jacobian == nullptr) continue;
        const Matrix2& a = images.derivatives[j];
        const std::size_t column = 2 * k;
        (*jacobian)(row, column) = a.xx * here[k] - there[k];
        (*jacobian)(row, column + 1) = a.xy * here[k];
        (*jacobian)(row + 1, column) = a.yx * here[k];
        (*jacobian)(row + 1, column + 1) = a.yy * here[k] - there[k];
      }
      if (jacobian != nullptr) {
        (*jacobian)(row, columns - 1) = -velocity.x * x;
        (*jacobian)(row + 1, columns - 1) = -velocity.y * x;
      }
      residual[row] = images.points[j].x - p.x;
      residual[row + 1] = images.points[j].y - p.y;
    }
    // The last row: P'(0) has component 1 along the tangent.
    chebyshev_basis(0, here, slope);
    double along = 0;
    for (std::size_t k = 0; k < size_; ++k) {
      const std::size_t column = 2 * k;
      if (jacobian != nullptr) {
        (*jacobian)(rows - 1, column) = saddle_.tangent.x * slope[k];
        (*jacobian)(rows - 1, column + 1) = saddle_.tangent.y * slope[k];
      }
      along += slope[k] * (saddle_.tangent.x * from.coefficients[k].x + saddle_.tangent.y * from.coefficients[k].y);
    }
    if (jacobian != nullptr) (*jacobian)(rows - 1, columns - 1) = 0;
    residual[rows - 1] = along - from.reach;
    return residual;
  }

  // The defect at points that are no nodes, evenly spread and up to the end.
  void measure(Candidate& candidate) const {
    const std::size_t count = 8 * size_ + 1;
    std::vector<double> at(count);
    for (std::size_t k = 0; k < count; ++k) at[k] = -1 + 2 * static_cast<double>(k) / static_cast<double>(count - 1);
    measure(candidate, at);
  }

  // The same with a quarter of the points: between nodes, one each, where a polynomial that is right at these is off by
  // the most.
  void measure_between_nodes(Candidate& candidate) const {
    const std::size_t count = 2 * size_ + 1;
    std::vector<double> at(count);
    for (std::size_t k = 0; k < count; ++k) {
      at[k] = -elementary::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(count - 1));
    }
    measure(candidate, at);
  }

  // At these fractions of the reach, which ascend.
  void measure(Candidate& candidate, std::span<const double> at) const {
    const std::size_t count = at.size();
    std::vector<double> parameters(count), ahead(count);
    for (std::size_t k = 0; k < count; ++k) {
      ahead[k] = candidate.reach * at[k];
      parameters[k] = ahead[k] / candidate.multiplier;
    }
    std::vector<Point> images = candidate.at(parameters);
    iterate_all(map_, steps_, images);
    const std::vector<Point> expected = candidate.at(ahead);
    candidate.defect = candidate.defect_across = 0;
    for (std::size_t k = 0; k < count; ++k) {
      if (!is_finite(images[k])) {
        candidate.defect = candidate.defect_across = std::numeric_limits<double>::infinity();
        return;
      }
      const Point d{images[k].x - expected[k].x, images[k].y - expected[k].y};
      const Point a = expected[k == 0 ? 0 : k - 1], b = expected[k + 1 == count ? k : k + 1];
      const Point e{b.x - a.x, b.y - a.y};
      const double length = std::hypot(e.x, e.y);
      candidate.defect = std::max(candidate.defect, std::hypot(d.x, d.y));
      if (length > 0)
        candidate.defect_across = std::max(candidate.defect_across, std::fabs(d.x * e.y - d.y * e.x) / length);
    }
  }

  const PlanarMap& map_;
  int steps_;
  Saddle saddle_;
  std::size_t size_;
};

void require_sensible(const LocalManifoldOptions& options) {
  if (options.period < 1) throw UsageError("local manifold: the period has to be 1 or more");
  if (options.degree < 2 || options.degree > 200)
    throw UsageError("local manifold: the degree has to be from 2 to 200");
  if (!(options.tolerance > 0)) throw UsageError("local manifold: the tolerance has to be positive");
  if (!(options.max_length > 0)) throw UsageError("local manifold: the maximum length has to be positive");
}

double scale_of(const Saddle& saddle, double unit) {
  return std::max({unit, std::fabs(saddle.at.x), std::fabs(saddle.at.y)});
}

bool is_acceptable(const Candidate& found, const Saddle& saddle, const LocalManifoldOptions& options, double unit,
                   double times = 1) {
  const double allowed = options.tolerance * scale_of(saddle, unit);
  return found.defect_across <= times * std::max(allowed, found.noise_across) &&
         found.defect <= times * std::max(allowed * std::fabs(saddle.multiplier), found.noise);
}

// The largest reach at which the defect is acceptable.
Candidate farthest(const Solver& solver, const Saddle& saddle, const LocalManifoldOptions& options, double unit) {
  const double scale = scale_of(saddle, unit);
  // Small enough to be right, so that what defect there is belongs to the map.
  std::optional<Candidate> best;
  double reach = std::min(1e-2 * scale, options.max_length);
  for (int attempt = 0; attempt < 20 && !best; ++attempt, reach /= 8) {
    best = solver.solved(solver.linear(reach));
    if (best && !(best->defect_across <= 1e-9 * scale)) best.reset();
  }
  if (!best) {
    throw DataError("no invariant curve was found through the saddle " + format_point(saddle.at) +
                    unresolved(std::fabs(saddle.multiplier)));
  }
  best->noise_across = 4 * best->defect_across;
  best->noise = 4 * best->defect;
  for (double factor = 4; factor > 1.1;) {
    const double next = best->reach * factor;
    std::optional<Candidate> candidate;
    if (next <= options.max_length) candidate = solver.solved(solver.continued(*best, next));
    if (candidate) {
      candidate->noise = best->noise;
      candidate->noise_across = best->noise_across;
    }
    if (candidate && is_acceptable(*candidate, saddle, options, unit)) {
      best = std::move(candidate);
    } else {
      factor = std::sqrt(factor);
    }
  }
  return *best;
}

// The factor by which the reach may grow until the coefficients, which die out like a geometric series as far as
// rounding and the errors of the map, `noise`, show them, need all of the degree; 1 or more.
double room_to_grow(const Candidate& found, double noise) {
  const auto size_of = [&](std::size_t k) { return length(found.coefficients[k]); };
  const double least = std::max(noise, 8 * std::numeric_limits<double>::epsilon() * size_of(0));
  const std::size_t size = found.coefficients.size();
  std::size_t used = size;
  while (used > 2 && size_of(used - 1) <= least) --used;
  const double unused = static_cast<double>(size) / static_cast<double>(used) - 1;
  return elementary::power(std::max(size_of(1) / least, 1.0), unused / static_cast<double>(size));
}

// The manifold from that of a map nearby, with its reach, at which the defect is about the allowed one: so it may be
// twice that. Where this is a little too long for this map it is shortened, and made longer where it is far too short.
std::optional<Candidate> from_neighbour(const Solver& solver, const Saddle& saddle, const LocalManifoldOptions& options,
                                        double unit) {
  constexpr int max_shortenings = 2;
  constexpr double shortening = 0.7, hardly_off = 1e-9, worth_growing = 2.5;
  const LocalManifold& other = *options.neighbour;
  if (!(other.multiplier * saddle.multiplier > 0) || other.reach > options.max_length) return std::nullopt;
  const double scale = scale_of(saddle, unit);
  const double near_enough = 0.5 * std::max(options.tolerance * scale, other.noise_across);
  const auto solved = [&](const Candidate& guess, double enough) {
    std::optional<Candidate> found = solver.solved_nearby(guess, enough);
    if (found) {
      found->noise = other.noise;
      found->noise_across = other.noise_across;
    }
    return found;
  };
  const auto is_good = [&](const std::optional<Candidate>& found) {
    return found && is_acceptable(*found, saddle, options, unit, 2);
  };
  std::optional<Candidate> found = solved(solver.shifted(other), near_enough);
  // Once more, with derivatives from nearer by, and until nothing more is gained.
  if (found && !is_good(found)) found = solved(*found, 0);
  for (int k = 0; k < max_shortenings && found && !is_good(found) && found->defect_across <= hardly_off * scale; ++k)
    found = solved(solver.shortened(*found, shortening * found->reach), near_enough);
  if (!is_good(found)) return std::nullopt;
  if (!options.outgrow_neighbour) return found;
  const double longer = std::min(room_to_grow(*found, other.noise_across) * found->reach, options.max_length);
  if (longer < worth_growing * found->reach) return found;
  const std::optional<Candidate> grown = solved(solver.continued(*found, longer), near_enough);
  return is_good(grown) ? grown : found;
}

}  // namespace

Point LocalManifold::at(double s) const {
  Point point;
  points_at({&s, 1}, {&point, 1});
  return point;
}

void LocalManifold::points_at(std::span<const double> parameters, std::span<Point> points) const {
  chebyshev_points(without_roundings(coefficients), 0, reach, parameters, points);
}

Point LocalManifold::slope(double s) const {
  std::vector<double> values(coefficients.size()), slopes(coefficients.size());
  chebyshev_basis(s / reach, values, slopes);
  Point sum;
  for (std::size_t k = 1; k < coefficients.size(); ++k) {
    sum.x += coefficients[k].x * slopes[k] / reach;
    sum.y += coefficients[k].y * slopes[k] / reach;
  }
  return sum;
}

LocalManifold::Image LocalManifold::image() const {
  if (multiplier < 0) return {2 * steps, multiplier * multiplier};
  return {steps, multiplier};
}

LocalManifold local_manifold(const PlanarMap& map, Point guess, ManifoldSide side, const LocalManifoldOptions& given) {
  require_sensible(given);
  LocalManifoldOptions options = given;
  options.max_length *= map.unit();
  if (!is_finite(guess)) throw UsageError("local manifold: the fixed point has to be finite");
  const int steps = side == ManifoldSide::stable ? -options.period : options.period;
  const Saddle saddle = saddle_near(map, steps, guess);
  require_derivative_fits(map, steps, saddle.at);
  const Solver solver(map, steps, saddle, options.degree);
  std::optional<Candidate> continued;
  if (options.neighbour) continued = from_neighbour(solver, saddle, options, map.unit());
  Candidate best = continued ? *std::move(continued) : farthest(solver, saddle, options, map.unit());
  LocalManifold result;
  result.saddle = saddle.at;
  result.tangent = saddle.tangent;
  result.side = side;
  result.steps = steps;
  result.multiplier = best.multiplier;
  result.reach = best.reach;
  result.coefficients = std::move(best.coefficients);
  result.defect = best.defect;
  result.defect_across = best.defect_across;
  result.noise = best.noise;
  result.noise_across = best.noise_across;
  return result;
}

}  // namespace lober

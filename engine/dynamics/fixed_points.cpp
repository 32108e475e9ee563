#include "engine/dynamics/fixed_points.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>

#include "engine/dynamics/formula_map.hpp"
#include "engine/error.hpp"
#include "engine/parallel/parallel.hpp"

namespace lober {

namespace {

double length(Point v) {
  return std::hypot(v.x, v.y);
}

double size_at(Point z) {
  return 1 + length(z);
}

std::string shortest(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::string text(Point z) {
  return "(" + shortest(z.x) + ", " + shortest(z.y) + ")";
}

void require(const FixedPointOptions& options) {
  if (options.period < 1) throw UsageError("the period of a fixed point must be at least 1");
  if (options.grid < 2) throw UsageError("the grid of a scan for fixed points must have at least 2 points a side");
}

/// f^period(z) - z - shift, and the derivative of f^period.
struct Displacement {
  Point gap;
  Matrix2 derivative;
};

Displacement displacement(const PlanarMap& map, Point z, int period, Point shift) {
  Displacement result;
  const Point image = map.iterate_with_derivative(z, period, result.derivative);
  result.gap = {image.x - z.x - shift.x, image.y - z.y - shift.y};
  return result;
}

/// Solves (D - 1) s = -gap.
Point newton_step(const Displacement& here) {
  const Matrix2 a{here.derivative.xx - 1, here.derivative.xy, here.derivative.yx, here.derivative.yy - 1};
  const double d = determinant(a);
  return {(a.xy * here.gap.y - a.yy * here.gap.x) / d, (a.yx * here.gap.x - a.xx * here.gap.y) / d};
}

struct NewtonEnd {
  Point at;
  double residual = 0;
  bool converged = false;
};

/// Whether the map is defined all round z. At the edge of the chart of a section it has limits that look like fixed
/// points.
bool is_inside(const PlanarMap& map, Point z, int period) {
  const double h = 1e-6 * size_at(z);
  std::array<Point, 4> around{{{z.x + h, z.y}, {z.x - h, z.y}, {z.x, z.y + h}, {z.x, z.y - h}}};
  map.iterate(around, period);
  return std::all_of(around.begin(), around.end(), is_finite);
}

/// `reach` is the longest step.
NewtonEnd newton(const PlanarMap& map, Point z, const FixedPointOptions& options, double reach) {
  Displacement here = displacement(map, z, options.period, options.shift);
  double residual = length(here.gap);
  if (!is_finite(here.gap)) return {z, residual, false};
  for (int k = 0; k < 60; ++k) {
    Point step = newton_step(here);
    double longest = length(step);
    if (residual == 0) return {z, residual, is_inside(map, z, options.period)};
    if (!std::isfinite(longest)) return {z, residual, false};
    const bool close = longest <= 1e-8 * size_at(z);
    if (longest > reach) {
      step = {step.x * reach / longest, step.y * reach / longest};
      longest = reach;
    }
    bool better = false;
    for (int halvings = 0; halvings < 12 && !better; ++halvings) {
      const Point next{z.x + step.x, z.y + step.y};
      const Displacement there = displacement(map, next, options.period, options.shift);
      const double next_residual = length(there.gap);
      if (next_residual < residual) {
        z = next;
        here = there;
        residual = next_residual;
        better = true;
      } else if (close && std::isfinite(next_residual)) {
        // As near as rounding allows.
        return {z, residual, residual <= 1e-7 * size_at(z) && is_inside(map, z, options.period)};
      }
      step = {0.5 * step.x, 0.5 * step.y};
    }
    if (!better) return {z, residual, false};
  }
  return {z, residual, false};
}

Point direction(const Matrix2& a, double eigenvalue) {
  const Point first{a.xy, eigenvalue - a.xx};
  const Point second{eigenvalue - a.yy, a.yx};
  Point v = length(first) > length(second) ? first : second;
  const double norm = length(v);
  if (norm == 0) return {1, 0};
  v = {v.x / norm, v.y / norm};
  const bool turn = std::abs(v.x) > 1e-9 ? v.x < 0 : v.y < 0;
  return turn ? Point{-v.x, -v.y} : v;
}

/// Fills in what follows from the derivative.
void classify(FixedPoint& point) {
  const Matrix2& a = point.derivative;
  const double half_trace = 0.5 * (a.xx + a.yy);
  const double det = determinant(a);
  // (trace / 2)^2 - det, without the cancellation of that form.
  const double half_difference = 0.5 * (a.xx - a.yy);
  const double discriminant = half_difference * half_difference + a.xy * a.yx;
  const auto compare_to_1 = [](double modulus) { return std::abs(modulus - 1) <= 1e-7 ? 0 : modulus > 1 ? 1 : -1; };
  if (discriminant < 0) {
    const double imaginary = std::sqrt(-discriminant);
    point.eigenvalues = {std::complex(half_trace, imaginary), std::complex(half_trace, -imaginary)};
    const int side = compare_to_1(std::sqrt(det));
    point.kind = side == 0 ? FixedPointKind::centre : side > 0 ? FixedPointKind::repelling : FixedPointKind::attracting;
    return;
  }
  const double first = half_trace + std::copysign(std::sqrt(discriminant), half_trace);
  const double second = first != 0 ? det / first : 0;
  point.eigenvalues = {first, second};
  point.directions = {direction(a, first), direction(a, second)};
  const int larger = compare_to_1(std::abs(first));
  const int smaller = compare_to_1(std::abs(second));
  if (larger == 0 || smaller == 0) {
    point.kind = FixedPointKind::parabolic;
  } else if (larger == smaller) {
    point.kind = larger > 0 ? FixedPointKind::repelling : FixedPointKind::attracting;
  } else if (first * second < 0) {
    point.kind = FixedPointKind::reversing_saddle;
  } else {
    point.kind = first > 0 ? FixedPointKind::saddle : FixedPointKind::inverse_saddle;
  }
}

FixedPoint describe(const PlanarMap& map, Point at, const FixedPointOptions& options) {
  FixedPoint result;
  result.at = at;
  for (int period = 1; period <= options.period; ++period) {
    if (options.period % period != 0) continue;
    const double share = static_cast<double>(period) / options.period;
    const Displacement here = displacement(map, at, period, {share * options.shift.x, share * options.shift.y});
    if (period < options.period && !(length(here.gap) <= 1e-8 * size_at(at))) continue;
    result.period = period;
    result.derivative = here.derivative;
    result.residual = length(here.gap);
    break;
  }
  classify(result);
  return result;
}

/// The displacements on a grid over a box.
class Scan {
 public:
  Scan(const PlanarMap& map, const Box& box, const FixedPointOptions& options)
      : box_(box), side_(static_cast<std::size_t>(options.grid)), gaps_(side_ * side_) {
    for_each_block(gaps_.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) gaps_[k] = place(k);
      map.iterate(std::span(gaps_).subspan(begin, end - begin), options.period);
      for (std::size_t k = begin; k < end; ++k) {
        const Point z = place(k);
        gaps_[k] = {gaps_[k].x - z.x - options.shift.x, gaps_[k].y - z.y - options.shift.y};
      }
    });
  }

  [[nodiscard]] std::vector<Point> seeds() const {
    std::vector<Point> result;
    for (std::size_t j = 0; j < side_; ++j) {
      for (std::size_t i = 0; i < side_; ++i) {
        if (i + 1 < side_ && j + 1 < side_ && both_change_sign(i, j)) {
          const Point low = place(j * side_ + i), high = place((j + 1) * side_ + i + 1);
          result.push_back({0.5 * (low.x + high.x), 0.5 * (low.y + high.y)});
        }
        if (least_among_neighbours(i, j)) result.push_back(place(j * side_ + i));
      }
    }
    return result;
  }

  [[nodiscard]] double cell() const { return std::hypot(box_.width(), box_.height()) / static_cast<double>(side_ - 1); }

  [[nodiscard]] std::string nearest() const {
    const auto least = std::min_element(gaps_.begin(), gaps_.end(), [](Point a, Point b) {
      return is_finite(a) && (!is_finite(b) || length(a) < length(b));
    });
    if (!is_finite(*least)) return "no point of the box has an image";
    return "the displacement is least, " + shortest(length(*least)) + ", at " +
           text(place(static_cast<std::size_t>(least - gaps_.begin())));
  }

 private:
  [[nodiscard]] Point place(std::size_t k) const {
    const double steps = static_cast<double>(side_ - 1);
    return {box_.min_x() + box_.width() * (static_cast<double>(k % side_) / steps),
            box_.min_y() + box_.height() * (static_cast<double>(k / side_) / steps)};
  }
  [[nodiscard]] bool both_change_sign(std::size_t i, std::size_t j) const {
    const std::array<Point, 4> corner{gaps_[j * side_ + i], gaps_[j * side_ + i + 1], gaps_[(j + 1) * side_ + i],
                                      gaps_[(j + 1) * side_ + i + 1]};
    const auto changes = [&](double Point::*part) {
      const bool any_up = std::any_of(corner.begin(), corner.end(), [&](Point g) { return g.*part >= 0; });
      const bool any_down = std::any_of(corner.begin(), corner.end(), [&](Point g) { return g.*part <= 0; });
      return any_up && any_down;
    };
    return changes(&Point::x) && changes(&Point::y);
  }
  [[nodiscard]] bool least_among_neighbours(std::size_t i, std::size_t j) const {
    const double here = length(gaps_[j * side_ + i]);
    if (!std::isfinite(here)) return false;
    for (std::size_t row = j == 0 ? 0 : j - 1; row <= std::min(j + 1, side_ - 1); ++row) {
      for (std::size_t column = i == 0 ? 0 : i - 1; column <= std::min(i + 1, side_ - 1); ++column) {
        if (length(gaps_[row * side_ + column]) < here) return false;
      }
    }
    return true;
  }

  Box box_;
  std::size_t side_;
  std::vector<Point> gaps_;
};

bool in_box(const Box& box, Point z) {
  const double slack = 1e-9 * (1 + box.extent());
  return box.min_x() - slack <= z.x && z.x <= box.max_x() + slack && box.min_y() - slack <= z.y &&
         z.y <= box.max_y() + slack;
}

}  // namespace

std::string_view name_of(FixedPointKind kind) {
  switch (kind) {
    case FixedPointKind::saddle:
      return "saddle";
    case FixedPointKind::inverse_saddle:
      return "inverse saddle";
    case FixedPointKind::reversing_saddle:
      return "saddle, orientation reversed";
    case FixedPointKind::centre:
      return "centre";
    case FixedPointKind::parabolic:
      return "parabolic";
    case FixedPointKind::attracting:
      return "attracting";
    case FixedPointKind::repelling:
      return "repelling";
  }
  return "";
}

FixedPoint find_fixed_point(const PlanarMap& map, Point guess, const FixedPointOptions& options) {
  require(options);
  const NewtonEnd end = newton(map, guess, options, 0.5 * size_at(guess));
  if (!end.converged) {
    throw DataError("no point of period " + std::to_string(options.period) + " found from " + text(guess) +
                    (std::isfinite(end.residual)
                         ? ": Newton's method ended at " + text(end.at) + ", off by " + shortest(end.residual)
                         : ": it has no image under the map"));
  }
  return describe(map, end.at, options);
}

std::vector<FixedPoint> find_fixed_points(const PlanarMap& map, const Box& box, const FixedPointOptions& options) {
  require(options);
  if (!(box.width() > 0 && box.height() > 0)) throw UsageError("the box of a scan for fixed points is empty");
  const Scan scan(map, box, options);
  const std::vector<Point> seeds = scan.seeds();
  std::vector<std::optional<FixedPoint>> found(seeds.size());
  for_each_block(seeds.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const NewtonEnd newton_end = newton(map, seeds[k], options, 2 * scan.cell());
      if (newton_end.converged && in_box(box, newton_end.at)) found[k] = describe(map, newton_end.at, options);
    }
  });
  std::vector<FixedPoint> result;
  for (const std::optional<FixedPoint>& point : found) {
    if (!point) continue;
    const auto same = std::find_if(result.begin(), result.end(), [&](const FixedPoint& other) {
      return length({other.at.x - point->at.x, other.at.y - point->at.y}) <= 1e-6 * size_at(other.at);
    });
    if (same == result.end()) {
      result.push_back(*point);
    } else if (point->residual < same->residual) {
      *same = *point;
    }
  }
  if (result.empty()) {
    throw DataError("no point of period " + std::to_string(options.period) + " in [" + shortest(box.min_x()) + ", " +
                    shortest(box.max_x()) + "] x [" + shortest(box.min_y()) + ", " + shortest(box.max_y()) +
                    "]: " + scan.nearest());
  }
  std::sort(result.begin(), result.end(), [](const FixedPoint& a, const FixedPoint& b) {
    return std::tuple(a.period, a.at.x, a.at.y) < std::tuple(b.period, b.at.x, b.at.y);
  });
  return result;
}

}  // namespace lober

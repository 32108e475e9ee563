// Whether the functions of a library's map belong together: its derivative, inverse, lattice and action.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/systems/library_checks.hpp"
#include "engine/dynamics/systems/library_differences.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// Allowed error of an iterated inverse, as a fraction; slips are far larger.
constexpr double inverse_accuracy = 1e-6;

class MapChecks {
 public:
  MapChecks(const lober_system& system, const System& made, std::span<const double> parameters)
      : system_(system), made_(made), map_(*system.map), parameters_(parameters.data()) {}

  void at(Point z) {
    const Point image = apply(map_.forward, z);
    if (!is_finite(image)) return;
    ++images_;
    std::array<double, 4> d{};
    const std::array<double, 2> from{z.x, z.y};
    if (map_.derivative(parameters_, from.data(), d.data()) != 0) return;
    if (!std::all_of(d.begin(), d.end(), [](double entry) { return std::isfinite(entry); })) return;
    ++derivatives_;
    check_derivative(z, d);
    check_inverse(z, image, d);
    for (const Point shift : {made_.lattice, made_.second_lattice}) check_lattice(z, image, shift, d);
    if (map_.action != nullptr) check_action(z, image);
  }
  // A function that never gives a number is a slip; one that fails at some points may be right.
  void require_numbers() const {
    if (images_ == 0 || derivatives_ > 0) return;
    throw DataError(system_prefix(system_.name) +
                    "derivative fails, or gives no number, at all points of the window that have images");
  }

 private:
  [[nodiscard]] Point apply(int (*function)(const double*, const double*, double*), Point z) const {
    const std::array<double, 2> from{z.x, z.y};
    std::array<double, 2> to{};
    return function(parameters_, from.data(), to.data()) != 0 ? lost_point : Point{to[0], to[1]};
  }

  void check_derivative(Point z, const std::array<double, 4>& d) const {
    constexpr std::array names{"dx'/dx", "dx'/dy", "dy'/dx", "dy'/dy"};
    const double size = std::fabs(d[0]) + std::fabs(d[1]) + std::fabs(d[2]) + std::fabs(d[3]);
    for (std::size_t k = 0; k < 4; ++k) {
      const bool by_x = k % 2 == 0;
      const Slope slope = slope_of(
          [&](double value) {
            const Point image = apply(map_.forward, by_x ? Point{value, z.y} : Point{z.x, value});
            return k < 2 ? image.x : image.y;
          },
          by_x ? z.x : z.y, size_within(extent_of(made_.window), length(z)));
      if (differs(d[k], slope, size)) {
        throw_discrepancy(system_.name, std::string("the derivative ") + names[k], format_point(z), {"it is", d[k]},
                          {"finite differences of forward give", slope.value});
      }
    }
  }

  void check_inverse(Point z, Point image, const std::array<double, 4>& d) const {
    const Point back = apply(map_.backward, image);
    if (!is_finite(back)) {
      throw DataError(system_prefix(system_.name) + "backward fails at " + format_point(image) + ", the image of " +
                      format_point(z));
    }
    // The inverse stretches the rounding of the image.
    const double determinant = std::fabs(d[0] * d[3] - d[1] * d[2]);
    const double norm = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2]), std::fabs(d[3]), determinant});
    const double stretch = determinant > 0 ? 1 + norm / determinant : 1 / difference_accuracy;
    const double gap = length({back.x - z.x, back.y - z.y});
    if (gap <= inverse_accuracy * stretch * (size_within(extent_of(made_.window), length(z)) + length(image))) return;
    throw DataError(system_prefix(system_.name) + "backward is not the inverse of forward: it takes the image of " +
                    format_point(z) + " to " + format_point(back));
  }

  void check_lattice(Point z, Point image, Point shift, const std::array<double, 4>& d) const {
    if (shift == Point{}) return;
    const Point there = apply(map_.forward, {z.x + shift.x, z.y + shift.y});
    if (!is_finite(there)) return;
    const double stretch = 1 + std::fabs(d[0]) + std::fabs(d[1]) + std::fabs(d[2]) + std::fabs(d[3]);
    const double gap = length({there.x - image.x - shift.x, there.y - image.y - shift.y});
    if (gap <= symmetry_accuracy * stretch * (length(shift) + length(image))) return;
    throw DataError(system_prefix(system_.name) + "the map does not repeat after the shift " + format_point(shift) +
                    " of its lattice: it takes " + format_point(z) + " to " + format_point(image) +
                    ", and the shifted point to " + format_point(there));
  }

  // dL = y' dx' - y dx.
  void check_action(Point z, Point image) const {
    const double scale = size_within(extent_of(made_.window), length(z));
    const Slope to = slope_of([&](double x) { return map_.action(parameters_, z.x, x); }, image.x, scale);
    const Slope from = slope_of([&](double x) { return map_.action(parameters_, x, image.x); }, z.x, scale);
    if (differs(image.y, to, 1)) {
      throw_discrepancy(system_.name, "the action L(x, x')", format_point(z), {"dL/dx' is", to.value},
                        {"y' is", image.y});
    }
    if (differs(-z.y, from, 1)) {
      throw_discrepancy(system_.name, "the action L(x, x')", format_point(z), {"dL/dx is", from.value},
                        {"-y is", -z.y});
    }
  }

  const lober_system& system_;
  const System& made_;
  const lober_map& map_;
  const double* parameters_;
  std::size_t images_ = 0, derivatives_ = 0;  // points that have them
};

}  // namespace

void check_library_map(const lober_system& system, const System& made, std::span<const double> parameters) {
  MapChecks checks(system, made, parameters);
  for (const Point& z : window_points(made.window)) checks.at(z);
  checks.require_numbers();
}

}  // namespace lober::detail

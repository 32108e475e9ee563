#include "lober/transport.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/transport/comparisons.hpp"
#include "engine/dynamics/transport/cylinder.hpp"
#include "engine/dynamics/transport/particles.hpp"
#include "engine/dynamics/transport/series.hpp"
#include "engine/dynamics/transport/tangle_growth.hpp"
#include "kernels/box.hpp"
#include "lober/error.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// The formulas hold for maps that preserve area. The determinant of the derivative at a saddle tells, to what its
// cancellation leaves of it.
void require_areas_preserved(const PlanarMap& map, Point saddle) {
  Matrix2 a;
  map.iterate_with_derivative(saddle, 1, a);
  const double largest = std::max({std::fabs(a.xx), std::fabs(a.xy), std::fabs(a.yx), std::fabs(a.yy)});
  const double factor = std::fabs(a.xx * a.yy - a.xy * a.yx);
  if (std::fabs(factor - 1) <= 1e-3 + 1e-10 * largest * largest) return;
  throw DataError("transport: the map does not preserve area, it multiplies it by " + format_number(factor) +
                  " at the saddle " + format_point(saddle) + "; lober tangle lists its lobes");
}

class Builder {
 public:
  Builder(const PlanarMap& map, const TransportOptions& options) : map_(map), options_(options) {}

  Transport build(const Connection& connection) {
    begin(connection);
    std::optional<TransportSeries> series;
    for (int n = 1; n <= options_.iterates; ++n) {
      report("n = " + std::to_string(n));
      if (!grow_to(n)) break;
      if (series) {
        series->extend(barriers());
      } else {
        series.emplace(barriers(), cylinder_ ? std::optional(Point{0, 0}) : std::nullopt);
      }
      result_.steps.push_back(series->next());
      compare_routes(result_.agreement, series->partition(), result_.steps.back());
      if (options_.on_step) options_.on_step(result_.steps.back(), result_.agreement);
    }
    series->extend(barriers());  // of what there is now: the last growth may have added to it without a row
    finish(*series);
    return std::move(result_);
  }

 private:
  // A boundary as the series sees it; on a cylinder both curves there, and their tangle.
  struct SeriesBoundary {
    std::vector<Point> wrapped_u, wrapped_s;
    std::unique_ptr<Tangle> wrapped;
    Barrier barrier;
  };

  void report(const std::string& line) const {
    if (options_.progress && !options_.progress(line)) throw Cancelled();
  }

  void begin(const Connection& connection) {
    std::vector<Connection> connections{connection};
    if (options_.bip_near) connections[0].bip = options_.bip_near;
    connections.insert(connections.end(), options_.further.begin(), options_.further.end());
    ManifoldTangleOptions growth;
    growth.tolerance = options_.tolerance;
    growth.max_points = options_.max_points;
    growth.max_work = options_.max_work;
    growth.budget = options_.budget;
    growth.progress = options_.progress;
    growth.bip_near = options_.bip_near;
    for (const Connection& one : connections) {
      growths_.push_back(std::make_unique<TangleGrowth>(map_, one, growth));
      boundaries_.emplace_back();
      result_.boundaries.emplace_back().connection = one;
      growth.bip_near.reset();
    }
  }

  // Images of the bip that n takes.
  [[nodiscard]] static int images_before(int n) { return std::max(1 + (n - 1) / 2, n / 2); }
  [[nodiscard]] static int images_after(int n) { return n - n / 2; }

  // Whether all tangles are there as far as n takes. Sets boundaries and barriers to what is there.
  bool grow_to(int n) {
    std::string limit;
    for (const std::unique_ptr<TangleGrowth>& growth : growths_) {
      if (limit.empty() && !growth->grow_to(images_before(n), images_after(n))) limit = growth->limit();
    }
    if (!limit.empty() && n == 1) throw DataError(limit);
    if (n == 1) {
      for (std::size_t c = 0; c < growths_.size(); ++c) check(result_.boundaries[c].connection, growths_[c]->current());
    }
    set_barriers(limit.empty() ? n : n - 1);
    if (limit.empty()) return true;
    result_.remarks.push_back("n = 1 to " + std::to_string(n - 1) + " of " + std::to_string(options_.iterates) + ": " +
                              limit);
    return false;
  }

  // What closes the boundary has to stay where it is: else fluid crosses there, and neither route counts it.
  void require_closure_kept(const Connection& connection, const ManifoldTangle& manifolds) const {
    constexpr int samples = 7;
    constexpr double kept = 1e-6;
    std::vector<Point> path{manifolds.local_s.saddle};
    path.insert(path.end(), connection.closure.begin(), connection.closure.end());
    path.push_back(manifolds.local_u.saddle);
    double length = 0;
    for (std::size_t k = 1; k < path.size(); ++k) length += distance(path[k - 1], path[k]);
    if (length <= kept * (1 + lober::length(path[0]))) return;  // homoclinic
    const auto away = [&](Point z) {
      double nearest = length;
      for (std::size_t k = 1; k < path.size(); ++k) {
        const Point a = path[k - 1], along{path[k].x - a.x, path[k].y - a.y}, to{z.x - a.x, z.y - a.y};
        const double square = along.x * along.x + along.y * along.y;
        const double t = square > 0 ? std::clamp((to.x * along.x + to.y * along.y) / square, 0.0, 1.0) : 0;
        nearest = std::min(nearest, distance(z, {a.x + t * along.x, a.y + t * along.y}));
      }
      return nearest;
    };
    for (std::size_t k = 1; k < path.size(); ++k) {
      for (int i = 1; i <= samples; ++i) {
        const double t = static_cast<double>(i) / (samples + 1);
        const Point at{path[k - 1].x + t * (path[k].x - path[k - 1].x),
                       path[k - 1].y + t * (path[k].y - path[k - 1].y)};
        Point image = at;
        map_.iterate({&image, 1}, 1);
        if (is_finite(image) && away(image) <= kept * length) continue;
        throw DataError("transport: the boundary of R1 is closed from " + format_point(path.front()) + " to " +
                        format_point(path.back()) + " by a path that the map does not keep: it takes " +
                        format_point(at) + " to " + format_point(image) +
                        ", so that fluid crosses there too; give the path that it keeps (closure) or the period of the "
                        "plane (lattice) in the description of the system. lober tangle lists the lobes");
      }
    }
  }

  void check(const Connection& connection, const ManifoldTangle& manifolds) {
    require_areas_preserved(map_, manifolds.local_u.saddle);
    if (options_.lattice == Point{}) require_closure_kept(connection, manifolds);
    for (Comparison& one : agreement_of(manifolds).comparisons) result_.agreement.compare(std::move(one));
    if (result_.iterates_a_step == 2) return;
    if (manifolds.local_u.multiplier < 0 || manifolds.local_s.multiplier < 0) {
      result_.iterates_a_step = 2;
      result_.remarks.emplace_back(
          "both multipliers of a saddle are negative, so that its manifolds swap sides in every iterate: n counts "
          "second iterates of the map");
    }
  }

  void set_barriers(int n) {
    if (!(options_.lattice == Point{})) set_cylinder();
    for (std::size_t c = 0; c < growths_.size(); ++c) {
      SeriesBoundary& boundary = boundaries_[c];
      const ManifoldTangle& manifolds = growths_[c]->current();
      Barrier& barrier = boundary.barrier;
      barrier.tangle = &manifolds.tangle;
      barrier.bip = manifolds.bip;
      barrier.period = manifolds.period();
      barrier.closure = result_.boundaries[c].connection.closure;
      barrier.curve_error = std::max(manifolds.point_error_u, manifolds.point_error_s);
      barrier.lobes_include_it = !cylinder_;
      if (!cylinder_) {
        barrier.fine = box_of(manifolds.fine);
        barrier.true_size = box_of(manifolds.true_size);
      }
      if (cylinder_) {
        // Points that are added where circles bend lie unevenly, and the smooth curves through them are worse than
        // their error estimates: by up to a thousandth of the tolerance, measured on the standard map for K = 0.4 to 5.
        constexpr double unevenness = 2e-3;
        barrier.curve_error += unevenness * manifolds.tolerance;
        wrap(boundary, manifolds, n);
      }
    }
  }
  [[nodiscard]] std::vector<Barrier> barriers() const {
    std::vector<Barrier> list;
    for (const SeriesBoundary& boundary : boundaries_) list.push_back(boundary.barrier);
    return list;
  }

  // Deep enough for all that was grown.
  void set_cylinder() {
    double low = 0, high = 0;
    for (const std::unique_ptr<TangleGrowth>& growth : growths_) {
      for (const GrownManifold* grown : {&growth->current().u, &growth->current().s}) {
        for (const Point& point : grown->points) {
          const double height = Cylinder::height(options_.lattice, point);
          low = std::min(low, height);
          high = std::max(high, height);
        }
      }
    }
    const double period = std::hypot(options_.lattice.x, options_.lattice.y);
    cylinder_.emplace(options_.lattice, -low + std::max(0.25 * (high - low), 0.25 * period));
  }

  // The tangle on the cylinder, as fine as it takes for polygons to have the pips there that the plane has.
  void wrap(SeriesBoundary& boundary, const ManifoldTangle& manifolds, int n) {
    constexpr int max_refinements = 5;
    for (int k = 0; k <= max_refinements; ++k) {
      wrap_to(boundary, manifolds, manifolds.tolerance / std::pow(10, k));
      if (has_pips_of_plane(boundary, manifolds, n)) return;
    }
    throw DataError(
        "transport: on the cylinder manifolds cross elsewhere than in the plane, by those of the neighbouring "
        "cells or because they lie too close to each other: the bip " +
        format_point(manifolds.orbits.back().at) + " bounds no region of it");
  }

  [[nodiscard]] bool has_pips_of_plane(const SeriesBoundary& boundary, const ManifoldTangle& manifolds, int n) const {
    const Tangle& there = *boundary.wrapped;
    const Barrier& barrier = boundary.barrier;
    if (barrier.images_before() < images_before(n) || barrier.images_after() < images_after(n)) return false;
    const auto first = static_cast<std::ptrdiff_t>(barrier.period) * -images_before(n);
    const auto last = static_cast<std::ptrdiff_t>(barrier.period) * images_after(n);
    for (std::ptrdiff_t k = first; k <= last; ++k) {
      const auto number = [&](std::size_t bip) {
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(bip) + k);
      };
      const Point there_too = cylinder_->wrap(manifolds.tangle.pips[number(manifolds.bip)].at);
      if (!(distance(there.pips[number(barrier.bip)].at, there_too) <= 1e3 * manifolds.tolerance)) return false;
    }
    return true;
  }

  void wrap_to(SeriesBoundary& boundary, const ManifoldTangle& manifolds, double tolerance) {
    const Cylinder& cylinder = *cylinder_;
    boundary.wrapped_u = wrapped(cylinder, map_, manifolds.local_u, manifolds.u, tolerance);
    boundary.wrapped_s = wrapped(cylinder, map_, manifolds.local_s, manifolds.s, tolerance);
    // One and the same saddle, to the bit: else they might cross there.
    if (distance(boundary.wrapped_u[0], boundary.wrapped_s[0]) <= 1e-8 * (1 + std::fabs(boundary.wrapped_u[0].x))) {
      boundary.wrapped_s[0] = boundary.wrapped_u[0];
    }
    TangleOptions options;
    options.bip_near = cylinder.wrap(manifolds.orbits.back().at);
    options.period = static_cast<std::uint32_t>(manifolds.period());
    options.smooth = true;
    const OpenCurve u = OpenCurve::borrow(boundary.wrapped_u), s = OpenCurve::borrow(boundary.wrapped_s);
    try {
      boundary.wrapped = std::make_unique<Tangle>(tangle(u, s, options));
    } catch (const NotSimpleError&) {  // arcs closer to each other than polygons show
      options.check_simple = false;
      boundary.wrapped = std::make_unique<Tangle>(tangle(u, s, options));
    }
    if (!boundary.wrapped->boundary) throw DataError("transport: the manifolds do not cross on the cylinder");
    boundary.barrier.tangle = boundary.wrapped.get();
    boundary.barrier.bip = boundary.wrapped->boundary->bip;
  }

  void finish(const TransportSeries& series) {
    result_.regions = series.partition().regions();
    const std::vector<Barrier> last = barriers();
    for (std::size_t c = 0; c < growths_.size(); ++c) {
      TransportBoundary& boundary = result_.boundaries[c];
      boundary.point_error = last[c].curve_error;
      boundary.enclosed = enclosed_area(last[c], 0);
      boundary.area12 = series.turnstiles()[c].area12();
      boundary.area21 = series.turnstiles()[c].area21();
      boundary.manifolds = growths_[c]->take();
      const ManifoldTangle& manifolds = *boundary.manifolds;
      result_.remarks.insert(result_.remarks.end(), manifolds.tangle.remarks.begin(), manifolds.tangle.remarks.end());
      boundary.action12 = boundary.action21 = manifolds.areas_by_action.empty() ? unknown : 0;
      for (std::size_t k = 0; k < manifolds.areas_by_action.size(); ++k) {
        const bool leaves = manifolds.tangle.images.labels[manifolds.image_of_bip(-1) + k].from == 1;
        (leaves ? boundary.action12 : boundary.action21) += std::fabs(manifolds.areas_by_action[k]);
      }
    }
    if (options_.particles > 0) {
      ParticleOptions how;
      how.count = options_.particles;
      how.seed = options_.seed;
      how.progress = [&](double) { return !options_.progress || options_.progress("particles"); };
      const auto stride = static_cast<std::size_t>(result_.iterates_a_step);
      const std::vector<RegionMatrix> counted =
          count_particles(map_, cylinder_ ? &*cylinder_ : nullptr, last, series.partition(),
                          static_cast<int>(result_.steps.size() * stride), how);
      for (std::size_t k = 0; k < result_.steps.size(); ++k) {
        result_.steps[k].by_particles = counted[(k + 1) * stride - 1];
        compare_particles(result_.agreement, result_.steps[k]);
      }
    }
  }

  const PlanarMap& map_;
  const TransportOptions& options_;
  std::vector<std::unique_ptr<TangleGrowth>> growths_;
  std::vector<SeriesBoundary> boundaries_;
  std::optional<Cylinder> cylinder_;
  Transport result_;
};

}  // namespace

Transport transport(const PlanarMap& map, const Connection& connection, const TransportOptions& options) {
  if (options.iterates < 1) throw UsageError("transport takes at least one iterate");
  return Builder(map, options).build(connection);
}

}  // namespace lober

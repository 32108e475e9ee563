#include "lober/transport/transport.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/base/quantities.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/base/text.hpp"
#include "engine/base/time_limit.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/transport/tangles/area_preservation.hpp"
#include "engine/dynamics/transport/tangles/tangle_growth.hpp"
#include "engine/dynamics/transport/turnstile/comparisons.hpp"
#include "engine/dynamics/transport/turnstile/cylinder.hpp"
#include "engine/dynamics/transport/turnstile/particles.hpp"
#include "engine/dynamics/transport/turnstile/series.hpp"
#include "kernels/box.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr double no_area = std::numeric_limits<double>::quiet_NaN();

// The inside of boundary c by the names of regions: one of them, unless others are nested in it.
std::string inside_of(std::size_t c, const std::vector<Region>& regions) {
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const std::vector<int>& coefficients = regions[i].coefficients;
    if (coefficients[c + 1] != 1) continue;
    const std::string name = "R" + std::to_string(i + 1);
    const bool nested = std::find(coefficients.begin(), coefficients.end(), -1) != coefficients.end();
    return nested ? "what the outer boundary of " + name + " encloses" : name;
  }
  return "a region";
}

// Where lobes of the turnstile that leave overlap such as enter, the flux is less than their areas in all.
std::string overlap_remark(const TransportBoundary& boundary, const std::string& inside) {
  const double counted_twice = boundary.lobe_area12.value - boundary.flux12.value;
  if (!(counted_twice > boundary.lobe_area12.error + boundary.flux12.error)) return {};
  return "lobes of the turnstile overlap: those that leave have the area " + format_number(boundary.lobe_area12.value) +
         " in all, and " + format_number(boundary.flux12.value) + " leaves " + inside + " in one iterate";
}

class TransportBuilder {
 public:
  TransportBuilder(const PlanarMap& map, const TransportOptions& options) : map_(map), options_(options) {}

  Transport build(const Connection& connection) {
    begin(connection);
    std::optional<TransportSeries> series;
    for (int n = 1; n <= options_.iterates; ++n) {
      report("n = " + std::to_string(n));
      if (!grow_to(n) || !overlaps_are_affordable(n)) break;
      if (!series) series.emplace(barriers());
      TransportStep step;
      const auto take = [&] {
        if (n > 1) series->extend(barriers());
        step = series->next();
      };
      if (!done_within(watch_, seconds_of(options_.budget), take)) {
        if (n == 1) throw DataError("transport: the first row takes longer than the " + std::string(quantity::seconds));
        note_limit(n, "the overlaps of the next row take longer than the " + std::string(quantity::seconds));
        break;
      }
      Agreement agreement;
      compare_routes(agreement, series->partition(), step);
      result_.steps.push_back(std::move(step));
      for (Comparison& one : agreement.comparisons) result_.agreement.compare(std::move(one));
      record(*series);
      if (options_.on_step) options_.on_step(result_.steps.back(), result_.agreement);
    }
    finish(series->partition());
    return std::move(result_);
  }

 private:
  void report(const std::string& line) const {
    if (!options_.progress(line)) throw Cancelled();
  }

  void begin(const Connection& connection) {
    std::vector<Connection> connections{connection};
    if (options_.bip_near) connections[0].bip = options_.bip_near;
    connections.insert(connections.end(), options_.further.begin(), options_.further.end());
    ManifoldTangleOptions growth;
    growth.tolerance = options_.tolerance;
    growth.max_points = options_.max_points;
    growth.max_work = options_.max_work;
    growth.lattice = options_.lattice;
    growth.progress = options_.progress;
    growth.bip_near = options_.bip_near;
    for (const Connection& one : connections) {
      if (options_.budget > 0) growth.budget = std::max(options_.budget - watch_.seconds(), 1e-3);
      if (!done_within(watch_, seconds_of(options_.budget),
                       [&] { growths_.push_back(std::make_unique<TangleGrowth>(map_, one, growth)); })) {
        throw DataError("transport: no turnstile was found within the " + std::string(quantity::seconds));
      }
      result_.boundaries.emplace_back().connection = one;
      growth.bip_near.reset();
    }
  }

  // Images of the bip that n takes.
  [[nodiscard]] static int images_before(int n) { return std::max(1 + (n - 1) / 2, n / 2); }
  [[nodiscard]] static int images_after(int n) { return n - n / 2; }

  // Whether all tangles are there as far as n takes.
  bool grow_to(int n) {
    std::string limit;
    for (const std::unique_ptr<TangleGrowth>& growth : growths_) {
      if (limit.empty() && !growth->grow_to(images_before(n), images_after(n))) limit = growth->limit();
    }
    if (!limit.empty() && n == 1) throw DataError(limit);
    if (n == 1) {
      for (std::size_t c = 0; c < growths_.size(); ++c) check(result_.boundaries[c].connection, growths_[c]->current());
    }
    if (limit.empty()) return true;
    note_limit(n, limit);
    return false;
  }

  // Without a budget: of the plane, since growth looks at translates on a cylinder.
  bool overlaps_are_affordable(int n) {
    // The work for a segment in a row, in evaluations of a map: its lobes overlap those of all rows before.
    constexpr double evaluations_a_segment = 10;
    if (n == 1 || options_.budget > 0 || !(options_.lattice == Point{})) return true;
    double segments = 0;
    for (const std::unique_ptr<TangleGrowth>& growth : growths_) {
      const Tangle& tangle = growth->current().tangle;
      segments += static_cast<double>(tangle.u().segments() + tangle.s().segments());
    }
    if (evaluations_a_segment * segments <= options_.max_work) return true;
    note_limit(n, "the overlaps of the next row, of manifolds with " + format_rounded(segments) +
                      " segments, are more work than is done unasked; a " + std::string(quantity::seconds) +
                      " allows more");
    return false;
  }

  // Why n is not reached.
  void note_limit(int n, const std::string& why) {
    result_.remarks.push_back("n = 1 to " + std::to_string(n - 1) + " of " + std::to_string(options_.iterates) + ": " +
                              why);
  }

  // The closure of the boundary has to stay where it is: else fluid crosses there, and neither route counts it.
  void require_closure_kept(const Connection& connection, const ManifoldTangle& manifolds) const {
    constexpr int samples = 7;
    constexpr double kept = 1e-6;
    std::vector<Point> path{manifolds.local_s.saddle};
    path.insert(path.end(), connection.closure.begin(), connection.closure.end());
    path.push_back(manifolds.local_u.saddle);
    double length = 0;
    for (std::size_t k = 1; k < path.size(); ++k) length += distance(path[k - 1], path[k]);
    if (length <= kept * (map_.unit() + lober::length(path[0]))) return;  // homoclinic
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

  // The barriers of the tangles grown so far.
  [[nodiscard]] std::vector<Barrier> barriers() const {
    std::vector<Barrier> list;
    for (const std::unique_ptr<TangleGrowth>& growth : growths_)
      list.push_back(barrier_of(growth->current(), options_.lattice));
    return list;
  }

  // Records the boundaries as they are with the last row: the tangles may be grown on without another one.
  void record(const TransportSeries& series) {
    for (std::size_t c = 0; c < growths_.size(); ++c) {
      TransportBoundary& boundary = result_.boundaries[c];
      const Turnstile& turnstile = series.turnstiles()[c];
      boundary.enclosed = enclosed_area(turnstile.barrier());
      boundary.flux12 = turnstile.flux12();
      boundary.flux21 = turnstile.flux21();
      boundary.lobe_area12 = turnstile.lobe_area12();
      boundary.lobe_area21 = turnstile.lobe_area21();
      const ManifoldTangle& manifolds = growths_[c]->current();
      boundary.lobe_area12_by_action = boundary.lobe_area21_by_action = manifolds.areas_by_action.empty() ? no_area : 0;
      const std::vector<std::size_t>& leaving = turnstile.lobes(true);
      for (std::size_t k = 0; k < manifolds.areas_by_action.size(); ++k) {
        const bool leaves = std::find(leaving.begin(), leaving.end(), manifolds.image_of_bip(-1) + k) != leaving.end();
        (leaves ? boundary.lobe_area12_by_action : boundary.lobe_area21_by_action) +=
            std::fabs(manifolds.areas_by_action[k]);
      }
    }
  }

  void finish(const Partition& partition) {
    result_.regions = partition.regions();
    const std::vector<Barrier> last = barriers();
    for (std::size_t c = 0; c < growths_.size(); ++c) {
      TransportBoundary& boundary = result_.boundaries[c];
      boundary.point_error = last[c].error_up_to(last[c].bip);
      const ManifoldTangle& manifolds = growths_[c]->current();
      result_.remarks.insert(result_.remarks.end(), manifolds.tangle.remarks.begin(), manifolds.tangle.remarks.end());
      const std::string remark = overlap_remark(boundary, inside_of(c, result_.regions));
      if (!remark.empty()) result_.remarks.push_back(remark);
      const std::string on_closure = remark_on_closure(last[c]);
      if (!on_closure.empty()) result_.remarks.push_back(on_closure);
    }
    if (options_.particles > 0) {
      ParticleOptions how;
      how.count = options_.particles;
      how.seed = options_.seed;
      how.progress = [&](double) { return options_.progress("particles"); };
      const auto stride = static_cast<std::size_t>(result_.iterates_a_step);
      const std::vector<RegionMatrix> counted =
          count_particles(map_, last, partition, static_cast<int>(result_.steps.size() * stride), how);
      for (std::size_t k = 0; k < result_.steps.size(); ++k) {
        result_.steps[k].by_particles = counted[(k + 1) * stride - 1];
        compare_particles(result_.agreement, result_.steps[k]);
      }
    }
    for (std::size_t c = 0; c < growths_.size(); ++c) result_.boundaries[c].manifolds = growths_[c]->take();
  }

  const PlanarMap& map_;
  const TransportOptions& options_;
  std::vector<std::unique_ptr<TangleGrowth>> growths_;
  Stopwatch watch_;
  Transport result_;
};

}  // namespace

Transport transport(const PlanarMap& map, const Connection& connection, const TransportOptions& options) {
  if (options.iterates < 1) throw UsageError("transport takes at least one iterate");
  return TransportBuilder(map, options).build(connection);
}

Transport transport(const System& system, const TransportOptions& options) {
  const std::string& name = system.info.name;
  if (!system.map) throw UsageError("system " + name + " has no planar map");
  if (!system.connection && system.no_connection.empty()) {
    throw UsageError("system " + name + " does not name the saddles of a tangle");
  }
  if (!system.connection) {
    throw DataError("system " + name + " has no tangle of its own at these parameters: " + system.no_connection);
  }
  TransportOptions with_system = options;
  with_system.lattice = system.lattice;
  if (system.further_needed && options.further.empty()) with_system.further = system.further;
  return transport(*system.map, *system.connection, with_system);
}

}  // namespace lober

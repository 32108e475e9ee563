#include "engine/transport/manifold_tangle.hpp"

#include <algorithm>
#include <cmath>

#include "engine/error.hpp"
#include "engine/text.hpp"

namespace lober {
namespace {

// Where manifolds have to be as fine as asked: the saddles, their local manifolds, and eight times as far. What goes
// farther is on its way out and followed coarsely.
Box scene(const LocalManifold& u, const LocalManifold& s) {
  constexpr double times = 8;
  Box box;
  for (const LocalManifold* local : {&u, &s}) {
    for (const double end : {-local->reach, local->reach}) box = unite(box, Box::of(local->saddle, local->at(end)));
  }
  const double margin = times * box.extent();
  return Box::of({box.min_x() - margin, box.min_y() - margin}, {box.max_x() + margin, box.max_y() + margin});
}

// Orbits that escape leave any scale behind in a few steps. Beyond many times the size of the box distances from its
// middle are made logarithmic: a homeomorphism of the plane, so that nothing crosses that did not.
void draw_in(Buffer<Point>& points, const Box& box) {
  constexpr double times = 64;
  const Point middle{(box.min_x() + box.max_x()) / 2, (box.min_y() + box.max_y()) / 2};
  const double radius = times * box.extent();
  for (Point& point : points) {
    const double dx = point.x - middle.x, dy = point.y - middle.y, r = std::hypot(dx, dy);
    if (r <= radius) continue;
    const double factor = (1 + std::log(r / radius)) * (radius / r);
    point = {middle.x + factor * dx, middle.y + factor * dy};
  }
}

// One manifold, and how far it has been grown.
struct Growing {
  LocalManifold local;
  Branch branch;
  GrownManifold grown;
  int iterates = 0;
};

class TangleGrower {
 public:
  TangleGrower(const PlanarMap& map, const Connection& connection, const ManifoldTangleOptions& options)
      : map_(map),
        options_(options),
        bip_near_(options.bip_near ? options.bip_near : connection.bip),
        tolerance_(options.tolerance) {
    u_.local = local_manifold(map, connection.from, ManifoldSide::unstable);
    s_.local = local_manifold(map, connection.to, ManifoldSide::stable);
    // Of a homoclinic tangle both begin in one point, to the bit: else they might cross there.
    if (distance(u_.local.saddle, s_.local.saddle) <= 1e-8 * (1 + std::hypot(u_.local.saddle.x, u_.local.saddle.y)))
      s_.local.saddle = u_.local.saddle;
    u_.branch = branch_towards(u_.local, connection.u_direction);
    s_.branch = branch_towards(s_.local, connection.s_direction);
    box_ = scene(u_.local, s_.local);
  }

  std::unique_ptr<ManifoldTangle> build() {
    grow_all();
    for (int time = 0; tolerance_ > finest * box_.extent(); ++time) {
      const bool refine = odd() ? time < most_if_odd : time < most_refinements && lobes_are_thin();
      if (!refine) break;
      tolerance_ = options_.tolerance / std::pow(10, time + 1);
      grow_all();
    }
    if (odd()) {
      throw DataError(std::to_string(period_) +
                      " pips a period, an odd number: polygons cross where the manifolds, to " + shortest(tolerance_) +
                      ", do not; a finer tolerance of them or of the integration is needed");
    }
    return finish();
  }

 private:
  // Lobes thinner than so many tolerances may be made of the polygons rather than of the manifolds.
  static constexpr double thin = 10;
  static constexpr int most_refinements = 2, most_if_odd = 5;
  static constexpr double finest = 1e-12;  // tolerance, relative to the scene

  void grow_all() {
    near_ = bip_near_;
    period_ = 0;
    grow_to(u_, std::max(u_.iterates, 1));
    grow_to(s_, std::max(s_.iterates, 1));
    for (;;) {
      report();
      const Wanted wanted = look();
      if (wanted.images_u == 0 && wanted.images_s == 0) break;
      if (wanted.images_u > 0) grow_to(u_, u_.iterates + wanted.images_u);
      if (wanted.images_s > 0) grow_to(s_, s_.iterates + wanted.images_s);
    }
  }

  // A map takes pips to pips with the same rho, and those alternate.
  [[nodiscard]] bool odd() const { return period_ % 2 == 1; }

  // Whether a lobe of the turnstile is thin.
  [[nodiscard]] bool lobes_are_thin() const {
    for (std::size_t k = bip_ - std::min<std::size_t>(period_, bip_); k < bip_; ++k) {
      double length = 0;
      for (std::size_t i = found_.pips[k].u.segment; i <= found_.pips[k + 1].u.segment; ++i)
        length += distance(u_.grown.points[i], u_.grown.points[i + 1]);
      if (std::fabs(found_.lobes[k].area) < thin * tolerance_ * length) return true;
    }
    return false;
  }

  struct Wanted {
    int images_u = 0, images_s = 0;
  };

  void report() const {
    if (!options_.progress) return;
    const std::string line =
        "U of " + std::to_string(u_.grown.points.size()) + " points, S of " + std::to_string(s_.grown.points.size());
    if (!options_.progress(line)) throw Cancelled();
  }

  void grow_to(Growing& manifold, int iterates) {
    const char* const name = &manifold == &u_ ? "U" : "S";
    if (iterates > options_.most_iterates) {
      throw DataError(
          std::string(found_.pips.empty() ? "the manifolds do not cross" : "not all images of the bip were found") +
          " within " + std::to_string(options_.most_iterates) + " iterates of " + name);
    }
    GrowthOptions growth;
    growth.tolerance = tolerance_;
    growth.iterates = iterates;
    growth.most_points = options_.most_points;
    growth.box = box_;
    manifold.grown = grow(map_, manifold.local, manifold.branch, growth);
    manifold.iterates = iterates;
    draw_in(manifold.grown.points, box_);
    if (manifold.grown.stop == GrowthStop::points) {
      throw DataError(std::string(name) + " needs more than " + std::to_string(options_.most_points) +
                      " points; it was followed to a length of " + std::to_string(manifold.grown.length));
    }
    if (manifold.grown.stop == GrowthStop::cancelled) throw Cancelled();
    if (manifold.grown.stop == GrowthStop::failed) {
      throw DataError(std::string(name) + " cannot be followed beyond " + std::to_string(manifold.grown.points.size()) +
                      " points: its images escape or cannot be computed");
    }
  }

  // Finds the bip and its images among the pips of what there is, and says what is missing.
  Wanted look() {
    TangleOptions options;
    options.check_simple = false;
    options.period = period_;
    found_ = tangle(u_.grown, s_.grown, options);
    if (found_.pips.empty()) return towards_a_crossing();
    if (!near_) near_ = found_.pips[found_.pips.size() / 2].at;
    bip_ = nearest(*near_);
    if (period_ == 0) {
      const std::optional<std::size_t> next = image_of_bip(1), before = image_of_bip(-1);
      if (next) period_ = static_cast<std::uint32_t>(*next - bip_);
      if (before) period_ = static_cast<std::uint32_t>(bip_ - *before);
      if (period_ == 0) return {1, 1};
    }
    const auto missing = [&](int images, std::size_t there) {
      const std::size_t needed = static_cast<std::size_t>(images) * period_;
      return needed <= there ? 0 : static_cast<int>((needed - there + period_ - 1) / period_);
    };
    return {missing(options_.after, found_.pips.size() - 1 - bip_), missing(options_.before, bip_)};
  }

  // Which manifold to go on with as long as they do not cross: not one that has left the other behind, unless both
  // have.
  [[nodiscard]] Wanted towards_a_crossing() const {
    if (u_.grown.stop == GrowthStop::ended || s_.grown.stop == GrowthStop::ended) {
      throw DataError(std::string("the manifolds do not cross: ") + (u_.grown.stop == GrowthStop::ended ? "U" : "S") +
                      " ends in another fixed point");
    }
    const bool u_near = newest_meets(u_.grown, s_.grown), s_near = newest_meets(s_.grown, u_.grown);
    if (u_near != s_near) return u_near ? Wanted{1, 0} : Wanted{0, 1};
    return u_.iterates <= s_.iterates ? Wanted{1, 0} : Wanted{0, 1};
  }

  // Whether the last generation of one manifold comes to where the other one is.
  [[nodiscard]] static bool newest_meets(const GrownManifold& one, const GrownManifold& other) {
    const Box box = box_of(other.points);
    const std::size_t generations = one.generation_begin.size() - 1;
    for (std::size_t k = one.generation_begin[generations - 1]; k + 1 < one.points.size(); ++k) {
      if (meet(Box::of(one.points[k], one.points[k + 1]), box)) return true;
    }
    return false;
  }

  [[nodiscard]] std::size_t nearest(Point place) const {
    const auto at = std::min_element(found_.pips.begin(), found_.pips.end(), [&](const Pip& x, const Pip& y) {
      return distance(x.at, place) < distance(y.at, place);
    });
    return static_cast<std::size_t>(at - found_.pips.begin());
  }

  // How many images a pip is away from the saddle along a manifold, as a real number: f adds 1 along U and takes 1 away
  // along S, whatever the map.
  struct Time {
    double u, s;
  };
  [[nodiscard]] Time time_of(std::size_t pip) const {
    const auto along = [](const Growing& manifold, Position position) {
      const ManifoldPlace place = place_on(manifold.grown, manifold.local, position);
      return place.images +
             std::log(std::fabs(place.parameter) / manifold.local.reach) / std::log(manifold.local.image().factor);
    };
    return {along(u_, found_.pips[pip].u), along(s_, found_.pips[pip].s)};
  }

  // The pip that is the image of the bip under `steps` of the map, if it is there.
  [[nodiscard]] std::optional<std::size_t> image_of_bip(int steps) const {
    constexpr double close = 0.02;
    const Time bip = time_of(bip_);
    for (std::size_t pip = 0; pip < found_.pips.size(); ++pip) {
      const Time time = time_of(pip);
      if (std::fabs(time.u - bip.u - steps) < close && std::fabs(time.s - bip.s + steps) < close) return pip;
    }
    return std::nullopt;
  }

  std::unique_ptr<ManifoldTangle> finish() {
    auto result = std::make_unique<ManifoldTangle>();
    result->tolerance = tolerance_;
    result->local_u = std::move(u_.local);
    result->local_s = std::move(s_.local);
    result->u = std::move(u_.grown);
    result->s = std::move(s_.grown);
    result->bip = bip_;
    TangleOptions options;
    options.bip = bip_;
    options.period = period_;
    options.smooth = options_.smooth;
    try {
      result->tangle = tangle(result->u, result->s, options);
    } catch (const NotSimpleError& error) {
      if (meet(Box::of(error.at, error.at), box_)) {
        throw DataError(std::string("the polygon of ") + (error.curve == 1 ? "U" : "S") + " crosses itself at " +
                        place_text(error.at) + ": the manifold runs closer to itself there than the tolerance " +
                        shortest(tolerance_) + "; a finer one or fewer iterates are needed");
      }
      options.check_simple = false;
      result->tangle = tangle(result->u, result->s, options);
      result->tangle.remarks.push_back("far outside, where manifolds are followed coarsely, " +
                                       std::string(error.what()));
    }
    if (tolerance_ < options_.tolerance) {
      result->tangle.remarks.push_back("grown to the tolerance " + shortest(tolerance_) +
                                       ", because a lobe of the turnstile is thin");
    }
    for (std::size_t k = bip_ - std::min<std::size_t>(period_, bip_); k <= bip_; ++k) {
      const Pip& pip = result->tangle.pips[k];
      result->orbits.push_back(connecting_orbit(map_, result->local_u, result->local_s,
                                                place_on(result->u, result->local_u, pip.u),
                                                place_on(result->s, result->local_s, pip.s)));
    }
    for (std::size_t k = 0; k + 1 < result->orbits.size(); ++k) {
      if (const auto area = lobe_area_by_action(result->orbits[k], result->orbits[k + 1])) {
        result->areas_by_action.push_back(*area);
      }
    }
    return result;
  }

  const PlanarMap& map_;
  const ManifoldTangleOptions& options_;
  std::optional<Point> bip_near_, near_;
  double tolerance_;
  Growing u_, s_;
  Box box_;
  Tangle found_;
  std::size_t bip_ = 0;
  std::uint32_t period_ = 0;
};

}  // namespace

std::unique_ptr<ManifoldTangle> grow_tangle(const PlanarMap& map, const Connection& connection,
                                            const ManifoldTangleOptions& options) {
  if (options.before < 1 || options.after < 0) throw UsageError("at least one image of the bip before it is needed");
  return TangleGrower(map, connection, options).build();
}

}  // namespace lober

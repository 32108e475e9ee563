// The pips of a growing tangle: until U and S cross, and until a bip and its pre-image are among the crossings.
#include "engine/dynamics/transport/tangles/tangle_growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/transport/tangles/tangle_box.hpp"
#include "kernels/elementary.hpp"

namespace lober::detail {
namespace {

// A pip is taken for the one that is asked for when it lies so near, relative to the scene.
constexpr double near_enough = 0.01;

}  // namespace

void TangleGrowth::find_pips() {
  report();
  TangleOptions options;
  options.check_simple = options.parts = false;
  options.period = period_;
  found_ = tangle(OpenCurve::borrow(u_.growth->grown().points), OpenCurve::borrow(s_.growth->grown().points), options);
}

// The pips of the present curves, and the bip among them.
void TangleGrowth::look() {
  constexpr int max_rounds = 12;
  find_pips();
  for (int round = 0; round < max_rounds && refine_flat_pips(); ++round) find_pips();
  if (!found_.pips.empty()) bip_ = wanted_pip();
}

// Grows until U and S cross, as polygons. False where they do not.
bool TangleGrowth::find_crossing() {
  if (known_bip_ && (!grow(u_, known_bip_->u + beyond) || !grow(s_, known_bip_->s + 1 + beyond))) return false;
  for (find_pips(); found_.pips.empty(); find_pips()) {
    if (!towards_a_crossing()) return false;
  }
  bip_ = wanted_pip();
  return true;
}

// Where the local manifolds are short the tangle may be larger than the scene that they make. Makes that larger, then.
bool TangleGrowth::box_is_too_small() {
  constexpr int max_enlargements = 6;
  constexpr double times = 4;
  const Point at = found_.pips[bip_].at;
  Box tangle = Box::of(at, at);
  const auto add = [&](const Side& side, std::size_t last) {
    const Buffer<Point>& points = side.growth->grown().points;
    for (std::size_t k = 0; k <= std::min(last, points.size() - 1); ++k)
      tangle = union_of(tangle, Box::of(points[k], points[k]));
  };
  add(u_, found_.pips[bip_].u.segment);
  // As far as the lobes of the turnstile reach, once these are known.
  add(s_, found_.pips[bip_ - period_].s.segment);
  if (enlargements_ == max_enlargements || within(tangle, box_)) return false;
  ++enlargements_;
  box_ = square_about(middle_of(box_), times / 2 * box_.extent());
  return true;
}

// Grows until f^-1(q) and q are there. False with the trouble that finer polygons may mend, or without.
bool TangleGrowth::find_turnstile(std::string& trouble) {
  double nearest_so_far = std::numeric_limits<double>::infinity();
  for (look();; look()) {
    if (found_.pips.empty()) {
      if (!towards_a_crossing()) return false;
      continue;
    }
    const Time bip = time_of_pip(bip_);
    const bool far = bip_near_ && distance(found_.pips[bip_].at, *bip_near_) > near_enough * box_.extent();
    // One that is nearer may come with the next image or pre-image, as long as they come nearer: both go to a saddle.
    constexpr double nearer = 0.9;
    const double apart = far ? distance(found_.pips[bip_].at, *bip_near_) : 0;
    if (far && apart < nearer * nearest_so_far) {
      nearest_so_far = apart;
      const bool more_u = u_.growth->time() >= bip.u + 1 + beyond || grow(u_, bip.u + 1 + beyond);
      const bool more_s = s_.growth->time() >= bip.s + 1 + beyond || grow(s_, bip.s + 1 + beyond);
      if (more_u || more_s) continue;
    }
    // Farther along U a pip nearer to halfway may come yet, with the next image of the last one; before that one it is
    // found with the pre-image.
    const bool may_come = !known_bip_ && !near_ && bip_ + 1 == found_.pips.size() && halfway().ahead < 0;
    if (may_come && u_.growth->time() < bip.u + 1 + beyond && grow(u_, bip.u + 1 + beyond)) continue;
    if (s_.growth->time() >= bip.s + 1 + beyond) break;
    if (!grow(s_, bip.s + 1 + beyond)) return false;
  }
  // Before anything is refined for it.
  require_bip_as_asked();
  constexpr double close = 0.02;
  const std::optional<std::size_t> before = image_of_bip(-1, close);
  if (before) {
    period_ = static_cast<std::uint32_t>(bip_ - *before);
  } else {
    trouble = "the pip " + format_point(found_.pips[bip_].at) +
              " has no pre-image among the pips of polygons to the tolerance " + tolerance_text();
  }
  return before.has_value();
}

// The pip that was asked for is among those found, if it is one: the nearest one has its image beside it.
void TangleGrowth::require_bip_as_asked() const {
  if (!options_.bip_near) return;
  constexpr double meant = 0.3;  // relative to how far the bip is from its saddles
  const Point asked = *options_.bip_near, found = found_.pips[bip_].at;
  const double far = std::max(distance(found, u_.local.saddle), distance(found, s_.local.saddle));
  if (distance(found, asked) <= meant * far) return;
  constexpr std::size_t shown = 6;
  const std::size_t first = bip_ - std::min(bip_, shown / 2), last = std::min(first + shown, found_.pips.size());
  std::string pips;
  for (std::size_t k = first; k < last; ++k) pips += (k == first ? "" : ", ") + format_point(found_.pips[k].at);
  throw DataError("no pip was found near the bip asked for, " + format_point(asked) + "; the nearest one is " +
                  format_point(found) + ", and pips about it are " + pips +
                  "; give a bip near a pip, or none for the one halfway from saddle to saddle");
}

// Goes on with one manifold as long as they do not cross: not one that has left the other behind, unless both have.
bool TangleGrowth::towards_a_crossing() {
  for (const Side* const side : {&u_, &s_}) {
    if (side->growth->stop() != GrowthStop::ended) continue;
    limit_ = std::string("the manifolds do not cross: ") + (side == &u_ ? "U" : "S") + " ends in a fixed point";
    return false;
  }
  const bool u_near = newest_meets(u_, s_), s_near = newest_meets(s_, u_);
  // Else the cheaper one: under damping one of them winds into a sink, and the other one far away.
  const bool u_next = u_near != s_near ? u_near : u_.growth->grown().images <= s_.growth->grown().images;
  Side& next = u_next ? u_ : s_;
  return grow(next, next.growth->time() + next.growth->piece());
}

// Whether the last generation of one manifold comes to where the other one is.
bool TangleGrowth::newest_meets(const Side& one, const Side& other) {
  const GrownManifold& grown = one.growth->grown();
  const Box box = box_of(other.growth->grown().points);
  const std::size_t generations = grown.generation_begin.size() - 1;
  for (std::size_t k = grown.generation_begin[generations - 1]; k + 1 < grown.points.size(); ++k) {
    if (meet(Box::of(grown.points[k], grown.points[k + 1]), box)) return true;
  }
  return false;
}

std::size_t TangleGrowth::wanted_pip() const {
  if (known_bip_) return nearest(*known_bip_);
  return near_ ? nearest(*near_) : halfway().pip;
}

// The pip up to which U is as long as S. Along U the one grows and the other one shrinks: one orbit passes nearest to
// there, wherever the plane has its origin, in whatever unit it is, and however far the local manifolds reach.
TangleGrowth::Halfway TangleGrowth::halfway() const {
  const auto lengths = [this](const Side& side, Position Pip::*on) {
    const Buffer<Point>& points = side.growth->grown().points;
    std::vector<double> result(found_.pips.size());
    std::vector<std::size_t> order(result.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return (found_.pips[a].*on).segment < (found_.pips[b].*on).segment;
    });
    double sum = 0;
    std::size_t at = 0;
    for (const std::size_t pip : order) {
      for (; at < (found_.pips[pip].*on).segment; ++at) sum += distance(points[at], points[at + 1]);
      result[pip] = sum + distance(points[at], found_.pips[pip].at);
    }
    return result;
  };
  const std::vector<double> along_u = lengths(u_, &Pip::u), along_s = lengths(s_, &Pip::s);
  // Two that are mirror images are equally near, and polygons of whatever tolerance must not say otherwise: of those
  // that differ by a hundredth of the lengths, the first along U.
  constexpr double nearer = 0.01;
  Halfway best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t pip = 0; pip < found_.pips.size(); ++pip) {
    const double ahead = elementary::log(along_u[pip] / along_s[pip]);
    if (std::fabs(ahead) < std::fabs(best.ahead) - nearer) best = {pip, ahead};
  }
  if (std::fabs(best.ahead) < nearer) best.ahead = 0;
  return best;
}

std::size_t TangleGrowth::nearest(Point point) const {
  const auto at = std::min_element(found_.pips.begin(), found_.pips.end(), [&](const Pip& x, const Pip& y) {
    return distance(x.at, point) < distance(y.at, point);
  });
  return static_cast<std::size_t>(at - found_.pips.begin());
}

std::size_t TangleGrowth::nearest(Time time) const {
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (std::size_t pip = 0; pip < found_.pips.size(); ++pip) {
    const Time there = time_of_pip(pip);
    const double off = std::max(std::fabs(there.u - time.u), std::fabs(there.s - time.s));
    if (off >= nearest) continue;
    nearest = off;
    best = pip;
  }
  return best;
}

std::pair<ManifoldPosition, ManifoldPosition> TangleGrowth::positions_of(std::size_t pip) const {
  return {position_on(u_.growth->grown(), u_.local, found_.pips[pip].u),
          position_on(s_.growth->grown(), s_.local, found_.pips[pip].s)};
}

// How many images a pip is away from the end of the local manifold: f adds 1 along U and takes 1 away along S, whatever
// the map.
TangleGrowth::Time TangleGrowth::time_of_pip(std::size_t pip) const {
  const auto [u, s] = positions_of(pip);
  return {time_of(u_.local, u), time_of(s_.local, s)};
}

// The pip that is the image of the bip under `steps` of the map, if it is there: the one whose times are nearest.
std::optional<std::size_t> TangleGrowth::image_of_bip(int steps, double close) const {
  const Time bip = time_of_pip(bip_);
  double nearest = close;
  std::optional<std::size_t> image;
  for (std::size_t pip = 0; pip < found_.pips.size(); ++pip) {
    const Time time = time_of_pip(pip);
    const double off = std::max(std::fabs(time.u - bip.u - steps), std::fabs(time.s - bip.s + steps));
    if (off >= nearest) continue;
    nearest = off;
    image = pip;
  }
  return image;
}

}  // namespace lober::detail

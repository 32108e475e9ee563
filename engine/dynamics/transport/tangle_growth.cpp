#include "engine/dynamics/transport/tangle_growth.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/transport/point_errors.hpp"
#include "lober/error.hpp"

namespace lober {
namespace {

// The box in which manifolds are followed exactly is larger than that of the saddles and the local manifolds by this.
constexpr double times_scene = 17;

// Where manifolds have to be as fine as asked: the saddles, their local manifolds, and eight times as far. What goes
// farther is on its way out and followed coarsely.
Box scene(const LocalManifold& u, const LocalManifold& s) {
  constexpr double times = (times_scene - 1) / 2;
  Box box;
  for (const LocalManifold* local : {&u, &s}) {
    for (const double end : {-local->reach, local->reach}) box = unite(box, Box::of(local->saddle, local->at(end)));
  }
  const double margin = times * box.extent();
  return Box::of({box.min_x() - margin, box.min_y() - margin}, {box.max_x() + margin, box.max_y() + margin});
}

// Orbits that escape leave any scale behind in a few steps. Beyond many times the size of the box distances from its
// middle are made logarithmic: a homeomorphism of the plane, so that nothing crosses that did not.
constexpr double times_box = 64;

Point middle_of(const Box& box) {
  return {(box.min_x() + box.max_x()) / 2, (box.min_y() + box.max_y()) / 2};
}

Box square_about(Point middle, double reach) {
  return Box::of({middle.x - reach, middle.y - reach}, {middle.x + reach, middle.y + reach});
}

Box true_size(const Box& box) {
  return square_about(middle_of(box), times_box * box.extent() / std::numbers::sqrt2);  // within the circle
}

bool within(const Box& inner, const Box& outer) {
  return outer.min_x() <= inner.min_x() && inner.max_x() <= outer.max_x() && outer.min_y() <= inner.min_y() &&
         inner.max_y() <= outer.max_y();
}

void draw_in(std::span<Point> points, const Box& box) {
  const Point middle = middle_of(box);
  const double radius = times_box * box.extent();
  for (Point& point : points) {
    const double dx = point.x - middle.x, dy = point.y - middle.y, r = std::hypot(dx, dy);
    if (r <= radius) continue;
    const double factor = (1 + std::log(r / radius)) * (radius / r);
    point = {middle.x + factor * dx, middle.y + factor * dy};
  }
}

// Pips are followed so much farther than to where they are, in images.
constexpr double beyond = 0.02;
// Polygons are finer than the splitting by this factor, and than lobes are wide on average by this one.
constexpr double finer_than_splitting = 30, tolerances_wide = 10;
// A pip is taken for the one that is asked for when it lies so near, relative to the scene.
constexpr double near_enough = 0.01;
// How often both are grown anew to a tenth of the tolerance: because of thin lobes, and because of trouble.
constexpr int max_refinements_if_thin = 2, max_refinements = 4;
// Tolerances end at so many roundings of the largest coordinate.
constexpr double finest_roundings = 32;

std::string rounded_text(double value) {
  std::array<char, 32> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 2).ptr;
  return {buffer.data(), end};
}

}  // namespace

TangleGrowth::TangleGrowth(const PlanarMap& map, const Connection& connection, const ManifoldTangleOptions& options)
    : map_(map), options_(options), bip_near_(options.bip_near ? options.bip_near : connection.bip) {
  u_.local = local_manifold(map, connection.from, ManifoldSide::unstable);
  s_.local = local_manifold(map, connection.to, ManifoldSide::stable);
  // Of a homoclinic tangle both begin in one point, to the bit: else they might cross there.
  if (distance(u_.local.saddle, s_.local.saddle) <= 1e-8 * (1 + length(u_.local.saddle)))
    s_.local.saddle = u_.local.saddle;
  u_.branch = branch_towards(u_.local, connection.u_direction);
  s_.branch = branch_towards(s_.local, connection.s_direction);
  box_ = scene(u_.local, s_.local);
  double largest = 0;
  for (const LocalManifold* const local : {&u_.local, &s_.local}) {
    for (const double end : {-local->reach, 0.0, local->reach})
      largest = std::max({largest, std::fabs(local->at(end).x), std::fabs(local->at(end).y)});
  }
  finest_ = finest_roundings * std::numeric_limits<double>::epsilon() * largest;
  work_before_ = map.work();
  begun_ = watch_.seconds();
  if ((u_.local.multiplier < 0) != (s_.local.multiplier < 0)) {
    throw DataError("the map reverses orientation: its multipliers are " + shortest(u_.local.multiplier) +
                    " at the saddle of U and " + shortest(s_.local.multiplier) +
                    " at that of S, so that one of the manifolds swaps sides in every iterate and the other one does "
                    "not; give the second iterate of the map as a system");
  }

  double tolerance = options.tolerance;
  int refined_if_thin = 0, refined = 0;
  for (;;) {
    begin(tolerance);
    std::string trouble;
    if (!find_crossing()) throw DataError(limit_);
    if (box_is_too_small()) continue;
    // Before anything is made of crossings that may be none.
    if (const std::optional<double> wanted = tolerance_for_splitting(); wanted && *wanted < tolerance_) {
      tolerance = *wanted;
      continue;
    }
    if (!find_turnstile(trouble)) {
      if (trouble.empty()) throw DataError(limit_ + by_action());
    } else {
      if (box_is_too_small()) continue;
      trouble = trouble_with_pips();
      if (trouble.empty()) {
        if (refined_if_thin >= max_refinements_if_thin || tolerance_ / 10 < finest_ || !lobes_are_thin()) break;
        ++refined_if_thin;
        tolerance = tolerance_ / 10;
        continue;
      }
    }
    if (++refined > max_refinements || tolerance_ / 10 < finest_) throw DataError(trouble + by_action());
    tolerance = tolerance_ / 10;
  }
  // From here on the bip is this one, whatever other pips further images show nearer to the place that was asked for.
  near_ = orbits_.back().at;
  constexpr double meant = 0.3;  // relative to how far the bip is from its saddles
  const double far = std::max(distance(*near_, u_.local.saddle), distance(*near_, s_.local.saddle));
  if (options_.bip_near && distance(*near_, *options_.bip_near) > meant * far) {
    std::string pips;
    for (std::size_t k = 1; k < orbits_.size(); ++k) pips += (k == 1 ? "" : ", ") + place_text(orbits_[k].at);
    throw DataError("no pip was found near the bip asked for, " + place_text(*options_.bip_near) +
                    "; pips of one period are " + pips);
  }
  finish();
}

void TangleGrowth::begin(double tolerance) {
  images_before_ = images();
  tolerance_ = tolerance;
  near_ = bip_near_;
  period_ = 0;
  limit_.clear();
  found_ = {};
  for (Side* const side : {&u_, &s_}) {
    side->growth.reset();
    side->options = {};
    side->options.tolerance = tolerance;
    side->options.most_points = options_.most_points;
    side->options.whole_pieces = true;
    side->options.box = box_;
    side->options.progress = [this](const GrowthProgress&) {
      // Where orbits are wild a piece may cost far more than those before.
      out_of_work_ = out_of_work_ || images_left() <= 0;
      return !out_of_work_ && (!options_.progress || options_.progress({}));
    };
    side->growth.emplace(map_, side->local, side->branch, side->options);
    side->drawn_in = 0;
  }
  for (Side* const side : {&u_, &s_}) {
    if (!grow(*side, 0)) throw DataError(limit_);
  }
}

// Steps of the map taken so far, by both and by those that were given up for a finer tolerance.
std::uint64_t TangleGrowth::images() const {
  std::uint64_t sum = images_before_;
  for (const Side* const side : {&u_, &s_}) {
    if (side->growth) sum += side->growth->grown().images;
  }
  return sum;
}

// What of the work that may be done is left, as a number of images; by the clock if there is a budget.
double TangleGrowth::images_left() const {
  const auto done = static_cast<double>(images());
  if (options_.budget > 0) {
    constexpr double warm = 0.2;  // seconds after which the speed is known
    const double growing = watch_.seconds() - begun_;
    if (growing < warm || done == 0) return std::numeric_limits<double>::infinity();
    return std::max(options_.budget - watch_.seconds(), 0.0) * done / growing;
  }
  const double work = std::max(static_cast<double>(map_.work() - work_before_), done);
  return std::max(options_.max_work - work, 0.0) * (work > 0 ? done / work : 1);
}

// False, and why in limit_, where it cannot be grown so far.
bool TangleGrowth::grow(Side& side, double end) {
  const std::string name = &side == &u_ ? "U" : "S";
  if (end > options_.most_iterates) {
    limit_ = std::string(found_.pips.empty() ? "the manifolds do not cross" : "not all images of the bip were found") +
             " within " + std::to_string(options_.most_iterates) + " images of the local manifold of " + name;
    return false;
  }
  ManifoldGrowth& growth = *side.growth;
  GrownManifold& grown = growth.grown();
  side.options.max_images = grown.images + static_cast<std::uint64_t>(std::min(images_left(), 1e18));
  const GrowthStop stop = growth.grow_to(end);
  draw_in(std::span(grown.points).subspan(side.drawn_in), box_);
  side.drawn_in = grown.points.size();
  if (stop == GrowthStop::cancelled && !out_of_work_) throw Cancelled();
  if (stop == GrowthStop::points || stop == GrowthStop::cancelled) {
    const bool of_points =
        static_cast<double>(grown.points.size()) + growth.points_needed() > static_cast<double>(options_.most_points);
    limit_ = "U of " + std::to_string(u_.growth->grown().points.size()) + " points, S of " +
             std::to_string(s_.growth->grown().points.size()) + ": the next piece of " + name + " needs " +
             (growth.points_needed() < 1 ? "more points than it seemed to, "
                                         : rounded_text(growth.points_needed()) + " points or more, ");
    limit_ += of_points             ? "--max-points allows " + std::to_string(options_.most_points)
              : options_.budget > 0 ? "which would take longer than --budget"
                                    : "which is more work than is done unasked (--budget SECONDS allows more)";
    return false;
  }
  if (growth.time() >= end) return true;
  limit_ = name + (stop == GrowthStop::ended ? " ends in another fixed point"
                                             : " leaves the neighbourhood of the saddles altogether");
  return false;
}

void TangleGrowth::report() {
  if (!options_.progress) return;
  const std::string line = "U of " + std::to_string(u_.growth->grown().points.size()) + " points, S of " +
                           std::to_string(s_.growth->grown().points.size());
  if (!options_.progress(line)) throw Cancelled();
}

void TangleGrowth::find_pips() {
  report();
  TangleOptions options;
  options.check_simple = false;
  options.period = period_;
  found_ = tangle(OpenCurve::borrow(u_.growth->grown().points), OpenCurve::borrow(s_.growth->grown().points), options);
}

// Puts points into segments and their neighbours that lie where distances are true. Whether there are more points now.
bool TangleGrowth::refine(Side& side, std::vector<std::uint32_t> segments, const Box& box) {
  constexpr int parts = 4;
  GrownManifold& grown = side.growth->grown();
  const std::size_t count = segments.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (segments[k] > 0) segments.push_back(segments[k] - 1);
    if (segments[k] + 2 < grown.points.size()) segments.push_back(segments[k] + 1);
  }
  std::sort(segments.begin(), segments.end());
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  std::erase_if(segments, [&](std::uint32_t k) {
    const auto after =
        std::upper_bound(grown.flaws.begin(), grown.flaws.end(), k,
                         [](std::uint32_t segment, const GrowthFlaw& flaw) { return segment < flaw.first; });
    const bool flawed = after != grown.flaws.begin() && k < std::prev(after)->first + std::prev(after)->count &&
                        std::prev(after)->cause != GrowthFlawCause::left_box;
    const Box ends = Box::of(grown.points[k], grown.points[k + 1]);
    return flawed || !meet(ends, box) || !within(ends, true_size(box_));
  });
  const std::size_t added = side.growth->refine(segments, parts).size();
  side.drawn_in += added;  // what is drawn in lies outside the box, none of it is new
  return added > 0;
}

// Two polygons cross at random where their segments turn by more than the angle between them. Refines them at pips
// where they do; whether there was anything to refine.
bool TangleGrowth::refine_flat_pips() {
  constexpr double trusted = 2;  // angle over turning
  std::vector<std::uint32_t> on_u, on_s;
  const auto turning = [](const Buffer<Point>& points, std::size_t k) {
    double most = 0;
    for (std::size_t i = std::max<std::size_t>(k, 1); i <= std::min(k + 1, points.size() - 2); ++i) {
      const Point a = points[i - 1], b = points[i], c = points[i + 1];
      const Point in{b.x - a.x, b.y - a.y}, out{c.x - b.x, c.y - b.y};
      most = std::max(most, std::fabs(std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y)));
    }
    return most;
  };
  const Buffer<Point>&u = u_.growth->grown().points, &s = s_.growth->grown().points;
  for (const Pip& pip : found_.pips) {
    const std::size_t i = pip.u.segment, j = pip.s.segment;
    if (i + 1 >= u.size() || j + 1 >= s.size()) continue;
    const Point a{u[i + 1].x - u[i].x, u[i + 1].y - u[i].y}, b{s[j + 1].x - s[j].x, s[j + 1].y - s[j].y};
    // S runs the other way, or the same one: the angle between lines.
    const double angle = std::atan2(std::fabs(a.x * b.y - a.y * b.x), std::fabs(a.x * b.x + a.y * b.y));
    if (angle > trusted * (turning(u, i) + turning(s, j))) continue;
    on_u.push_back(static_cast<std::uint32_t>(i));
    on_s.push_back(static_cast<std::uint32_t>(j));
  }
  const bool more_u = refine(u_, std::move(on_u), box_), more_s = refine(s_, std::move(on_s), box_);
  return more_u || more_s;
}

// How far from the saddle a manifold is at a time, as long as that is near.
double TangleGrowth::distance_at(const Side& side, double time) {
  return side.local.reach * std::pow(side.local.image().factor, time);
}

// Images of q come as near to the saddle of one manifold as the other passes it, nearer than the tolerance: its
// segments there have to be short enough to pass on the right side.
void TangleGrowth::refine_near(Side& side, Point saddle, double apart) {
  constexpr int max_rounds = 24;
  constexpr double around = 4, parts = 2;
  if (apart > around * finer_than_splitting * tolerance_) return;
  const double reach = around * apart;
  const Box box = square_about(saddle, reach);
  for (int round = 0; round < max_rounds; ++round) {
    const Buffer<Point>& points = side.growth->grown().points;
    std::vector<std::uint32_t> segments;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      if (distance(points[k], points[k + 1]) > apart / parts && meet(Box::of(points[k], points[k + 1]), box)) {
        segments.push_back(static_cast<std::uint32_t>(k));
      }
    }
    if (segments.empty() || !refine(side, std::move(segments), box_)) return;
  }
}

// Refines a manifold where its polygon crosses itself, and only there.
void TangleGrowth::refine_until_simple(Side& side) {
  constexpr int max_rounds = 8;
  constexpr std::size_t at_once = 20'000;
  for (int round = 0; round < max_rounds; ++round) {
    const IndexedCurve index{CurveView(side.growth->grown())};
    std::vector<std::uint32_t> segments;
    for (const SegmentPair& pair : self_meetings(index, at_once)) {
      segments.push_back(pair.first);
      segments.push_back(pair.second);
    }
    // Also far outside, as long as distances are true: what crosses itself there has lobes in common with others that
    // are not.
    if (segments.empty() || !refine(side, std::move(segments), true_size(box_))) return;
  }
}

// The pips of what there is, and the bip among them.
void TangleGrowth::look() {
  constexpr int max_rounds = 12;
  find_pips();
  for (int round = 0; round < max_rounds && refine_flat_pips(); ++round) find_pips();
  if (found_.pips.empty()) return;
  if (!near_) near_ = found_.pips[found_.pips.size() / 2].at;
  bip_ = nearest(*near_);
}

// Grows until U and S cross, as polygons. False where they do not.
bool TangleGrowth::find_crossing() {
  for (find_pips(); found_.pips.empty(); find_pips()) {
    if (!towards_a_crossing()) return false;
  }
  bip_ = nearest(bip_near_.value_or(found_.pips[found_.pips.size() / 2].at));
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
      tangle = unite(tangle, Box::of(points[k], points[k]));
  };
  add(u_, found_.pips[bip_].u.segment);
  add(s_, found_.pips[bip_].s.segment);
  if (enlargements_ == max_enlargements || within(tangle, box_)) return false;
  ++enlargements_;
  box_ = square_about(middle_of(box_), times / 2 * box_.extent());
  return true;
}

// Grows until f^-1(q) and q are there. False with the trouble that finer polygons may mend, or without.
bool TangleGrowth::find_turnstile(std::string& trouble) {
  for (look();; look()) {
    if (found_.pips.empty()) {
      if (!towards_a_crossing()) return false;
      continue;
    }
    const Time bip = time_of_pip(bip_);
    const bool far = bip_near_ && distance(found_.pips[bip_].at, *bip_near_) > near_enough * box_.extent();
    // One that is nearer may come with the next image.
    if (far && u_.growth->time() < bip.u + 1 && grow(u_, bip.u + 1 + beyond)) continue;
    if (s_.growth->time() >= bip.s + 1 + beyond) break;
    if (!grow(s_, bip.s + 1 + beyond)) return false;
  }
  constexpr double close = 0.02;
  const std::optional<std::size_t> before = image_of_bip(-1, close);
  if (before) {
    period_ = static_cast<std::uint32_t>(bip_ - *before);
  } else {
    trouble = "the pip " + place_text(found_.pips[bip_].at) +
              " has no pre-image among the pips of polygons to the tolerance " + shortest(tolerance_);
  }
  return before.has_value();
}

// Goes on with one manifold as long as they do not cross: not one that has left the other behind, unless both have.
bool TangleGrowth::towards_a_crossing() {
  for (const Side* const side : {&u_, &s_}) {
    if (side->growth->stop() != GrowthStop::ended) continue;
    limit_ = std::string("the manifolds do not cross: ") + (side == &u_ ? "U" : "S") + " ends in another fixed point";
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

std::size_t TangleGrowth::nearest(Point place) const {
  const auto at = std::min_element(found_.pips.begin(), found_.pips.end(), [&](const Pip& x, const Pip& y) {
    return distance(x.at, place) < distance(y.at, place);
  });
  return static_cast<std::size_t>(at - found_.pips.begin());
}

std::pair<ManifoldPlace, ManifoldPlace> TangleGrowth::places_of(std::size_t pip) const {
  return {place_on(u_.growth->grown(), u_.local, found_.pips[pip].u),
          place_on(s_.growth->grown(), s_.local, found_.pips[pip].s)};
}

// How many images a pip is away from the end of the local manifold: f adds 1 along U and takes 1 away along S, whatever
// the map.
TangleGrowth::Time TangleGrowth::time_of_pip(std::size_t pip) const {
  const auto [u, s] = places_of(pip);
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

// The tolerance that polygons need for their crossings to be those of the manifolds; nothing where it is not known.
// Throws DataError where the manifolds coincide.
std::optional<double> TangleGrowth::tolerance_for_splitting() {
  if (!splitting_) {
    const auto [u, s] = places_of(bip_);
    splitting_ = splitting(map_, u_.local, s_.local, u, s);
  }
  if (!splitting_) return std::nullopt;
  if (splitting_->coincide()) {
    throw DataError("the manifolds coincide as far as can be seen: along one iterate they lie no farther apart than " +
                    rounded_text(splitting_->largest) + ", which rounding and integration explain; there are no lobes");
  }
  // Near a pip of that amplitude A polygons are refined until their segments turn by less than the angle at which the
  // manifolds cross, A / L: over a length tolerance / (A / L), with segments of A / L. Together with sqrt(1 /
  // tolerance) elsewhere that makes the fewest points for A^(4/3).
  const double amplitude = splitting_->amplitude, size = box_.extent() / times_scene;
  const double wanted = std::min(amplitude / finer_than_splitting, size * std::pow(amplitude / size, 4.0 / 3));
  if (wanted < finest_) {
    throw DataError("the manifolds lie only " + rounded_text(splitting_->largest) +
                    " apart: no polygons in double precision show how they cross" + by_action());
  }
  return wanted;
}

// Whether a lobe of the turnstile is thin.
bool TangleGrowth::lobes_are_thin() const {
  const Buffer<Point>& points = u_.growth->grown().points;
  for (std::size_t k = bip_ - std::min<std::size_t>(period_, bip_); k < bip_; ++k) {
    double length = 0;
    for (std::size_t i = found_.pips[k].u.segment; i <= found_.pips[k + 1].u.segment; ++i)
      length += distance(points[i], points[i + 1]);
    if (std::fabs(found_.lobes[k].area) < tolerances_wide * tolerance_ * length) return true;
  }
  return false;
}

// Why the pips of the turnstile are not those of the manifolds; empty if they are. Leaves their orbits.
std::string TangleGrowth::trouble_with_pips() {
  const std::string polygons = " (polygons to the tolerance " + shortest(tolerance_) + ")";
  if (period_ % 2 == 1)
    return std::to_string(period_) +
           " pips a period, an odd number: a map takes pips to pips of the same direction, and those alternate" +
           polygons;
  if (splitting_ && splitting_->zeros != period_) {
    return std::to_string(period_) + " pips a period, but the distance of the manifolds changes sign " +
           std::to_string(splitting_->zeros) + " times" + polygons;
  }
  orbits_.clear();
  try {
    for (std::size_t k = bip_ - period_; k <= bip_; ++k) {
      const auto [u, s] = places_of(k);
      orbits_.push_back(connecting_orbit(map_, u_.local, s_.local, u, s));
    }
  } catch (const DataError& error) {
    return error.what() + polygons;
  }
  constexpr double apart = 1e-9;  // in images
  for (std::size_t k = 0; k + 1 < orbits_.size(); ++k) {
    const ConnectingOrbit &first = orbits_[k], &last = orbits_[k + 1];
    if (!(time_of(u_.local, last.u) > time_of(u_.local, first.u) + apart) ||
        !(time_of(s_.local, last.s) < time_of(s_.local, first.s) - apart)) {
      return "two pips near " + place_text(first.at) + " lead to one orbit" + polygons;
    }
    const auto area = lobe_area_by_action(first, last);
    if (area && !(std::fabs(*area) > first.action_error + last.action_error))
      return "a lobe near " + place_text(first.at) + " has no area by action that exceeds its error, " +
             rounded_text(first.action_error + last.action_error) + polygons;
    if (area && std::signbit(*area) != std::signbit(found_.lobes[bip_ - period_ + k].area))
      return "the lobe behind " + place_text(first.at) +
             " lies on one side by its polygon and on the other one by action" + polygons;
  }
  const double turn = time_of(u_.local, orbits_.back().u) - time_of(u_.local, orbits_.front().u);
  if (std::fabs(turn - 1) > 1e-6)
    return "the pip " + place_text(orbits_.back().at) + " is not the image of the pip a period before" + polygons;
  return {};
}

// "; by action ..." where the orbits through the zeros of the splitting are found.
std::string TangleGrowth::by_action() const {
  if (!splitting_ || splitting_->coincide() || splitting_->places.size() < 2) return {};
  std::string text;
  try {
    std::vector<ConnectingOrbit> orbits;
    for (const auto& [u, s] : splitting_->places) orbits.push_back(connecting_orbit(map_, u_.local, s_.local, u, s));
    for (std::size_t k = 0; k + 1 < orbits.size(); ++k) {
      const auto area = lobe_area_by_action(orbits[k], orbits[k + 1]);
      if (!area) return {};
      text += (k == 0 ? "; by action the areas of the lobes are " : ", ") + shortest(*area) + " +- " +
              rounded_text(orbits[k].action_error + orbits[k + 1].action_error);
    }
  } catch (const DataError&) {
    return {};
  }
  return text;
}

bool TangleGrowth::grow_to(int before, int after) {
  before = std::max(before, before_);
  after = std::max(after, after_);
  limit_.clear();
  lend();
  const bool grown = grow_between(before, after);
  if (grown) {
    before_ = before;
    after_ = after;
  } else {
    look();  // one of them may have been grown on
  }
  finish();
  return grown;
}

bool TangleGrowth::grow_between(int before, int after) {
  const Time bip = time_of_pip(bip_);
  // Images of q come nearer to the saddles by the multiplier each time.
  const auto unresolved = [&](const Side& side, double time, int images) {
    const double apart = distance_at(side, time);
    if (apart > finest_) return false;
    limit_ = "the pip f^" + std::to_string(images) + "(q) lies only " + rounded_text(apart) +
             " from its saddle, which coordinates in double precision do not resolve";
    return true;
  };
  if (unresolved(u_, bip.u - before, -before) || unresolved(s_, bip.s - after, after)) return false;
  if (!grow(u_, bip.u + after + beyond) || !grow(s_, bip.s + before + beyond)) return false;
  refine_near(u_, s_.local.saddle, distance_at(s_, bip.s - after));
  refine_near(s_, u_.local.saddle, distance_at(u_, bip.u - before));
  refine_until_simple(u_);
  refine_until_simple(s_);
  look();
  // Times of pips that are nearer to a saddle than the tolerance are rough, but they are counted too.
  constexpr double close = 0.1;
  for (int k = -before; k <= after; ++k) {
    const std::optional<std::size_t> pip = image_of_bip(k, close);
    const auto expected = static_cast<std::ptrdiff_t>(bip_) + static_cast<std::ptrdiff_t>(period_) * k;
    if (pip && static_cast<std::ptrdiff_t>(*pip) == expected) continue;
    limit_ = "polygons to the tolerance " + shortest(tolerance_) + " do not show the pip f^" + std::to_string(k) +
             "(q) where it has to be";
    return false;
  }
  return true;
}

// The points go back to where they grow.
void TangleGrowth::lend() {
  u_.growth->grown() = std::move(result_->u);
  s_.growth->grown() = std::move(result_->s);
}

void TangleGrowth::finish() {
  auto result = std::make_unique<ManifoldTangle>();
  result->tolerance = tolerance_;
  result->local_u = u_.local;
  result->local_s = s_.local;
  result->u = std::move(u_.growth->grown());
  result->s = std::move(s_.growth->grown());
  result->bip = bip_;
  result->splitting_zeros = splitting_ ? splitting_->zeros : 0;
  TangleOptions options;
  options.bip = bip_;
  options.period = period_;
  options.smooth = options_.smooth;
  try {
    result->tangle = tangle(OpenCurve::borrow(result->u.points), OpenCurve::borrow(result->s.points), options);
  } catch (const NotSimpleError& error) {
    options.check_simple = false;
    result->tangle = tangle(OpenCurve::borrow(result->u.points), OpenCurve::borrow(result->s.points), options);
    const bool outside = !meet(Box::of(error.at, error.at), box_);
    result->tangle.remarks.push_back(
        outside
            ? "far outside, where manifolds are followed coarsely, " + std::string(error.what())
            : std::string(error.what()) +
                  ": strands lie closer to each other there than polygons show; areas are those of winding numbers");
  }
  if (tolerance_ < options_.tolerance) {
    result->tangle.remarks.push_back("grown to the tolerance " + shortest(tolerance_) +
                                     ", because lobes of the turnstile are thin");
  }
  result->orbits = orbits_;
  for (std::size_t k = 0; k + 1 < orbits_.size(); ++k) {
    if (const auto area = lobe_area_by_action(orbits_[k], orbits_[k + 1])) {
      result->areas_by_action.push_back(*area);
      result->action_errors.push_back(orbits_[k].action_error + orbits_[k + 1].action_error);
    }
  }
  result->point_error_u = point_error(map_, result->local_u, result->u, box_);
  result->point_error_s = point_error(map_, result->local_s, result->s, box_);
  add_point_errors(*result);
  result->fine = box_;
  result->true_size = true_size(box_);
  add_errors_far_outside(*result);
  result_ = std::move(result);
}

}  // namespace lober

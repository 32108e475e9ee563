// One class, and longer than other files for that: both sides share its tolerance and its limits.
#include "engine/dynamics/transport/tangles/tangle_growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "engine/base/quantities.hpp"
#include "engine/base/text.hpp"
#include "engine/base/time_limit.hpp"
#include "engine/dynamics/manifolds/saddle.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/transport/tangles/point_errors.hpp"
#include "engine/dynamics/transport/tangles/tangle_box.hpp"
#include "kernels/elementary.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// How often both are grown anew to a tenth of the tolerance: because the lobes are coarse, and because of trouble.
constexpr int max_refinements_if_coarse = 4, max_refinements = 4;
// Evaluations of the vector field in a step of the map: trajectories that return take some hundreds or thousands.
constexpr double hardly_returns = 2e4;
// The factor of one iterate at a saddle from which on polygons find no turnstile: for the Duffing oscillator at omega =
// 0.5 (2.7e5), but not at 0.6 (3.5e4).
constexpr double far_stretched = 1e5;
// Tolerances end at this number of roundings of the largest coordinate.
constexpr double finest_roundings = 32;

}  // namespace

std::pair<LocalManifold, LocalManifold> local_manifolds(const PlanarMap& map, const Connection& connection,
                                                        const LocalManifoldOptions& of_u,
                                                        const LocalManifoldOptions& of_s) {
  LocalManifold u = local_manifold(map, connection.from, ManifoldSide::unstable, of_u);
  LocalManifold s = local_manifold(map, connection.to, ManifoldSide::stable, of_s);
  // Both manifolds of a homoclinic tangle begin in one point, to the bit: else they might cross there.
  if (distance(u.saddle, s.saddle) <= 1e-8 * (map.unit() + length(u.saddle))) s.saddle = u.saddle;
  return {std::move(u), std::move(s)};
}

TangleGrowth::TangleGrowth(const PlanarMap& map, const Connection& connection, const ManifoldTangleOptions& options,
                           const KnownStart* known)
    : map_(map),
      options_(options),
      bip_near_(options.bip_near ? options.bip_near : connection.bip),
      closure_(connection.closure),
      caution_(connection.caution) {
  if (known) {
    u_.local = known->local_u;
    s_.local = known->local_s;
    known_orbits_ = known->orbits;
  } else {
    std::tie(u_.local, s_.local) = local_manifolds(map, connection);
  }
  if (known && known->bip) {
    known_bip_ = {time_of(u_.local, known->bip->u), time_of(s_.local, known->bip->s)};
    ends_at_bip_ = true;
    bip_near_.reset();
  }
  u_.branch = branch_towards(u_.local, connection.u_direction);
  s_.branch = branch_towards(s_.local, connection.s_direction);
  box_ = scene(u_.local, s_.local);
  if (const double size = box_.extent() / times_scene; options.tolerance > size) {
    throw UsageError("tolerance: " + format_number(options.tolerance) + " is more than the size of the scene, " +
                     format_rounded(size, 3));
  }
  double largest = 0;
  for (const LocalManifold* const local : {&u_.local, &s_.local}) {
    for (const double end : {-local->reach, 0.0, local->reach})
      largest = std::max({largest, std::fabs(local->at(end).x), std::fabs(local->at(end).y)});
  }
  finest_ = finest_roundings * std::numeric_limits<double>::epsilon() * largest;
  work_before_ = map.work();
  begun_ = watch_.seconds();
  // A sign that is none but that of rounding.
  if (const std::string why = unresolved(stretching()); !why.empty()) {
    throw DataError("the manifolds of the saddle " + format_point(u_.local.saddle) + " cannot be grown" + why);
  }
  if ((u_.local.multiplier < 0) != (s_.local.multiplier < 0)) {
    throw DataError("the map reverses orientation: its multipliers are " + format_number(u_.local.multiplier) +
                    " at the saddle of U and " + format_number(s_.local.multiplier) +
                    " at that of S, so that one of the manifolds swaps sides in every iterate and the other one does "
                    "not; give the second iterate of the map as a system");
  }

  double tolerance = options.tolerance;
  int refined_if_coarse = 0, refined = 0;
  for (;;) {
    begin(tolerance);
    std::string trouble;
    if (!find_crossing()) {
      if (ends_too_early()) continue;
      throw DataError(limit_ + of_saddles());
    }
    if (box_is_too_small()) continue;
    // Before anything is made of crossings that may be none.
    if (const std::optional<double> wanted = tolerance_for_splitting(); wanted && *wanted < tolerance_) {
      tolerance = *wanted;
      continue;
    }
    if (!find_turnstile(trouble)) {
      if (ends_too_early()) continue;
      if (trouble.empty()) throw DataError(limit_ + by_action() + of_saddles());
    } else {
      if (box_is_too_small()) continue;
      trouble = trouble_with_pips();
      if (trouble.empty()) {
        const bool last = refined_if_coarse >= max_refinements_if_coarse || tolerance_ / 10 < finest_;
        if (last || !lobes_are_thin()) {
          // From here on the bip is this one, whatever other pips further images show nearer to the point that was
          // asked for.
          near_ = orbits_.back().at;
          finish();
          rest();
          if (last || agreement_of(*result_).agrees()) {
            require_known_lobes();
            return;
          }
        }
        ++refined_if_coarse;
        tolerance = tolerance_ / 10;
        continue;
      }
    }
    if (++refined > max_refinements || tolerance_ / 10 < finest_) {
      throw DataError(trouble + by_action() + (stretching() > far_stretched ? of_stretching() : ""));
    }
    tolerance = tolerance_ / 10;
  }
}

// A polygon that is followed coarsely somewhere has no area.
void TangleGrowth::require_known_lobes() const {
  for (std::size_t k = bip_ - period_; k < bip_; ++k) {
    if (std::isfinite(result_->tangle.lobes[k].smooth_error)) continue;
    throw DataError("the lobe behind " + format_point(result_->tangle.pips[k].at) +
                    " reaches too far for its area to be known: farther than " + format_rounded(box_.extent()) +
                    by_action());
  }
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
    side->options.max_points = options_.max_points;
    side->options.whole_pieces = true;
    side->options.box = followed();
    side->options.progress = [this](const GrowthProgress&) {
      // Where orbits are wild a piece may cost far more than those before.
      out_of_work_ = out_of_work_ || images_left() <= 0;
      return !out_of_work_ && options_.progress(std::string());
    };
    side->growth.emplace(map_, side->local, side->branch, side->options);
    if (ends_at_bip_) {
      const double enough = side == &u_ ? known_bip_->u : known_bip_->s + 1;
      const double more = elementary::log(spare) / elementary::log(side->local.image().factor);
      side->growth->end_at(enough + std::max(2 * beyond, more));
    }
    side->compressed = side->simple = side->folds_seen = 0;
  }
  for (Side* const side : {&u_, &s_}) {
    if (!grow(*side, 0)) throw DataError(limit_ + of_saddles());
  }
}

// Whether more may be found where manifolds do not end at the known bip; from then on they do not.
bool TangleGrowth::ends_too_early() {
  return std::exchange(ends_at_bip_, false);
}

// Guesses may lead to other saddles than those that were meant.
std::string TangleGrowth::of_saddles() const {
  const std::string of_u = "; U is that of the saddle " + format_point(u_.local.saddle);
  if (u_.local.saddle == s_.local.saddle) return of_u + ", and S too";
  return of_u + ", S that of " + format_point(s_.local.saddle);
}

std::string TangleGrowth::tolerance_text() const {
  const std::string text = format_rounded(tolerance_, 3);
  return tolerance_ < options_.tolerance ? text + ", refined from " + format_rounded(options_.tolerance, 3) : text;
}

double TangleGrowth::stretching() const {
  return std::max(std::fabs(u_.local.multiplier), std::fabs(s_.local.multiplier));
}

std::string TangleGrowth::of_stretching() const {
  return "; one iterate stretches by " + format_rounded(stretching()) +
         " at the saddle, and lobes so long and thin are not resolved in double precision, however long one waits: "
         "try other parameters";
}

// Steps of the map taken so far, by both and by those that were given up for a finer tolerance.
std::uint64_t TangleGrowth::images() const {
  std::uint64_t sum = images_before_;
  for (const Side* const side : {&u_, &s_}) {
    if (side->growth) sum += side->growth->grown().images;
  }
  return sum;
}

// The rest of the allowed work, as a number of images; by the clock if there is a budget.
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
  if (end > options_.max_iterates) {
    limit_ = std::string(found_.pips.empty() ? "the manifolds do not cross" : "not all images of the bip were found") +
             " within " + std::to_string(options_.max_iterates) + " images of the local manifold of " + name;
    return false;
  }
  ManifoldGrowth& growth = *side.growth;
  GrownManifold& grown = growth.grown();
  side.options.max_images = grown.images + static_cast<std::uint64_t>(std::min(images_left(), 1e18));
  const GrowthStop stop = growth.grow_to(end);
  compress_radially(std::span(grown.points).subspan(side.compressed), followed());
  side.compressed = grown.points.size();
  if (stop == GrowthStop::cancelled && !out_of_work_) throw Cancelled();
  if (stop == GrowthStop::points || stop == GrowthStop::cancelled) {
    const bool of_points =
        static_cast<double>(grown.points.size()) + growth.points_needed() > static_cast<double>(options_.max_points);
    limit_ = "U of " + std::to_string(u_.growth->grown().points.size()) + " points, S of " +
             std::to_string(s_.growth->grown().points.size()) + ": the next piece of " + name + " needs " +
             (growth.points_needed() < 1 ? "more points than it seemed to, "
                                         : format_rounded(growth.points_needed()) + " points or more, ");
    limit_ += of_points ? "the " + std::string(quantity::points) + " allows " + std::to_string(options_.max_points) +
                              " for each"
              : options_.budget > 0          ? "which would take longer than the " + std::string(quantity::seconds)
              : stretching() > far_stretched ? "which is more work than is done unasked" + of_stretching()
              : !caution_.empty()
                  ? "which is more work than is done unasked"
                  : "which is more work than is done unasked; a " + std::string(quantity::seconds) + " allows more";
    // More work does not help where the manifolds do not cross at all.
    if (!caution_.empty()) {
      limit_ += "; " + caution_;
    } else if (!result_ && found_.pips.empty()) {
      limit_ +=
          "; U and S have not crossed by then, and do not cross at all where no orbit leads from one saddle to "
          "the other";
    }
    // On a cylinder and after other tangles the map has done more than growing.
    const double an_image =
        static_cast<double>(map_.work() - work_before_) / std::max(static_cast<double>(images()), 1.0);
    if (!result_ && an_image > hardly_returns) {
      limit_ += "; one step of the map takes " + format_rounded(an_image) +
                " evaluations of the vector field: orbits next to this saddle hardly return, or pass a singularity; "
                "try other parameters or " +
                std::string(quantity::saddle) + " instead";
    }
    return false;
  }
  if (growth.time() >= end) return true;
  limit_ = name + (stop == GrowthStop::ended ? " ends in a fixed point"
                                             : " leaves the neighbourhood of the saddles altogether");
  return false;
}

void TangleGrowth::report() {
  if (!options_.progress) return;
  const std::string line = "U of " + std::to_string(u_.growth->grown().points.size()) + " points, S of " +
                           std::to_string(s_.growth->grown().points.size());
  if (!options_.progress(line)) throw Cancelled();
}

bool TangleGrowth::grow_to(int before, int after) {
  if ((before > before_ || after > after_) && compared_before_ > 0 && compares_too_much(segments_expected()))
    return false;
  // Work done with the map since the last call, such as laying curves on a cylinder or growing another tangle, is not
  // growing: the next piece costs none of it.
  work_before_ += map_.work() - work_after_;
  begun_ += watch_.seconds() - ended_;
  before = std::max(before, before_);
  after = std::max(after, after_);
  limit_.clear();
  lend();
  bool grown = false;
  const bool in_time = done_within(watch_, seconds_of(options_.budget), [&] { grown = grow_between(before, after); });
  if (!in_time) {
    limit_ = "the manifolds of the next row take longer than the " + std::string(quantity::seconds);
    grown = false;
  }
  if (grown) {
    before_ = before;
    after_ = after;
  } else {
    look();  // one of them may have been grown on
  }
  finish(in_time);
  rest();
  return grown;
}

bool TangleGrowth::grow_between(int before, int after) {
  const Time bip = time_of_pip(bip_);
  // Images of q come nearer to the saddles by the multiplier each time.
  const auto unresolved = [&](const Side& side, double time, int images) {
    const double apart = distance_at(side, time);
    if (apart > finest_) return false;
    limit_ = "the pip f^" + std::to_string(images) + "(q) lies only " + format_rounded(apart) +
             " from its saddle, which coordinates in double precision do not resolve";
    return true;
  };
  if (unresolved(u_, bip.u - before, -before) || unresolved(s_, bip.s - after, after)) return false;
  if (!grow(u_, bip.u + after + beyond) || !grow(s_, bip.s + before + beyond)) return false;
  for (Side* const side : {&u_, &s_}) {
    refine_near(*side, s_.local.saddle, distance_at(s_, bip.s - after));
    refine_near(*side, u_.local.saddle, distance_at(u_, bip.u - before));
    refine_folds(*side);
  }
  const double segments = segments_to_compare();
  if (before > 1 && segments > 0 && compares_too_much(segments)) return false;
  for (Side* const side : {&u_, &s_}) {
    const std::optional<Point> crosses = refine_until_simple(*side);
    // Overlaps of images of lobes that polygons do not keep apart may be wrong by as much as the lobes.
    if (!crosses || before <= 1) continue;
    limit_ = std::string("the polygon of ") + (side == &u_ ? "U" : "S") + " to the tolerance " + tolerance_text() +
             " crosses itself near " + format_point(*crosses) +
             ": arcs lie closer to each other there than it shows; a " + std::string(quantity::tolerance) +
             " may go farther";
    return false;
  }
  if (segments != compared_) {
    compared_before_ = compared_;
    compared_ = segments_to_compare();
  }
  look();
  // Times of pips that are nearer to a saddle than the tolerance are rough, but they are counted too.
  constexpr double close = 0.1;
  for (int k = -before; k <= after; ++k) {
    const std::optional<std::size_t> pip = image_of_bip(k, close);
    const auto expected = static_cast<std::ptrdiff_t>(bip_) + static_cast<std::ptrdiff_t>(period_) * k;
    if (pip && static_cast<std::ptrdiff_t>(*pip) == expected) continue;
    limit_ = "polygons to the tolerance " + tolerance_text() + " do not show the pip f^" + std::to_string(k) +
             "(q) where it has to be";
    return false;
  }
  return true;
}

void TangleGrowth::rest() {
  work_after_ = map_.work();
  ended_ = watch_.seconds();
}

// The points go back to where they grow.
void TangleGrowth::lend() {
  u_.growth->grown() = std::move(result_->u);
  s_.growth->grown() = std::move(result_->s);
}

void TangleGrowth::finish(bool check_simple) {
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
  options.closure = closure_;
  const bool known_simple = u_.simple == result->u.points.size() && s_.simple == result->s.points.size();
  options.check_simple = check_simple && !known_simple;
  try {
    result->tangle = tangle(OpenCurve::borrow(result->u.points), OpenCurve::borrow(result->s.points), options);
    if (known_simple) {
      SimpleCheck& check = result->tangle.check_simple;
      check = u_.check;
      check.search += s_.check.search;
      check.pairs += s_.check.pairs;
    }
  } catch (const NotSimpleError& error) {
    options.check_simple = false;
    result->tangle = tangle(OpenCurve::borrow(result->u.points), OpenCurve::borrow(result->s.points), options);
    const bool outside = !meet(Box::of(error.at, error.at), followed());
    result->tangle.remarks.push_back(
        outside ? "far outside, where manifolds are followed coarsely, " + std::string(error.what())
                : std::string(error.what()) +
                      ": arcs lie closer to each other there than polygons show; areas are those of winding numbers");
  }
  if (tolerance_ < options_.tolerance) {
    result->tangle.remarks.push_back("grown to the tolerance " + format_rounded(tolerance_) +
                                     ", because lobes of the turnstile are thin or coarsely drawn to " +
                                     format_rounded(options_.tolerance));
  }
  result->orbits = orbits_;
  for (std::size_t k = 0; k + 1 < orbits_.size(); ++k) {
    if (const auto area = lobe_area_by_action(orbits_[k], orbits_[k + 1])) {
      result->areas_by_action.push_back(*area);
      // The area is rounded to double.
      result->action_errors.push_back(orbits_[k].action_error + orbits_[k + 1].action_error +
                                      0x1p-53 * std::fabs(*area));
    }
  }
  add_point_errors(map_, followed(), *result);
  if (!options_.smooth) {  // polygons, which lie within the tolerance of the manifolds
    for (std::size_t k = 0; k < result->tangle.lobes.size(); ++k)
      result->tangle.lobes[k].smooth_error += tolerance_ * perimeter(lobe_outline(result->tangle, k));
  }
  result->fine = followed();
  result->true_size = true_size(followed());
  add_errors_far_outside(*result);
  result_ = std::move(result);
}

}  // namespace lober::detail

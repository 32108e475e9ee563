// One class, and longer than other files for that: every step works on the points of the last generation.
#include "engine/dynamics/manifolds/manifold_growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "engine/base/parallel/insertion.hpp"
#include "engine/base/work_limit.hpp"
#include "engine/dynamics/manifolds/outcome.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "kernels/chebyshev.hpp"
#include "kernels/elementary.hpp"
#include "kernels/point.hpp"
#include "kernels/segment_flags.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// Memory for one point at the peak: two copies with their parameters, flags, counts and the next guide.
constexpr std::size_t bytes_per_point = 120;

// Parameters of P are told apart from here on: P rounds to this number of ulps of the largest coordinate.
constexpr double ulps_apart = 64;

// A piece is stretched by no more than this in one image, but for a little.
constexpr double stretching = 40;

// How much of a segment lies in the box, from 0 to 1: outside of the box segments may be long.
double part_inside(Point a, Point b, const Box& box) {
  double from = 0, to = 1;
  const auto cut = [&](double at, double step, double low, double high) {
    if (step == 0) {
      if (at < low || at > high) to = 0;
      return;
    }
    from = std::max(from, std::min((low - at) / step, (high - at) / step));
    to = std::min(to, std::max((low - at) / step, (high - at) / step));
  };
  cut(a.x, b.x - a.x, box.min_x(), box.max_x());
  cut(a.y, b.y - a.y, box.min_y(), box.max_y());
  return std::max(to - from, 0.0);
}

}  // namespace

ManifoldGrowth::ManifoldGrowth(const PlanarMap& map, const LocalManifold& local, Branch branch,
                               const GrowthOptions& options)
    : map_(map), local_(local), options_(options), side_(static_cast<double>(branch)), work_before_(map.work()) {
  steps_ = local.image().steps;
  ratio_ = local.image().factor;
  pieces_ = std::max(1, static_cast<int>(std::ceil(elementary::log(ratio_) / elementary::log(stretching))));
  if (options.iterates >= 0) limit_ = static_cast<double>(options.iterates) / std::abs(steps_ / local.steps);
  set_up_tracing();
}

void ManifoldGrowth::set_up_tracing() {
  std::vector<double> parameters(257);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    parameters[k] = side_ * local_.reach * static_cast<double>(k) / static_cast<double>(parameters.size() - 1);
  }
  std::vector<Point> points(parameters.size());
  local_.points_at(parameters, points);
  const double extent = box_of(points).extent();
  double largest = 0;
  for (const Point point : points) largest = std::max({largest, std::fabs(point.x), std::fabs(point.y)});
  const double rounding = largest * std::numeric_limits<double>::epsilon();
  if (!(options_.tolerance > 8 * rounding)) {
    throw UsageError("grow: the tolerance is finer than coordinates of this size can resolve");
  }
  trace_options_.tolerance = options_.tolerance;
  trace_options_.batch = std::max(trace_options_.batch, map_.batch());
  trace_options_.max_length = options_.max_length > 0 ? options_.max_length : extent / 50;
  trace_options_.min_spacing = ulps_apart * std::max(rounding, local_.reach * 1e-16);
  trace_options_.cut = !options_.whole_pieces;
  const Point reach{100 * extent, 100 * extent};
  const Box around = Box::of(local_.saddle - reach, local_.saddle + reach);
  trace_options_.box = options_.box.empty() ? around : box_of(options_.box);
  range_ = trace_options_.box;
  if (!meet(Box::of(local_.saddle, local_.saddle), range_)) range_ = union_of(range_, around);
  max_points_ = std::min(options_.max_points, options_.max_memory / bytes_per_point);
  max_points_ = std::min<std::size_t>(max_points_, (std::size_t{1} << 31) - 1);
  if (max_points_ < 2) throw UsageError("grow: the maximum number of points has to be at least 2");
}

GrowthStop ManifoldGrowth::grow_to(double end) {
  const auto grow_pieces = [&] {
    while (stop_ == GrowthStop::iterates && !(time() >= std::min(end, limit_))) grow_piece();
  };
  try {
    if (!completes(grow_pieces, [this] { return out_of_work(); })) stop_ = GrowthStop::work;
  } catch (const Cancelled&) {
    stop_ = GrowthStop::cancelled;
  }
  // One entry more than generations: the number of points.
  result_.generation_begin.resize(generations_);
  result_.generation_begin.push_back(result_.points.size());
  result_.stop = stop_;
  return stop_;
}

// The parameter where part `part` of a generation begins.
double ManifoldGrowth::part_begin(int part) const {
  if (part == pieces_) return local_.reach;
  return local_.reach / elementary::power(ratio_, static_cast<double>(pieces_ - part) / pieces_);
}

void ManifoldGrowth::grow_piece() {
  const bool local = pieces_done_ == 0;
  const int generation = local ? 0 : (pieces_done_ - 1) / pieces_ + 1;
  const int part = local ? 0 : (pieces_done_ - 1) % pieces_;
  const double fraction = limit_ - (generation - 1);  // the wanted part of this generation
  const double end = !local && (part + 1.0) / pieces_ > fraction
                         ? local_.reach * elementary::power(ratio_, fraction - 1)
                         : part_begin(local ? pieces_ : part + 1);
  std::vector<Samples> own;  // what the guides are parts of
  if (local) {
    own.push_back(first_guide(end));
  } else if (generation == 1) {
    own.push_back(part_of_local(previous_[0][0], part));
  } else {
    own = std::move(previous_[static_cast<std::size_t>(part)]);
  }
  std::vector<Guide> guides;
  for (const Samples& samples : own) split(samples, guides);
  link(guides, generation, part);
  std::erase_if(guides, [&](const Guide& guide) { return guide.parameters.front() >= end; });
  const Size before = size();
  if (part == 0) {
    result_.generation_begin.resize(generations_);
    result_.generation_begin.push_back(result_.points.size());
  }
  std::size_t known = 0;
  for (const Guide& guide : guides) known += guide.points.size();
  make_room_for(static_cast<std::size_t>(stretched_ * static_cast<double>(known)));
  std::vector<Samples> sections;
  // Flows keep every thread busy within a section, and would lose more by what is traced beyond a limit.
  if (guides.size() > 1 && map_.work() == 0) sections = appended_together(guides, generation, end);
  bool out_of_points = false;
  for (std::size_t k = sections.size(); k < guides.size() && !out_of_points; ++k) {
    if (result_.length >= options_.length) break;
    std::optional<Trace> trace = traced_within_limits(guides[k], generation, end);
    if (!trace && !options_.whole_pieces && !sections.empty()) {
      out_of_points = true;
      break;
    }
    if (!trace) {
      // As many for each guide that is left as for those so far.
      points_needed_ += static_cast<double>(result_.points.size() - before.points);
      points_needed_ *= static_cast<double>(guides.size()) / static_cast<double>(sections.size() + 1);
      cut_back_to(before);
      stop_ = GrowthStop::points;
      return;
    }
    const bool fits = append(*trace, generation);
    out_of_points = trace->out_of_points || !fits;
    sections.push_back(kept_as_guide(std::move(trace->samples), generation));
  }
  if (known > 0) stretched_ = static_cast<double>(result_.points.size() - before.points) / static_cast<double>(known);
  if (part == 0) ++generations_;
  current_.push_back(std::move(sections));
  ++pieces_done_;
  if (result_.length >= options_.length) {
    end_at_length(generation);
    stop_ = GrowthStop::length;
  } else if (out_of_points) {
    stop_ = GrowthStop::points;
  } else if (local || part == pieces_ - 1) {
    end_generation();
  }
}

ManifoldGrowth::Size ManifoldGrowth::size() const {
  return {result_.points.size(), result_.diagnostics.size(), result_.generation_begin.size(), result_.length};
}

// Before points are appended one section after the other: arrays that double as they fill up are written twice.
void ManifoldGrowth::make_room_for(std::size_t points) {
  const std::size_t size = std::min(result_.points.size() + points + points / 8, max_points_);
  if (size <= result_.points.capacity()) return;
  result_.points.reserve(size);
  result_.parameters.reserve(size);
}

void ManifoldGrowth::cut_back_to(const Size& before) {
  result_.points.resize(before.points);
  result_.parameters.resize(before.points);
  result_.diagnostics.resize(before.diagnostics);
  result_.generation_begin.resize(before.generations);
  result_.length = before.length;
  cut_diagnostics(result_.diagnostics, before.points > 0 ? before.points - 1 : 0);
}

// Whether the generation goes on, and how long it is, are seen before its samples may be dropped: those of the last one
// show the way for none, and their memory serves the next section.
Samples ManifoldGrowth::kept_as_guide(Samples samples, int generation) {
  goes_on_ = goes_on_ || is_alive(samples);
  add_to_generation(samples);
  return generation < limit_ ? std::move(samples) : Samples{};
}

void ManifoldGrowth::end_generation() {
  const bool is_short = generation_length_ < options_.tolerance;
  short_generations_ = is_short ? short_generations_ + 1 : 0;
  if (!goes_on_) {
    stop_ = GrowthStop::failed;
  } else if (short_generations_ >= 2) {
    stop_ = GrowthStop::ended;
  }
  goes_on_ = false;
  generation_length_ = 0;
  previous_ = std::exchange(current_, {});
}

std::vector<std::size_t> ManifoldGrowth::refine(std::span<const std::uint32_t> segments, int parts) {
  struct Insertion {
    std::uint32_t segment;
    int generation;
    double parameter;  // > 0
    Point point;
  };
  Buffer<Insertion> insertions;
  const auto generation_of = [&](std::size_t vertex) {
    const auto& begins = result_.generation_begin;
    return static_cast<int>(std::upper_bound(begins.begin(), begins.end(), vertex) - begins.begin()) - 1;
  };
  for (const std::uint32_t k : segments) {
    const int generation = generation_of(k), next = generation_of(k + 1);
    const double from = side_ * result_.parameters[k];
    const double to = side_ * result_.parameters[k + 1] * elementary::power(ratio_, next - generation);
    const double step = (to - from) / parts;
    if (!(step > trace_options_.min_spacing)) continue;
    for (int j = 1; j < parts; ++j) insertions.push_back({k, generation, from + j * step, {}});
  }
  if (insertions.empty() || insertions.size() > max_points_ - std::min(max_points_, result_.points.size())) return {};
  if (result_.images > options_.max_images) return {};
  for_each_block(insertions.size(), trace_options_.batch, [&](std::size_t first, std::size_t last) {
    for (std::size_t begin = first, end = first; begin < last; begin = end) {
      const int generation = insertions[begin].generation;
      std::vector<double> parameters;
      for (; end < last && insertions[end].generation == generation; ++end)
        parameters.push_back(insertions[end].parameter);
      std::vector<Point> points(parameters.size());
      image(generation)(parameters, points);
      for (std::size_t i = begin; i < end; ++i) insertions[i].point = points[i - begin];
    }
  });
  for (const Insertion& insertion : insertions) {
    result_.images += static_cast<std::uint64_t>(insertion.generation) * static_cast<std::uint64_t>(std::abs(steps_));
    if (!is_finite(insertion.point)) return {};
  }
  std::vector<std::size_t> added;
  for (std::size_t i = 0; i < insertions.size(); ++i) added.push_back(insertions[i].segment + 1 + i);
  result_.points = with_inserted(std::span<const Point>(result_.points), insertions,
                                 [](const Insertion& insertion) { return insertion.point; });
  result_.parameters = with_inserted(std::span<const double>(result_.parameters), insertions,
                                     [&](const Insertion& insertion) { return side_ * insertion.parameter; });
  // A vertex moves on by the number of points put in before it.
  const auto moved = [&](std::size_t vertex) {
    const auto before = std::lower_bound(insertions.begin(), insertions.end(), vertex,
                                         [](const Insertion& i, std::size_t v) { return i.segment < v; });
    return vertex + static_cast<std::size_t>(before - insertions.begin());
  };
  for (std::size_t& begin : result_.generation_begin) begin = moved(begin);
  for (GrowthDiagnostic& diagnostic : result_.diagnostics) {
    const std::size_t end = moved(diagnostic.first + diagnostic.count);
    diagnostic.first = moved(diagnostic.first);
    diagnostic.count = end - diagnostic.first;
  }
  return added;
}

// On the side of negative parameters as LocalManifold::points_at with a negative reach: the same bits, and no parameter
// has to be turned round.
CurveFunction ManifoldGrowth::image(int generation) const {
  return [this, generation, coefficients = without_roundings(local_.coefficients)](std::span<const double> parameters,
                                                                                   std::span<Point> points) {
    chebyshev_points(coefficients, 0, side_ * local_.reach, parameters, points);
    if (generation > 0) map_.iterate(points, generation * steps_);
  };
}

double ManifoldGrowth::map_work() const {
  return static_cast<double>(map_.work() - work_before_);
}

bool ManifoldGrowth::out_of_work() const {
  return std::max(map_work(), static_cast<double>(result_.images)) > options_.max_work;
}

// False where max_points cuts it: a trace keeps to its limit roughly, since points that stay have whole numbers.
bool ManifoldGrowth::append(const Trace& trace, int generation) {
  const CancellationScope shield(CancellationScope::Shield{});  // half a generation could not be kept
  const std::size_t begin = result_.points.size();
  append_finite(trace, generation > 0 ? 1 : 0, side_, result_.points, result_.parameters, result_.diagnostics);
  const bool fits = result_.points.size() <= max_points_;
  if (!fits) {
    result_.points.resize(max_points_);
    result_.parameters.resize(max_points_);
    cut_diagnostics(result_.diagnostics, max_points_ - 1);
  }
  add_length(begin);
  return fits;
}

// The length of `count` segments in a row, as far as they count.
double ManifoldGrowth::counted_length(const Point* points, std::size_t count) const {
  const auto [sum, inside] = length_in_box(points, count, trace_options_.box);
  if (inside) return sum;
  double within = 0;
  for (std::size_t j = 0; j < count; ++j) {
    const Point a = points[j], b = points[j + 1];
    const double part = part_inside(a, b, trace_options_.box);
    if (part > 0) within += part < 1 ? length({part * (b.x - a.x), part * (b.y - a.y)}) : distance(a, b);
  }
  return within;
}

// Adds the length of the segments up to the points from number `begin` on, and ends the curve at the vertex where it
// is long enough.
void ManifoldGrowth::add_length(std::size_t begin) {
  const std::size_t first_segment = begin > 0 ? begin - 1 : 0;
  const std::size_t count = result_.points.empty() ? 0 : result_.points.size() - 1 - first_segment;
  std::vector<double> sums((count + pass_grain - 1) / pass_grain, 0);
  for_each_block(count, pass_grain, [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t k = first; k < last; k += max_flagged) {
      sum += counted_length(&result_.points[first_segment + k], std::min(max_flagged, last - k));
    }
    sums[first / pass_grain] = sum;
  });
  for (std::size_t block = 0; block < sums.size(); ++block) {
    if (result_.length + sums[block] < options_.length) {
      result_.length += sums[block];
      continue;
    }
    const std::size_t last = first_segment + std::min(count, (block + 1) * pass_grain);
    for (std::size_t k = first_segment + block * pass_grain; k < last; ++k) {
      result_.length += counted_length(&result_.points[k], 1);
      if (result_.length < options_.length) continue;
      result_.points.resize(k + 2);
      result_.parameters.resize(k + 2);
      cut_diagnostics(result_.diagnostics, k + 1);
      return;
    }
  }
}

// Moves the last point back along the curve to where the length is reached: where the curve is straight a segment may
// be far longer than all that was asked for. The polygon is never shorter than that, and longer by a billionth at most,
// where parameters can be told apart so well. By false position; halving the value at an end that stays (the Illinois
// method) makes it converge from both sides.
void ManifoldGrowth::end_at_length(int generation) {
  constexpr int max_evaluations = 24;
  constexpr double spare_length = 1e-9;
  if (result_.points.size() < 2) return;
  const std::size_t last = result_.points.size() - 1;
  const auto& diagnostics = result_.diagnostics;
  if (!diagnostics.empty() && diagnostics.back().cause == GrowthDiagnosticCause::failed &&
      diagnostics.back().first + diagnostics.back().count == last) {
    return;  // there is no curve between the two
  }
  std::array<Point, 2> segment{result_.points[last - 1], result_.points[last]};
  const double before = result_.length - counted_length(segment.data(), 1);
  const double slack = spare_length * options_.length, aim = options_.length + 0.5 * slack;
  const bool same = last - 1 >= result_.generation_begin[static_cast<std::size_t>(generation)];
  double low = side_ * result_.parameters[last - 1] / (same ? 1 : ratio_), high = side_ * result_.parameters[last];
  double below = before - aim, above = result_.length - aim;  // lengths at these, less the one aimed at
  const double nearest = low + trace_options_.min_spacing;
  enum class Replaced : std::uint8_t { none, lower, upper } replaced = Replaced::none;
  const CurveFunction curve = image(generation);
  for (int k = 0; k < max_evaluations && result_.length > options_.length + slack; ++k) {
    const double parameter = std::max(low + (high - low) * (below / (below - above)), nearest);
    if (!(parameter > low && parameter < high)) return;
    curve({&parameter, 1}, {&segment[1], 1});
    result_.images += static_cast<std::uint64_t>(generation) * static_cast<std::uint64_t>(std::abs(steps_));
    const double reached = before + counted_length(segment.data(), 1);
    if (!is_finite(segment[1]) || !std::isfinite(reached)) return;
    if (reached < options_.length) {
      if (replaced == Replaced::lower) above *= 0.5;
      replaced = Replaced::lower;
      low = parameter;
      below = reached - aim;
      continue;
    }
    if (replaced == Replaced::upper) below *= 0.5;
    replaced = Replaced::upper;
    high = parameter;
    above = reached - aim;
    result_.points[last] = segment[1];
    result_.parameters[last] = side_ * parameter;
    result_.length = reached;
  }
}

// Whether any of the curve is left to grow.
bool ManifoldGrowth::is_alive(const Samples& samples) const {
  return std::any_of(samples.points.begin(), samples.points.end(),
                     [&](Point point) { return is_finite(point) && meet(Box::of(point, point), range_); });
}

// As far as it takes to see that the generation is not shorter than the tolerance: a few segments, most often.
void ManifoldGrowth::add_to_generation(const Samples& samples) {
  for (std::size_t k = 0; k + 1 < samples.points.size() && generation_length_ < options_.tolerance; ++k) {
    const Point a = samples.points[k], b = samples.points[k + 1];
    if (is_finite(a) && is_finite(b) && meet(Box::of(a, b), range_)) generation_length_ += distance(a, b);
  }
}

}  // namespace lober::detail

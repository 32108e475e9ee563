// The sections of a piece of a growing manifold: where each begins, and how they are traced.
#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <thread>
#include <utility>

#include "engine/base/parallel/isolated.hpp"
#include "engine/base/parallel/ordered_pipeline.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/manifolds/manifold_growth.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// A guide is not longer than this: the points that it is traced with are some times as many.
constexpr std::size_t section_segments = std::size_t{1} << 13;

// Points that the local manifold gives a piece to begin with.
constexpr std::size_t fewest_in_piece = 17;

}  // namespace

Samples ManifoldGrowth::first_guide(double end) const {
  constexpr std::size_t size = 65;
  Samples guide{Buffer<double>(size), Buffer<Point>(size)};
  for (std::size_t k = 0; k < size; ++k) {
    guide.parameters[k] = end * static_cast<double>(k) / static_cast<double>(size - 1);
  }
  image(0)(guide.parameters, guide.points);
  // P(0) but for rounding; the other manifold of a homoclinic tangle begins there too.
  guide.points[0] = local_.saddle;
  return guide;
}

// The points of the local manifold in one part of its outermost fundamental segment.
Samples ManifoldGrowth::part_of_local(const Samples& samples, int part) const {
  const double begin = part_begin(part), end = part_begin(part + 1);
  const auto& given = samples.parameters;
  const auto first = std::upper_bound(given.begin(), given.end(), begin);
  const auto last = std::lower_bound(first, given.end(), end);
  std::vector<double> parameters{begin};
  parameters.insert(parameters.end(), first, last);
  parameters.push_back(end);
  if (pieces_ > 1 && parameters.size() < fewest_in_piece) {
    parameters.resize(fewest_in_piece);
    for (std::size_t k = 0; k < fewest_in_piece; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(fewest_in_piece - 1);
      parameters[k] = k + 1 == fewest_in_piece ? end : begin + (end - begin) * share;
    }
  }
  Samples result{Buffer<double>(parameters.size()), Buffer<Point>(parameters.size())};
  std::copy(parameters.begin(), parameters.end(), result.parameters.begin());
  image(0)(result.parameters, result.points);
  return result;
}

// Long guides are traced section by section, so that what that takes stays in the caches.
void ManifoldGrowth::split(const Samples& samples, std::vector<Guide>& guides) {
  const std::size_t segments = samples.points.size() - 1, parts = (segments + section_segments - 1) / section_segments;
  for (std::size_t k = 0; k < parts; ++k) {
    const std::size_t begin = segments * k / parts, size = segments * (k + 1) / parts + 1 - begin;
    guides.push_back(
        {std::span(samples.parameters).subspan(begin, size), std::span(samples.points).subspan(begin, size), {}});
  }
}

Point ManifoldGrowth::local_point(double parameter) const {
  Point point;
  image(0)({&parameter, 1}, {&point, 1});
  return point;
}

// Gives the guides of a piece what lies beyond their ends on the curve that they lie on. With F P(s) = P(ratio s) the
// generation before goes on with images of its own first points, so that the saddle is the only end.
void ManifoldGrowth::link(std::vector<Guide>& guides, int generation, int part) {
  for (std::size_t k = 0; k + 1 < guides.size(); ++k) {
    guides[k + 1].beyond.before = guides[k].points[guides[k].points.size() - 2];
    guides[k].beyond.behind = guides[k + 1].points[1];
  }
  Guide &first = guides.front(), &last = guides.back();
  const double begin = first.parameters.front(), end = last.parameters.back();
  const double gap = end - last.parameters[last.parameters.size() - 2];
  // The local manifold goes on at images of points that its guide need not have.
  if (part == 0) second_ = generation == 0 ? local_point((end + gap) / ratio_) : first.points[1];
  if (part == 0 && generation == 1) {
    last_but_one_ = local_point(std::max(begin - (first.parameters[1] - begin), 0.5 * begin));
  }
  if (generation > 0) first.beyond.before = last_but_one_;
  if (part == pieces_ - 1 || generation == 0) {
    last.beyond.behind = second_;
    map_.iterate({&*last.beyond.behind, 1}, steps_);
    count(static_cast<std::uint64_t>(std::abs(steps_)));
  } else if (generation == 1) {
    last.beyond.behind = local_point(end + gap);
  } else {
    last.beyond.behind = previous_[static_cast<std::size_t>(part) + 1].front().points[1];
  }
  last_but_one_ = last.points[last.points.size() - 2];
  for (Guide& guide : guides) {
    guide.beyond.function_goes_back = generation > 0;
    forget_unknown(guide.beyond);
  }
}

// Steps of the map that were taken; called from the thread that grows.
void ManifoldGrowth::count(std::uint64_t steps) {
  result_.images += steps;
  if (out_of_work()) throw Cancelled();
  report(so_far());
}

GrowthProgress ManifoldGrowth::so_far() const {
  const auto iterates = static_cast<int>(std::max(time(), 0.0) * std::abs(steps_ / local_.steps));
  return {iterates, result_.points.size(), result_.length, result_.images};
}

void ManifoldGrowth::report(const GrowthProgress& progress) const {
  if (options_.progress && !options_.progress(progress)) throw Cancelled();
}

ManifoldGrowth::Limits ManifoldGrowth::limits_left(int generation) const {
  const auto steps = static_cast<std::uint64_t>(std::max(1, generation * std::abs(steps_)));
  const std::uint64_t images_left = options_.max_images - std::min(options_.max_images, result_.images);
  const std::size_t points_left = max_points_ - std::min(max_points_, result_.points.size());
  return {static_cast<std::size_t>(std::min<std::uint64_t>(points_left, images_left / steps)),
          options_.length - result_.length};
}

// The points of a guide one image on, and those beyond its ends.
Samples ManifoldGrowth::carried(const Guide& guide, int generation, double end, Beyond& beyond,
                                const Counted& counted) const {
  std::size_t size = guide.points.size();
  beyond = guide.beyond;
  const bool ends_within = end < guide.parameters.back();
  if (ends_within) {
    size = 1 + static_cast<std::size_t>(std::lower_bound(guide.parameters.begin(), guide.parameters.end(), end) -
                                        guide.parameters.begin());
    const std::size_t next = guide.parameters[size - 1] > end ? size - 1 : size;
    beyond.behind = guide.points[next];
  }
  const std::array<std::optional<Point>*, 2> outer{&beyond.before, &beyond.behind};
  Samples samples{Buffer<double>(size), {}};
  samples.points.reserve(size + outer.size());
  samples.points.resize(size);
  std::copy_n(guide.parameters.data(), size, samples.parameters.data());
  std::copy_n(guide.points.data(), size, samples.points.data());
  if (ends_within) {
    samples.parameters.back() = end;
    image(generation - 1)({&end, 1}, {&samples.points.back(), 1});
  }
  if (generation == 0) return samples;
  // Those beyond are carried with the others, as one more point of a flow takes as long as several.
  for (const std::optional<Point>* point : outer) {
    if (*point) samples.points.push_back(**point);
  }
  for_each_block(samples.points.size(), trace_options_.batch, [&](std::size_t first, std::size_t last) {
    map_.iterate(std::span(samples.points).subspan(first, last - first), steps_);
  });
  counted(samples.points.size() * static_cast<std::uint64_t>(std::abs(steps_)));
  for (std::size_t next = size; std::optional<Point> * point : outer) {
    if (*point) *point = samples.points[next++];
  }
  forget_unknown(beyond);
  samples.points.resize(size);
  return samples;
}

Trace ManifoldGrowth::traced_section(const Guide& guide, int generation, double end, const Limits& limits,
                                     const Counted& counted) const {
  Beyond beyond;
  Samples samples = carried(guide, generation, end, beyond, counted);
  TraceOptions options = trace_options_;
  options.max_points = limits.points;
  options.max_total_length = limits.length;
  options.spent = [&] { return map_work() > options_.max_work; };
  const auto steps = static_cast<std::uint64_t>(generation) * static_cast<std::uint64_t>(std::abs(steps_));
  options.evaluated = [&](std::size_t evaluations) { counted(evaluations * steps); };
  options.images_are_dear = are_dear(map_, steps);
  const auto last = static_cast<std::uint32_t>(samples.points.size() - 1);
  return traced(std::move(samples), {0, last}, beyond, image(generation), options);
}

// Nothing where the section does not fit into the points and images of the map that are left.
std::optional<Trace> ManifoldGrowth::traced_within_limits(const Guide& guide, int generation, double end) {
  const Limits limits = limits_left(generation);
  if (limits.points < 2) {
    points_needed_ = static_cast<double>(guide.points.size());
    return std::nullopt;
  }
  Trace trace = traced_section(guide, generation, end, limits, [&](std::uint64_t steps) { count(steps); });
  if (!options_.whole_pieces) return trace;
  const std::size_t size = trace.samples.points.size() - (generation > 0 ? 1 : 0);
  if (trace.out_of_points || result_.points.size() + size > max_points_) {
    points_needed_ = std::max(trace.points_needed, static_cast<double>(trace.samples.points.size()));
    return std::nullopt;
  }
  return trace;
}

// Sections side by side, appended in order. Ends before the first that a limit might cut, since only those before it
// show what is left of the limit; nothing that was traced beyond it counts, whatever the threads.
std::vector<Samples> ManifoldGrowth::appended_together(std::span<const Guide> guides, int generation, double end) {
  struct Slot {
    std::size_t number = 0;
    Trace trace;
    std::uint64_t steps = 0;
  };
  const Limits limits{limits_left(generation).points, std::numeric_limits<double>::infinity()};
  std::vector<Samples> sections;
  if (limits.points < 2) return sections;
  std::size_t begun = 0;
  std::atomic<bool> fits{true};
  const std::thread::id caller = std::this_thread::get_id();
  std::mutex guard;
  GrowthProgress appended = so_far();
  const auto next = [&](Slot& slot) {
    slot.number = begun;
    return fits && begun++ < guides.size();
  };
  const auto work = [&](Slot& slot) {
    slot.steps = 0;
    const auto counted = [&](std::uint64_t steps) {
      slot.steps += steps;
      if (std::this_thread::get_id() != caller) return;
      const GrowthProgress now = [&] {
        const std::scoped_lock lock(guard);
        return appended;
      }();
      report({now.iterates, now.points, now.length, now.images + slot.steps});
    };
    run_isolated([&] { slot.trace = traced_section(guides[slot.number], generation, end, limits, counted); });
  };
  const auto deliver = [&](Slot& slot) {
    if (!fits) return;
    const Size before = size();
    fits = !slot.trace.out_of_points && slot.trace.samples.points.size() <= limits_left(generation).points;
    if (!fits) return;
    run_isolated([&] { fits = append(slot.trace, generation); });
    fits = fits && result_.length < options_.length;
    if (!fits) return cut_back_to(before);
    result_.images += slot.steps;
    if (out_of_work()) {
      cut_back_to(before);
      throw Cancelled();
    }
    sections.push_back(kept_as_guide(std::move(slot.trace.samples), generation));
    const std::scoped_lock lock(guard);
    appended = so_far();
  };
  ordered_pipeline<Slot>(next, work, deliver);
  return sections;
}

}  // namespace lober::detail

// One class, and longer than other files for that: all its rounds work on the same samples.
#include "engine/dynamics/manifolds/trace.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/parallel/insertion.hpp"
#include "engine/base/parallel/running_sums.hpp"
#include "engine/dynamics/manifolds/segment_requirements.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "kernels/graded.hpp"
#include "kernels/point.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// Points are placed this much denser than the estimate asks for, so that few segments turn out too coarse.
constexpr double reserve = 1.08;
// Points lie by so much, as a fraction, more or less densely, where that lets a point of the guide stay.
constexpr double max_stretching = 0.04;
// Known images are not left out where all others are this many times as many.
constexpr std::size_t few_known = 64;
// Where the map fails on one side, the edge is sought to this fraction of the range of the parameter.
constexpr double edge_resolution = 1e-7;
constexpr std::size_t chunk = std::size_t{1} << 16;  // evaluations between two reports of progress

// An insertion behind element `segment`.
struct Insertion {
  std::uint32_t segment;
  double parameter;
  Point point;
};

// Next to one: whole_number(x + one_below) is x rounded up, but for numbers that rounding made of whole ones.
constexpr double one_below = 1 - 0x1p-40;

// x >= 0 rounded down: as one instruction also on processors without one for that.
double whole_number(double x) {
  return static_cast<double>(static_cast<std::int64_t>(x));
}

class Tracer {
 public:
  Tracer(Samples guide, std::vector<std::uint32_t> kept, const Beyond& beyond, const CurveFunction& function,
         const TraceOptions& options)
      : samples_(std::move(guide)), kept_(std::move(kept)), beyond_(beyond), function_(function), options_(options) {
    edge_ =
        std::max(2 * options.min_spacing, edge_resolution * (samples_.parameters.back() - samples_.parameters.front()));
  }

  Trace run() {
    verdicts_.assign(segments(), open);
    required_.resize(segments());
    const auto by_guide = [&](std::size_t first, std::size_t last, const auto& requirements) {
      mark_fine(first, last);
      for (std::size_t k = first; k < last; ++k) required_[k] = bounded(requirements.required_parts(k) * reserve, k);
    };
    const auto by_tolerance = [&](std::size_t first, std::size_t last, const auto&) { mark_fine(first, last); };
    const auto parts = [&](const TracedSegment& segment) { return guided(segment); };
    while (rounds_ < options_.max_rounds && insert_where(against_guide, by_guide, parts)) {
    }
    if (rounds_ == options_.max_rounds) (void)cuts(against_guide, by_guide, parts);  // for what they require
    if (!abandoned()) resample_evenly();
    if (!abandoned()) look_nearer_beyond();
    required_.clear();
    verdicts_.assign(segments(), open);
    while (!abandoned() && rounds_ < options_.max_rounds &&
           insert_where(against_tolerance, by_tolerance, [&](const TracedSegment& s) { return judged(s); })) {
    }
    if (!abandoned()) collect_diagnostics();
    trace_.samples = std::move(samples_);
    trace_.kept = std::move(kept_);
    return std::move(trace_);
  }

 private:
  [[nodiscard]] std::size_t segments() const { return samples_.points.size() - 1; }
  [[nodiscard]] bool abandoned() const { return trace_.out_of_points && !options_.cut; }
  [[nodiscard]] bool inside(Point a, Point b) const { return meet(Box::of(a, b), options_.box); }
  [[nodiscard]] double gap(std::size_t k) const { return samples_.parameters[k + 1] - samples_.parameters[k]; }

  // Only segments with two images that meet the box have to be fine; one at whose one end the map fails is pursued
  // until the edge is found or has left the box. Outside, a curve between two points may come back into the box: there
  // segments are no longer than they are far from it.
  enum class Kind : std::uint8_t { ordinary, edge, failed, beside, outside };
  [[nodiscard]] Kind kind(std::size_t k) const {
    const Point a = samples_.points[k], b = samples_.points[k + 1];
    const bool a_finite = is_finite(a), b_finite = is_finite(b);
    if (a_finite && b_finite) {
      if (inside(a, b)) return Kind::ordinary;
      return times_too_long(a, b) > 1 && gap(k) > 2 * options_.min_spacing ? Kind::beside : Kind::outside;
    }
    if (!a_finite && !b_finite) return Kind::failed;
    const Point last = a_finite ? a : b;
    return inside(last, last) && gap(k) > edge_ ? Kind::edge : Kind::failed;
  }

  // The length of a segment outside of the box as a multiple of its distance from it, both along the axes.
  [[nodiscard]] double times_too_long(Point a, Point b) const {
    const Box box = Box::of(a, b);
    const double x = std::max(options_.box.min_x() - box.max_x(), box.min_x() - options_.box.max_x());
    const double y = std::max(options_.box.min_y() - box.max_y(), box.min_y() - options_.box.max_y());
    return std::max(box.width(), box.height()) / std::max(x, y);
  }

  // Points that stay, without those at the ends.
  [[nodiscard]] std::span<const std::uint32_t> corners() const { return std::span(kept_).subspan(1, kept_.size() - 2); }

  // Segments begin to end in order: calls body(segment) for those that have any of the flags, and plain(first, last,
  // requirements) for what lies between these, ordinary segments all.
  template <typename Plain, typename Body>
  void for_segments(std::size_t begin, std::size_t end, std::int64_t flags, const Plain& plain,
                    const Body& body) const {
    SegmentRequirements requirements;
    for (; begin < end; begin = std::min(begin + SegmentRequirements::most, end)) {
      const std::size_t until = std::min(begin + SegmentRequirements::most, end);
      if (flags == against_tolerance && SegmentRequirements::surely_fine(samples_, beyond_, options_, begin, until)) {
        plain(begin, until, requirements);
        continue;
      }
      const std::int64_t any = requirements.measure(samples_, corners(), beyond_, options_, begin, until);
      std::size_t next = begin;
      for (std::size_t k = begin; (any & flags) != 0 && k < until; ++k) {
        if ((requirements.flags(k) & flags) == 0) continue;
        if (next < k) plain(next, k, requirements);
        body(requirements[k]);
        next = k + 1;
      }
      if (next < until) plain(next, until, requirements);
    }
  }

  // Where nothing of these stands against a segment, one part is enough: for the guide, and for the tolerance.
  static constexpr std::int64_t against_guide = outside_segment | unknown_segment | rough_segment;
  static constexpr std::int64_t against_tolerance = outside_segment | uneven_segment | coarse_segment;

  [[nodiscard]] std::uint32_t allowed(const TracedSegment& segment, double parts) const {
    const double most = std::floor(gap(segment.number) / std::max(options_.min_spacing, 1e-300));
    return static_cast<std::uint32_t>(std::max(1.0, std::min({std::ceil(parts), max_parts, most})));
  }

  [[nodiscard]] std::uint32_t parts_beside(const TracedSegment& segment) const {
    const Point a = samples_.points[segment.number], b = samples_.points[segment.number + 1];
    return std::max(2U, allowed(segment, std::min(times_too_long(a, b), 8.0)));
  }

  // Parts of a segment, as far as parameters can be told apart.
  [[nodiscard]] double bounded(double parts, std::size_t segment) const {
    return std::min(parts, gap(segment) / std::max(options_.min_spacing, 1e-300));
  }

  [[nodiscard]] std::uint32_t parts_for_guide(const TracedSegment& segment, Kind what) const {
    if (what == Kind::edge) return 2;
    if (what == Kind::beside) return parts_beside(segment);
    if (what != Kind::ordinary) return 1;
    if (segment.unknown) return allowed(segment, 4);
    const bool sharp = segment.curvature * segment.length > sharpest_guide;
    if (segment.required_parts > coarsest_guide) return allowed(segment, 2 * segment.required_parts / coarsest_guide);
    return sharp && segment.required_parts > 1 ? allowed(segment, 2) : 1;
  }

  [[nodiscard]] std::uint32_t parts_for_tolerance(const TracedSegment& segment, Kind what) const {
    if (what == Kind::edge) return 2;
    if (what == Kind::beside) return parts_beside(segment);
    if (what != Kind::ordinary) return 1;
    return segment.required_parts > caution ? allowed(segment, segment.required_parts * reserve)
           : segment.uneven                 ? allowed(segment, 2)
                                            : 1;
  }

  // The verdict on a segment: none yet, that it is fine (for the guide, or once points are placed), or else fine + 1 +
  // why it is not.
  using Verdict = std::uint8_t;
  static constexpr Verdict open = 0, fine = 1;
  [[nodiscard]] Verdict verdict(const TracedSegment& segment, Kind what) const {
    GrowthDiagnosticCause cause = GrowthDiagnosticCause::max_rounds;
    if (what == Kind::ordinary) {
      if (!(segment.required_parts > 1)) return fine;
      if (gap(segment.number) < 2 * options_.min_spacing) cause = GrowthDiagnosticCause::spacing;
    } else {
      cause = what == Kind::beside || what == Kind::outside ? GrowthDiagnosticCause::left_box
                                                            : GrowthDiagnosticCause::failed;
    }
    return static_cast<Verdict>(fine + 1 + static_cast<int>(cause));
  }

  // Sets the verdicts on segments that need no more than one part.
  void mark_fine(std::size_t first, std::size_t last) { std::fill(&verdicts_[first], &verdicts_[last - 1] + 1, fine); }

  // Parts for the guide and for the tolerance; where one is enough, or the end, the verdict is set. For the guide, what
  // the segment requires as well.
  [[nodiscard]] std::uint32_t guided(const TracedSegment& segment) {
    const Kind what = kind(segment.number);
    const std::uint32_t parts = parts_for_guide(segment, what);
    if (parts == 1) verdicts_[segment.number] = fine;
    // Outside the box nothing is asked for: the guide itself, simplified.
    const double required = what == Kind::ordinary                       ? segment.required_parts * reserve
                            : what == Kind::edge || what == Kind::beside ? 1
                                                                         : 0.5;
    required_[segment.number] = bounded(required, segment.number);
    return parts;
  }
  [[nodiscard]] std::uint32_t judged(const TracedSegment& segment) {
    const Kind what = kind(segment.number);
    const std::uint32_t parts = parts_for_tolerance(segment, what);
    if (parts == 1) verdicts_[segment.number] = verdict(segment, what);
    return parts;
  }

  // `size` evaluations: evaluated(first, last) takes a batch of them. Counted chunk by chunk.
  template <typename Evaluated>
  void in_chunks(std::size_t size, const Evaluated& evaluated) const {
    for (std::size_t begin = 0; begin < size; begin += chunk) {
      const std::size_t count = std::min(chunk, size - begin);
      for_each_block(count, options_.batch, [&](std::size_t first, std::size_t last) {
        evaluated(begin + first, begin + last);
        if (options_.spent && options_.spent()) throw Cancelled();
      });
      if (options_.evaluated) options_.evaluated(count);
    }
  }

  // Images of parameters that are not known yet.
  template <typename Parameter, typename Result>
  void evaluate(std::size_t size, const Parameter& parameter, const Result& result) const {
    in_chunks(size, [&](std::size_t first, std::size_t last) {
      Buffer<double> parameters(last - first);
      Buffer<Point> points(last - first);
      for (std::size_t k = first; k < last; ++k) parameters[k - first] = parameter(k);
      function_(parameters, points);
      for (std::size_t k = first; k < last; ++k) result(k, points[k - first]);
    });
  }

  // A segment, and the number of points to put into it.
  struct Cut {
    std::uint32_t segment, points;
  };

  // The segments that are open and need more parts than one; the others get their verdicts.
  template <typename Plain, typename Parts>
  [[nodiscard]] Buffer<Cut> cuts(std::int64_t flags, const Plain& plain, const Parts& parts) {
    std::vector<Buffer<Cut>> found((segments() + pass_grain - 1) / pass_grain);
    for_each_block(segments(), pass_grain, [&](std::size_t first, std::size_t last) {
      Buffer<Cut>& here = found[first / pass_grain];
      const Verdict* const verdicts = verdicts_.data();
      for (std::size_t begin = first, end = first; begin < last; begin = end) {
        begin = static_cast<std::size_t>(std::find(verdicts + begin, verdicts + last, open) - verdicts);
        end = begin;
        while (end < last && verdicts[end] == open) ++end;
        for_segments(begin, end, flags, plain, [&](const TracedSegment& segment) {
          const std::uint32_t more = parts(segment) - 1;
          if (more != 0) here.push_back({static_cast<std::uint32_t>(segment.number), more});
        });
      }
    });
    Buffer<Cut> all;
    for (Buffer<Cut>& here : found) {
      if (all.empty()) {
        all = std::move(here);
      } else {
        all.insert(all.end(), here.begin(), here.end());
      }
    }
    return all;
  }

  // One round: false when there was nothing to insert, or max_points is reached.
  template <typename Plain, typename Parts>
  bool insert_where(std::int64_t flags, const Plain& plain, const Parts& parts) {
    const Buffer<Cut> broken = cuts(flags, plain, parts);
    if (broken.empty()) return false;
    const auto begin = running_sums(broken.size(), [&](std::size_t k) { return broken[k].points; });
    if (samples_.points.size() + begin[broken.size()] > options_.max_points) {
      return end_where_points_run_out(broken, begin);
    }
    Buffer<Insertion> insertions(begin[broken.size()]);
    for_each_block(broken.size(), pass_grain, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        const auto [segment, count] = broken[k];
        const double from = samples_.parameters[segment], step = gap(segment) / (count + 1);
        for (std::uint32_t j = 0; j < count; ++j) insertions[begin[k] + j] = {segment, from + (j + 1) * step, {}};
      }
    });
    evaluate(
        insertions.size(), [&](std::size_t k) { return insertions[k].parameter; },
        [&](std::size_t k, Point point) { insertions[k].point = point; });
    insert(insertions);
    ++rounds_;
    return true;
  }

  void insert(const Buffer<Insertion>& insertions) {
    samples_.points = with_inserted(std::span<const Point>(samples_.points), insertions,
                                    [](const Insertion& insertion) { return insertion.point; });
    samples_.parameters = with_inserted(std::span<const double>(samples_.parameters), insertions,
                                        [](const Insertion& insertion) { return insertion.parameter; });
    if (kept_.size() > 2) {
      for_each_block(kept_.size(), pass_grain, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
          kept_[k] += static_cast<std::uint32_t>(
              std::lower_bound(insertions.begin(), insertions.end(), kept_[k],
                               [](const Insertion& i, std::uint32_t vertex) { return i.segment < vertex; }) -
              insertions.begin());
        }
      });
    } else {
      kept_.back() = static_cast<std::uint32_t>(segments());
    }
    // Segments near a new point are judged again.
    verdicts_ = with_inserted(std::span<const Verdict>(verdicts_), insertions, [](const Insertion&) { return open; });
    if (!required_.empty()) {
      required_ = with_inserted(std::span<const double>(required_), insertions, [](const Insertion&) { return 0.0; });
    }
    for (std::size_t k = 0; k < insertions.size(); ++k) {
      const std::size_t at = insertions[k].segment + k;  // index of the part before the new point
      for (std::size_t j = at > 1 ? at - 2 : 0; j < std::min(at + 4, segments()); ++j) verdicts_[j] = open;
    }
  }

  void truncate(std::size_t size) {
    samples_.points.resize(size);
    samples_.parameters.resize(size);
    verdicts_.resize(size - 1);
    if (!required_.empty()) required_.resize(size - 1);
    beyond_.behind.reset();
    beyond_.is_loop = false;
    while (!kept_.empty() && kept_.back() >= size - 1) kept_.pop_back();
    kept_.push_back(static_cast<std::uint32_t>(size - 1));
  }

  // Ends the samples where all insertions up to there still fit in. False where nothing is left to do: a segment stays.
  bool end_where_points_run_out(const Buffer<Cut>& broken, const Buffer<std::uint64_t>& begin) {
    trace_.out_of_points = true;
    if (!options_.cut) {
      trace_.points_needed = static_cast<double>(samples_.points.size() + begin[broken.size()]);
      return false;
    }
    if (samples_.points.size() == 2) return false;
    std::size_t k = 0;
    while (k < broken.size() && broken[k].segment + 1 + begin[k + 1] <= options_.max_points) ++k;
    // Up to broken[k] nothing exceeds; leave points for what the next rounds add there.
    const std::size_t size = std::max<std::size_t>(
        2, std::min<std::size_t>(broken[std::min(k, broken.size() - 1)].segment, options_.max_points - begin[k]));
    truncate(std::min(size, samples_.points.size() - 1));
    return true;
  }

  // The points of the guide give way to points that are spaced evenly by `required`, but for those that are kept.
  void resample_evenly() {
    end_by_length();
    if (abandoned()) return;
    std::vector<std::uint32_t> known;
    const Buffer<double> index = new_indices(known);
    const auto size = static_cast<std::size_t>(index.back()) + 1;
    Samples even{Buffer<double>(size), Buffer<Point>(size)};
    for_each_block(segments(), pass_grain,
                   [&](std::size_t first, std::size_t last) { fill_segments(first, last, index, even.parameters); });
    for (std::uint32_t& k : kept_) k = static_cast<std::uint32_t>(index[k]);
    for (const std::uint32_t k : known) even.parameters[static_cast<std::size_t>(index[k])] = samples_.parameters[k];
    evaluate_between(known, index, even);
    for (const std::uint32_t k : known) even.points[static_cast<std::size_t>(index[k])] = samples_.points[k];
    samples_ = std::move(even);
  }

  void look_nearer_beyond() {
    if (beyond_.is_loop) {
      beyond_.before = samples_.points[segments() - 1];
      beyond_.behind = samples_.points[1];
    } else if (beyond_.before && beyond_.function_goes_back && !options_.images_are_dear) {
      const double first = samples_.parameters[0], parameter = std::max(first - gap(0), 0.5 * first);
      function_({&parameter, 1}, {&*beyond_.before, 1});
      if (options_.evaluated) options_.evaluated(1);
    }
    forget_unknown(beyond_);
  }

  // Cuts the part beyond the length asked for. Chords are shorter than the curve, so enough remains.
  void end_by_length() {
    if (options_.max_total_length < std::numeric_limits<double>::infinity()) {
      double length = 0;
      std::size_t k = 0;
      while (k < segments() && length <= options_.max_total_length) {
        const double more = distance(samples_.points[k], samples_.points[k + 1]);
        length += std::isfinite(more) ? more : 0;
        ++k;
      }
      if (k < segments()) truncate(k + 1);
    }
    double points = 1 + static_cast<double>(kept_.size());
    if (!options_.cut) {
      for (const double parts : required_) points += parts;
      if (points > static_cast<double>(options_.max_points)) {
        trace_.out_of_points = true;
        trace_.points_needed = points;
      }
      return;
    }
    for (std::size_t k = 0; k < segments(); ++k) {
      points += required_[k];
      if (points > static_cast<double>(options_.max_points)) {
        trace_.out_of_points = true;
        truncate(std::max<std::size_t>(k, 1) + 1);
        break;
      }
    }
  }

  // The index of each point of the guide among the new points, not whole in general: kept ones get whole numbers, and
  // where images are dear others too, if that takes little stretching, so that these need not be computed again.
  // `known` receives the numbers of both.
  [[nodiscard]] Buffer<double> new_indices(std::vector<std::uint32_t>& known) const {
    Buffer<double> index(samples_.points.size());
    double begin = 0;
    known.assign(1, 0);
    std::size_t first = 0;  // the last known one
    double sum = 0;
    for (std::size_t k = 0, j = 1; k + 1 < index.size(); ++k) {
      index[k] = sum;
      sum += required_[k];
      const bool stays = k + 1 == kept_[j];
      if (!stays && !options_.images_are_dear) continue;
      if (stays) ++j;
      const double parts = std::max(1.0, whole_number(stays ? sum + one_below : sum + 0.5));
      if (!stays && !(std::fabs(parts - sum) <= max_stretching * sum)) continue;
      const double scale = sum > 0 ? parts / sum : 0;
      for (std::size_t i = first; i <= k; ++i) index[i] = begin + std::min(index[i] * scale, parts);
      begin += parts;
      first = k + 1;
      sum = 0;
      known.push_back(static_cast<std::uint32_t>(first));
    }
    index.back() = begin;
    return index;
  }

  // The new points whose numbers fall into segments first to last of the guide. The density varies linearly along a
  // segment, from that around its first end to that around the other; next to corners it is the segment's own.
  void fill_segments(std::size_t first, std::size_t last, const Buffer<double>& index,
                     Buffer<double>& parameters) const {
    std::array<double, max_graded + 1> around;
    for (std::size_t begin = first, end = first; begin < last; begin = end) {
      end = std::min(begin + max_graded, last);
      for (std::size_t k = begin; k <= end; ++k) {
        around[k - begin] = k > 0 && k < segments() ? (required_[k - 1] + required_[k]) / (gap(k - 1) + gap(k)) : -1;
      }
      const auto inner = corners();
      for (auto k = std::lower_bound(inner.begin(), inner.end(), begin); k != inner.end() && *k <= end; ++k)
        around[*k - begin] = -1;
      place_graded({&samples_.parameters[begin], &index[begin], &required_[begin], around.data(), end - begin},
                   parameters.data());
    }
  }

  // Images of all points but those that are known; where these are few, of them too.
  void evaluate_between(const std::vector<std::uint32_t>& known, const Buffer<double>& index, Samples& even) const {
    if (!options_.images_are_dear && known.size() * few_known < even.points.size()) return evaluate_in_place(even);
    Buffer<std::uint32_t> fresh(even.points.size() - known.size());
    const auto number = [&](std::size_t j) { return static_cast<std::uint32_t>(index[known[j]]); };
    for_each_block(known.size() - 1, pass_grain, [&](std::size_t first, std::size_t last) {
      for (std::size_t j = first; j < last; ++j) {
        // Before the j-th known one are number(j) - j others.
        for (std::uint32_t k = number(j) + 1; k < number(j + 1); ++k) fresh[k - j - 1] = k;
      }
    });
    evaluate(
        fresh.size(), [&](std::size_t k) { return even.parameters[fresh[k]]; },
        [&](std::size_t k, Point point) { even.points[fresh[k]] = point; });
  }

  void evaluate_in_place(Samples& samples) const {
    in_chunks(samples.points.size(), [&](std::size_t first, std::size_t last) {
      function_(std::span(samples.parameters).subspan(first, last - first),
                std::span(samples.points).subspan(first, last - first));
    });
  }

  void collect_diagnostics() {
    if (rounds_ == options_.max_rounds || trace_.out_of_points) {  // some may be open still
      verdicts_.resize(segments());
      const auto fine_all = [&](std::size_t first, std::size_t last, const auto&) { mark_fine(first, last); };
      for_each_block(segments(), pass_grain, [&](std::size_t first, std::size_t last) {
        for_segments(first, last, outside_segment | coarse_segment, fine_all,
                     [&](const TracedSegment& s) { verdicts_[s.number] = verdict(s, kind(s.number)); });
      });
    }
    // Most often each is `fine`, as the one before it is.
    if (verdicts_[0] == fine && std::equal(verdicts_.begin() + 1, verdicts_.end(), verdicts_.begin())) return;
    const Buffer<GrowthDiagnostic> diagnostics = gathered<GrowthDiagnostic>(
        segments(), [&](std::size_t k) { return verdicts_[k] > fine; },
        [&](std::size_t k) {
          return GrowthDiagnostic{k, 1, static_cast<GrowthDiagnosticCause>(verdicts_[k] - fine - 1)};
        });
    trace_.diagnostics.assign(diagnostics.begin(), diagnostics.end());
  }

  Samples samples_;
  std::vector<std::uint32_t> kept_;
  Beyond beyond_;
  const CurveFunction& function_;
  const TraceOptions& options_;
  double edge_ = 0;
  Buffer<Verdict> verdicts_;  // on segments
  Buffer<double> required_;   // parts that segments of the guide require, as long as there is one
  std::uint32_t rounds_ = 0;
  Trace trace_;
};

}  // namespace

void forget_unknown(Beyond& beyond) {
  for (std::optional<Point>* point : {&beyond.before, &beyond.behind}) {
    if (*point && !is_finite(**point)) point->reset();
  }
}

Trace traced(Samples guide, std::vector<std::uint32_t> kept, const Beyond& beyond, const CurveFunction& function,
             const TraceOptions& options) {
  return Tracer(std::move(guide), std::move(kept), beyond, function, options).run();
}

}  // namespace lober::detail

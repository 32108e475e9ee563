// Points near the intersections with another curve, and points at them.

#include <algorithm>
#include <atomic>
#include <string>

#include "engine/base/parallel/insertion.hpp"
#include "engine/geometry/densify/distinct_curve.hpp"
#include "engine/geometry/densify/interpolant.hpp"
#include "engine/geometry/densify/meetings.hpp"
#include "lober/curve/densify.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr double finest = 0x1p-52;  // part of a segment; shorter parts would have their ends at the same point

// Stops, unfinished, when there are more than `max_size` parameters.
void insert_between(double low, double high, std::span<const double> meetings, int passes, int points,
                    std::size_t max_size, std::vector<double>& parameters) {
  const double step = (high - low) / (points + 1);
  if (passes <= 0 || points <= 0 || meetings.empty() || step < finest || parameters.size() > max_size) return;
  double from = low;
  for (int k = 1; k <= points + 1; ++k) {
    const bool last = k > points;
    const double to = last ? high : low + k * step;
    std::size_t here = 0;
    while (here < meetings.size() && (last || meetings[here] < to)) ++here;
    insert_between(from, to, meetings.first(here), passes - 1, points, max_size, parameters);
    meetings = meetings.subspan(here);
    if (!last) parameters.push_back(to);
    from = to;
  }
}

// A point that goes behind vertex `segment` of the curve as it is, and its position on the given curve.
struct Insertion {
  std::uint32_t segment;
  Position at;
  Point point;
};

// The curve while it is being refined: where each vertex lies on the curve given (so that new points come from that
// curve's own pieces), kept only from the second pass on.
class Refined {
 public:
  explicit Refined(const Interpolant& interpolant) : interpolant_(interpolant) {}

  [[nodiscard]] CurveView view() const {
    const CurveView& given = interpolant_.curve();
    return points_.empty() ? given : CurveView{points_, given.closed};
  }

  // Segment k of the present curve, as a part of one segment given.
  struct SegmentPart {
    std::uint32_t segment;
    double from, to;
  };
  [[nodiscard]] SegmentPart part_of(std::uint32_t k) const {
    if (positions_.empty()) return {k, 0, 1};
    const Position from = positions_[k];
    const bool ends_inside = k + 1 < positions_.size() && positions_[k + 1].segment == from.segment;
    return {from.segment, from.t, ends_inside ? positions_[k + 1].t : 1};
  }

  void insert(const Buffer<Insertion>& insertions, bool another_pass) {
    if (another_pass && positions_.empty()) {
      positions_.resize(view().points.size());
      for_each_block(positions_.size(), pass_grain, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) positions_[k] = {static_cast<std::uint32_t>(k), 0};
      });
    }
    if (another_pass) {
      positions_ = with_inserted(std::span<const Position>(positions_), insertions,
                                 [](const Insertion& insertion) { return insertion.at; });
    }
    points_ = with_inserted(view().points, insertions, [](const Insertion& insertion) { return insertion.point; });
  }

  Buffer<Point> take() && {
    if (points_.empty()) points_.assign(view().points.begin(), view().points.end());
    return std::move(points_);
  }

 private:
  const Interpolant& interpolant_;
  Buffer<Point> points_;
  Buffer<Position> positions_;
};

[[noreturn]] void fail_too_many(std::size_t max_points) {
  throw DataError("points inserted near intersections would make a curve of more than " + std::to_string(max_points) +
                  " points, the limit; give fewer passes or fewer points");
}

// The points that `passes` passes put into the segments that hold meetings. Stops as soon as the curve would have more
// than `max_points`.
Buffer<Insertion> insertions_near(const Refined& refined, const Interpolant& interpolant,
                                  const Buffer<Meeting>& meetings, int passes, int points, std::size_t max_points) {
  const auto begins = gathered<std::size_t>(
      meetings.size(), [&](std::size_t k) { return k == 0 || meetings[k].at.segment != meetings[k - 1].at.segment; },
      [](std::size_t k) { return k; });
  constexpr std::size_t grain = 256;
  std::vector<std::vector<Insertion>> found((begins.size() + grain - 1) / grain);
  std::atomic<std::size_t> size{refined.view().points.size()};
  for_each_block(begins.size(), grain, [&](std::size_t first, std::size_t last) {
    std::vector<double> held, parameters;
    for (std::size_t group = first; group < last; ++group) {
      const std::size_t end = group + 1 < begins.size() ? begins[group + 1] : meetings.size();
      const std::uint32_t segment = meetings[begins[group]].at.segment;
      held.clear();
      for (std::size_t k = begins[group]; k < end; ++k) held.push_back(meetings[k].at.t);
      parameters.clear();
      insert_between(0, 1, held, passes, points, max_points, parameters);
      const auto [given, from, to] = refined.part_of(segment);
      if (to - from < finest * (points + 1)) continue;
      if ((size += parameters.size()) > max_points) fail_too_many(max_points);
      const CubicPiece piece = interpolant.piece(given);
      for (const double t : parameters) {
        const double on_given = from + t * (to - from);
        found[first / grain].push_back({segment, {given, on_given}, piece.at(on_given)});
      }
    }
  });
  const auto begin = running_sums(found.size(), [&](std::size_t k) { return found[k].size(); });
  Buffer<Insertion> insertions(begin.back());
  for_each_block(found.size(), 1, [&](std::size_t k, std::size_t) {
    std::copy(found[k].begin(), found[k].end(), insertions.begin() + static_cast<std::ptrdiff_t>(begin[k]));
  });
  return insertions;
}

// A meeting that has no vertex yet; one that rounds to its neighbour has.
DensifiedCurve with_meetings(CurveView curve, const Buffer<Meeting>& meetings) {
  const auto is_new = [&](std::size_t k) {
    const Meeting& meeting = meetings[k];
    if (meeting.at_vertex) return false;
    const auto [a, b] = curve.segment(meeting.at.segment);
    if (meeting.point == a || meeting.point == b) return false;
    return k == 0 || meetings[k - 1].at.segment != meeting.at.segment || !(meetings[k - 1].point == meeting.point);
  };
  const auto insertions = gathered<Insertion>(meetings.size(), is_new, [&](std::size_t k) {
    return Insertion{meetings[k].at.segment, meetings[k].at, meetings[k].point};
  });
  DensifiedCurve result;
  result.points = with_inserted(curve.points, insertions, [](const Insertion& insertion) { return insertion.point; });
  result.closed = curve.closed;
  result.rounds = insertions.empty() ? 0 : 1;
  return result;
}

}  // namespace

void parameters_near(std::span<const double> meetings, int passes, int points, std::vector<double>& parameters) {
  insert_between(0, 1, meetings, passes, points, parameters.max_size(), parameters);
}

DensifiedCurve densify_near(CurveView curve, CurveView other, const NearOptions& options) {
  if (options.passes < 0 || options.points < 0) throw UsageError("densify: passes and points cannot be negative");
  const DistinctCurve given(curve), against(other);
  const Interpolant interpolant(given.view(), options.interpolation);
  Refined refined(interpolant);
  // On the chords the intersections stay where they are, so one search serves all passes.
  const bool linear = options.interpolation == Interpolation::linear;
  const std::size_t max_points = std::min<std::size_t>(options.max_points, (std::size_t{1} << 31) - 1);
  const int searches = options.points == 0 || options.passes == 0 ? 0 : linear ? 1 : options.passes;
  DensifiedCurve result;
  for (int pass = 1; pass <= searches; ++pass) {
    const Buffer<Meeting> meetings = find_meetings(refined.view(), against.view())[0];
    const Buffer<Insertion> insertions =
        insertions_near(refined, interpolant, meetings, linear ? options.passes : 1, options.points, max_points);
    if (insertions.empty()) break;
    refined.insert(insertions, pass < searches);
    ++result.rounds;
  }
  result.points = std::move(refined).take();
  result.closed = curve.closed;
  return result;
}

std::array<DensifiedCurve, 2> insert_crossings(CurveView first, CurveView second) {
  const DistinctCurve first_given(first), second_given(second);
  const auto meetings = find_meetings(first_given.view(), second_given.view());
  return {with_meetings(first_given.view(), meetings[0]), with_meetings(second_given.view(), meetings[1])};
}

}  // namespace lober

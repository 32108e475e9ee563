#include "engine/dynamics/manifolds/segment_requirements.hpp"

#include <algorithm>

#include "kernels/turning.hpp"

namespace lober::detail {
namespace {

// Neighbouring segments differ in length per parameter by no more than this factor.
constexpr double max_unevenness = 4;
constexpr double at_corner = -1;  // instead of a curvature

SegmentBounds bounds_for(const TraceOptions& options) {
  // Segments that the tolerance makes invisible are not uneven.
  return {options.box, 4 * options.tolerance, max_unevenness, caution, coarsest_guide, sharpest_guide};
}

// The curvature at b.
double bend_between(Point a, Point b, Point c) {
  const std::array<Point, 3> points{a, b, c};
  std::array<double, 2> lengths;
  double bend = 0;
  turns_along(points.data(), lengths.size(), lengths.data(), &bend);
  return bend;
}

}  // namespace

std::int64_t SegmentRequirements::measure(const Samples& samples, std::span<const std::uint32_t> kept,
                                          const Beyond& beyond, const TraceOptions& options, std::size_t begin,
                                          std::size_t end) {
  begin_ = begin;
  const std::size_t count = end - begin, segments = samples.points.size() - 1;
  const bool starts = begin == 0, stops = end == segments;
  const std::size_t before = starts ? 0 : 1, behind = stops ? 0 : 1;
  length_[0] = length_[count + 1] = 0;
  bend_[0] = bend_[count] = at_corner;
  turns_along(&samples.points[begin - before], count + before + behind, &length_[1 - before], &bend_[1 - before]);
  // A segment alone may hide a fold, whatever the curve does beyond it: it stays unknown.
  if (starts && beyond.before && segments > 1) {
    bend_[0] = bend_between(*beyond.before, samples.points[0], samples.points[1]);
  }
  if (stops && beyond.behind && segments > 1) {
    bend_[count] = bend_between(samples.points[segments - 1], samples.points[segments], *beyond.behind);
  }
  for (auto k = std::lower_bound(kept.begin(), kept.end(), begin); k != kept.end() && *k <= end; ++k)
    bend_[*k - begin] = at_corner;
  parts_needed(&length_[1], bend_.data(), count, {options.tolerance, options.max_length, max_parts},
               required_parts_.data());
  return flag_segments({&samples.points[begin], &samples.parameters[begin], !starts, !stops, length_.data(),
                        bend_.data(), required_parts_.data(), count},
                       bounds_for(options), flags_.data());
}

bool SegmentRequirements::surely_fine(const Samples& samples, const Beyond& beyond, const TraceOptions& options,
                                      std::size_t begin, std::size_t end) {
  const bool starts = begin == 0, stops = end + 1 == samples.points.size();
  if ((starts && beyond.before) || (stops && beyond.behind)) return false;
  return detail::surely_fine({&samples.points[begin], &samples.parameters[begin], !starts, !stops, end - begin},
                             bounds_for(options), {options.tolerance, options.max_length, max_parts});
}

}  // namespace lober::detail

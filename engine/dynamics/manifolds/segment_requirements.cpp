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

}  // namespace

std::int64_t SegmentRequirements::measure(const Samples& samples, std::span<const std::uint32_t> kept,
                                          const TraceOptions& options, std::size_t begin, std::size_t end) {
  begin_ = begin;
  const std::size_t count = end - begin, segments = samples.points.size() - 1;
  const std::size_t before = begin > 0 ? 1 : 0, after = end < segments ? 1 : 0;
  length_[0] = length_[count + 1] = 0;
  bend_[0] = bend_[count] = at_corner;
  turns_along(&samples.points[begin - before], count + before + after, &length_[1 - before], &bend_[1 - before]);
  for (auto k = std::lower_bound(kept.begin(), kept.end(), begin); k != kept.end() && *k <= end; ++k)
    bend_[*k - begin] = at_corner;
  parts_needed(&length_[1], bend_.data(), count, {options.tolerance, options.max_length, max_parts},
               required_parts_.data());
  return flag_segments({&samples.points[begin], &samples.parameters[begin], before == 1, after == 1, length_.data(),
                        bend_.data(), required_parts_.data(), count},
                       bounds_for(options), flags_.data());
}

bool SegmentRequirements::surely_fine(const Samples& samples, const TraceOptions& options, std::size_t begin,
                                      std::size_t end) {
  return detail::surely_fine(
      {&samples.points[begin], &samples.parameters[begin], begin > 0, end + 1 < samples.points.size(), end - begin},
      bounds_for(options), {options.tolerance, options.max_length, max_parts});
}

}  // namespace lober::detail

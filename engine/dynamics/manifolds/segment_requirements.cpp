#include "engine/dynamics/manifolds/segment_requirements.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/turning.hpp"

namespace lober::detail {
namespace {

// Neighbouring segments differ in length per parameter by no more than this factor.
constexpr double max_unevenness = 4;
constexpr double at_corner = -1;  // instead of a curvature

}  // namespace

std::int64_t SegmentRequirements::measure(const Samples& samples, std::span<const std::uint32_t> kept,
                                          const TraceOptions& options, std::size_t begin, std::size_t end) {
  begin_ = begin;
  const std::size_t count = end - begin, segments = samples.points.size() - 1;
  const std::size_t before = begin > 0 ? 1 : 0, after = end < segments ? 1 : 0;
  std::array<double, most + 1> bend;  // at vertices begin .. end
  length_[0] = length_[count + 1] = 0;
  bend[0] = bend[count] = at_corner;
  turns_along(&samples.points[begin - before], count + before + after, &length_[1 - before], &bend[1 - before]);
  for (auto k = std::lower_bound(kept.begin(), kept.end(), begin); k != kept.end() && *k <= end; ++k)
    bend[*k - begin] = at_corner;

  std::array<double, most + 2> gap;
  for (std::size_t k = 1 - before; k < count + 1 + after; ++k) {
    gap[k] = samples.parameters[begin + k] - samples.parameters[begin + k - 1];
  }
  if (before == 0) gap[0] = 0;
  if (after == 0) gap[count + 1] = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double larger = bend[k] > bend[k + 1] ? bend[k] : bend[k + 1];
    curvature_[k] = larger > 0 ? larger : 0.0;
  }
  parts_needed(&length_[1], curvature_.data(), count, {options.tolerance, options.max_length, max_parts},
               required_parts_.data());
  // Segments that the tolerance makes invisible are not uneven.
  const SegmentBounds bounds{options.box, 4 * options.tolerance, max_unevenness,
                             caution,     coarsest_guide,        sharpest_guide};
  return flag_segments({&samples.points[begin], length_.data(), gap.data(), bend.data(), required_parts_.data(), count},
                       bounds, flags_.data());
}

}  // namespace lober::detail

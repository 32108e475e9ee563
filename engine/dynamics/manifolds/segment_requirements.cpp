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

void SegmentRequirements::measure(const Samples& samples, std::span<const std::uint32_t> kept,
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

  // Whether the two segments at a vertex differ that much in speed, and not below what the tolerance makes invisible.
  std::array<double, most + 2> gap;
  for (std::size_t k = 1 - before; k < count + 1 + after; ++k) {
    gap[k] = samples.parameters[begin + k] - samples.parameters[begin + k - 1];
  }
  if (before == 0) gap[0] = 0;
  if (after == 0) gap[count + 1] = 0;
  std::array<std::uint8_t, most + 1> differ;
  const double visible = 4 * options.tolerance;
  for (std::size_t k = 0; k <= count; ++k) {
    const double a = length_[k] * gap[k + 1], b = length_[k + 1] * gap[k];
    const double longer = length_[k] > length_[k + 1] ? length_[k] : length_[k + 1];
    const double larger = a > b ? a : b, smaller = a > b ? b : a;
    const bool smooth = bend[k] >= 0, seen = longer >= visible, far = larger > max_unevenness * smaller;
    differ[k] = static_cast<std::uint8_t>(smooth & seen & far);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double larger = bend[k] > bend[k + 1] ? bend[k] : bend[k + 1];
    curvature_[k] = larger > 0 ? larger : 0.0;
    unknown_[k] = larger < 0 ? 1 : 0;
    uneven_[k] = static_cast<std::uint8_t>(differ[k] | differ[k + 1]);
  }
  parts_needed(&length_[1], curvature_.data(), count, {options.tolerance, options.max_length, max_parts},
               required_parts_.data());
}

}  // namespace lober::detail

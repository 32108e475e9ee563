#include "kernels/crossing_parameters.hpp"

#include <algorithm>

#include "kernels/kernel_table.hpp"
#include "kernels/predicates.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {

std::size_t crossing_parameters(const SegmentCrossing* crossings, std::size_t count, double scale,
                                CrossingParameters* parameters) {
  std::size_t exact = 0;
  SegmentCrossing padded[lanes];
  CrossingParameters padded_parameters[lanes];
  for (std::size_t begin = 0; begin < count; begin += lanes) {
    const std::size_t together = std::min(lanes, count - begin);
    const SegmentCrossing* from = crossings + begin;
    CrossingParameters* to = parameters + begin;
    if (together < lanes) {
      for (std::size_t k = 0; k < lanes; ++k) padded[k] = from[std::min(k, together - 1)];
      from = padded;
      to = padded_parameters;
    }
    const unsigned shallow = kernels().four_parameters(from, scale, to);
    if (together < lanes) std::copy_n(padded_parameters, together, parameters + begin);
    if (shallow == 0) continue;
    for (std::size_t k = 0; k < together; ++k) {
      if ((shallow >> k & 1U) == 0) continue;
      const SegmentCrossing& x = crossings[begin + k];
      parameters[begin + k] = {exact_parameter(x.a, x.b, {x.c, x.d}), exact_parameter(x.c, x.d, {x.a, x.b})};
      ++exact;
    }
  }
  return exact;
}

}  // namespace lober::detail

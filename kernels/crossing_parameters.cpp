#include "kernels/crossing_parameters.hpp"

#include <algorithm>

#include "kernels/eight.hpp"
#include "kernels/kernel_table.hpp"
#include "kernels/predicates.hpp"

namespace lober::detail {

std::size_t crossing_parameters(const SegmentCrossing* crossings, std::size_t count, double scale,
                                CrossingParameters* parameters) {
  std::size_t exact = 0;
  SegmentCrossing padded[eight];
  CrossingParameters padded_parameters[eight];
  for (std::size_t begin = 0; begin < count; begin += eight) {
    const std::size_t together = std::min(eight, count - begin);
    const SegmentCrossing* from = crossings + begin;
    CrossingParameters* to = parameters + begin;
    if (together < eight) {
      for (std::size_t k = 0; k < eight; ++k) padded[k] = from[std::min(k, together - 1)];
      from = padded;
      to = padded_parameters;
    }
    const unsigned shallow = kernels().eight_parameters(from, scale, to);
    if (together < eight) std::copy_n(padded_parameters, together, parameters + begin);
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

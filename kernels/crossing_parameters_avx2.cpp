#include "kernels/crossing_parameters.hpp"
#include "kernels/simd.hpp"

#include "kernels/crossing_parameters.inl"

namespace lober::detail {

unsigned four_parameters_avx2(const SegmentCrossing* crossings, double scale, CrossingParameters* parameters) {
  return four_parameters(crossings, scale, parameters);
}

}  // namespace lober::detail

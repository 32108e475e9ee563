#include "kernels/shoelace.hpp"
#include "kernels/simd.hpp"

#include "kernels/shoelace.inl"

namespace lober {

void shoelace_terms_avx2(const Point* points, Point origin, DD* terms) {
  terms_of(points, origin, terms);
}

}  // namespace lober

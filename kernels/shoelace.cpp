#include "kernels/shoelace.hpp"

#include "kernels/cpu.hpp"
#include "kernels/simd.hpp"

#include "kernels/shoelace.inl"

namespace lober {

void shoelace_terms_avx2(const Point* points, Point origin, DD* terms);

void shoelace_terms(const Point* points, Point origin, DD* terms) {
  if (has_avx2()) {
    shoelace_terms_avx2(points, origin, terms);
  } else {
    terms_of(points, origin, terms);
  }
}

}  // namespace lober

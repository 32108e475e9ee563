// Body of shoelace_terms, compiled once for plain x86-64 and once for AVX2 + FMA (kernels/simd.hpp).

namespace {

using namespace lober;

inline void terms_of(const Point* points, Point origin, DD* terms) {
  const double* coordinates = &points[0].x;
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    const Lanes begin0 = load(coordinates + 2 * i), begin1 = load(coordinates + 2 * i + 4);
    const Lanes end0 = load(coordinates + 2 * i + 2), end1 = load(coordinates + 2 * i + 6);
    const Lanes ax = __builtin_shufflevector(begin0, begin1, 0, 2, 4, 6);
    const Lanes ay = __builtin_shufflevector(begin0, begin1, 1, 3, 5, 7);
    const Lanes bx = __builtin_shufflevector(end0, end1, 0, 2, 4, 6);
    const Lanes by = __builtin_shufflevector(end0, end1, 1, 3, 5, 7);
    const Lanes x = splat(origin.x), y = splat(origin.y);
    // cross(a - o, b - o) = cross(a - o, b - a), where b - a is short and, mostly, exact in double.
    const BasicDD<Lanes> rx = two_diff(ax, x), ry = two_diff(ay, y), ex = two_diff(bx, ax), ey = two_diff(by, ay);
    BasicDD<Lanes> term;
    if (mask_bits((ex.lo == 0) & (ey.lo == 0)) == 15U) {
      const BasicDD<Lanes> left = two_product(rx.hi, ey.hi), right = two_product(ry.hi, ex.hi);
      const BasicDD<Lanes> main = two_diff(left.hi, right.hi);
      term = fast_two_sum(main.hi, main.lo + ((left.lo - right.lo) + (rx.lo * ey.hi - ry.lo * ex.hi)));
    } else {
      term = cross(rx, ry, ex, ey);
    }
    store(&terms[i].hi, __builtin_shufflevector(term.hi, term.lo, 0, 4, 1, 5));
    store(&terms[i + 2].hi, __builtin_shufflevector(term.hi, term.lo, 2, 6, 3, 7));
  }
}

}  // namespace

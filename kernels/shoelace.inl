// Body of shoelace_terms, compiled once for plain x86-64 and once for AVX2 + FMA (kernels/simd.hpp).

namespace {

using namespace lober;

inline void terms_of(const Point* points, Point origin, DD* terms) {
  const double* coordinates = &points[0].x;
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    const Lanes begin0 = load(coordinates + 2 * i), begin1 = load(coordinates + 2 * i + 4);
    const Lanes end0 = load(coordinates + 2 * i + 2), end1 = load(coordinates + 2 * i + 6);
    const Lanes ax = __builtin_shuffle(begin0, begin1, LaneMask{0, 2, 4, 6});
    const Lanes ay = __builtin_shuffle(begin0, begin1, LaneMask{1, 3, 5, 7});
    const Lanes bx = __builtin_shuffle(end0, end1, LaneMask{0, 2, 4, 6});
    const Lanes by = __builtin_shuffle(end0, end1, LaneMask{1, 3, 5, 7});
    const Lanes x = splat(origin.x), y = splat(origin.y);
    const BasicDD<Lanes> term = cross(two_diff(ax, x), two_diff(ay, y), two_diff(bx, x), two_diff(by, y));
    store(&terms[i].hi, __builtin_shuffle(term.hi, term.lo, LaneMask{0, 4, 1, 5}));
    store(&terms[i + 2].hi, __builtin_shuffle(term.hi, term.lo, LaneMask{2, 6, 3, 7}));
  }
}

}  // namespace

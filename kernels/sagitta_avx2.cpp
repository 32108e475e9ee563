#include "kernels/sagitta.inl"

namespace lober::detail {

void twice_chord_areas_avx2(const Point* points, std::size_t count, double* areas);
void add_arc_measures_avx2(const Point* points, std::size_t count, Point origin, ArcMeasures& sums);

void twice_chord_areas_avx2(const Point* points, std::size_t count, double* areas) {
  areas_of_all(points, count, areas);
}

void add_arc_measures_avx2(const Point* points, std::size_t count, Point origin, ArcMeasures& sums) {
  arc_sums(points, count, origin, sums);
}

}  // namespace lober::detail

#include "kernels/sagitta.hpp"

#include "kernels/cpu.hpp"

#include "kernels/sagitta.inl"

namespace lober::detail {

void twice_chord_areas_avx2(const Point* points, std::size_t count, double* areas);
void add_arc_measures_avx2(const Point* points, std::size_t count, Point origin, ArcMeasures& sums);

double twice_chord_area(Point p0, Point p1, Point p2, Point p3) {
  const Point points[4] = {p0, p1, p2, p3};
  Chords chords;
  double area = 0;
  areas_of_few(points, 1, chords, &area);
  return area;
}

void twice_chord_areas(const Point* points, std::size_t count, double* areas) {
  has_avx2() ? twice_chord_areas_avx2(points, count, areas) : areas_of_all(points, count, areas);
}

void add_arc_measures(const Point* points, std::size_t count, Point origin, ArcMeasures& sums) {
  has_avx2() ? add_arc_measures_avx2(points, count, origin, sums) : arc_sums(points, count, origin, sums);
}

}  // namespace lober::detail

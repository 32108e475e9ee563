#include <algorithm>
#include <utility>

#include "bench/trackers/rival_program.hpp"

namespace lober::bench {

ArrangedShapes arranged(const trust::TrackerCase& given, int arrangement) {
  ArrangedShapes shapes{given.a, given.b, arrangement >= arrangement_count / 2};
  for (trust::PolygonRings& polygon : shapes.b) {
    for (trust::Ring& ring : polygon) {
      if (arrangement % 3 == 1) std::reverse(ring.begin(), ring.end());
      if (arrangement % 3 == 2) {
        std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2), ring.end());
      }
    }
  }
  if (shapes.exchanged) std::swap(shapes.a, shapes.b);
  return shapes;
}

}  // namespace lober::bench

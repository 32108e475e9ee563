// The ten lines of the README, compiled against the installed package.
#include <cmath>
#include <cstdio>
#include <lober/engine/geometry/overlay/overlay.hpp>
#include <vector>

int main() {
  const std::vector<lober::Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<lober::Point> shifted{{0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {0.5, 1.5}};
  const lober::Overlay result = lober::overlay(lober::CurveView{square}, lober::CurveView{shifted});
  for (const lober::Piece lobe : result.pieces(lober::Pairing::c1_minus_c2)) {
    std::printf("lobe of area %.17g between %zu crossings\n", lobe.area, lobe.crossings.size());
  }
  return result.areas.intersection == 0.25 && result.areas.c1_minus_c2 == 0.75 ? 0 : 1;
}

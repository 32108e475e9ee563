// The ten lines of docs/how-to/cpp.md, compiled against the installed package.
#include <cmath>
#include <cstdio>
#include <lober/overlay.hpp>

int main() {
  const lober::ClosedCurve square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  // A temporary: the result keeps its points.
  const lober::Overlay result =
      lober::overlay(square, lober::ClosedCurve{{0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {0.5, 1.5}});
  for (const lober::Piece lobe : result.pieces(lober::Pairing::c1_minus_c2)) {
    std::printf("lobe of area %.17g between %zu crossings\n", lobe.area, lobe.crossings.size());
  }
  return result.areas.intersection == 0.25 && result.areas.c1_minus_c2 == 0.75 ? 0 : 1;
}

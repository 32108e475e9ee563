#include <algorithm>
#include <cmath>

#include "engine/base/parallel/parallel.hpp"
#include "lober/curve/drawing.hpp"
#include "lober/overlay/interior.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::size_t raster_side = LobeRaster::side;

Rectangle bounds(Rectangle box, std::span<const Point> points) {
  for (const Point& point : points) box.add(point);
  return box;
}

// The cells, along one axis, whose centres can lie from `low` to `high`.
struct Range {
  std::size_t begin, end;
};
Range cells_between(double low, double high, double window_low, double window_high) {
  const double half = 0.5 * window_high - 0.5 * window_low;
  if (!(half > 0)) return {0, raster_side};
  const auto cell = [&](double value) {
    return std::clamp((0.5 * value - 0.5 * window_low) / half, 0.0, 1.0) * static_cast<double>(raster_side);
  };
  return {static_cast<std::size_t>(std::max(cell(low) - 1, 0.0)),
          std::min(raster_side, static_cast<std::size_t>(cell(high)) + 1)};
}

void mark(LobeRaster& raster, const Tangle& tangle, std::size_t lobe) {
  const std::vector<Point> outline = lobe_outline(tangle, lobe);
  if (outline.size() < 3) return;
  const IndexedCurve curve{CurveView{outline}};
  const Rectangle box = bounds({}, outline);
  const Range columns = cells_between(box.min_x, box.max_x, raster.window.min_x, raster.window.max_x);
  const Range rows = cells_between(box.min_y, box.max_y, raster.window.min_y, raster.window.max_y);
  const int number = tangle.lobes[lobe].orientation() * static_cast<int>(lobe + 1);
  for_each_block(rows.end - rows.begin, 1, [&](std::size_t k, std::size_t) {
    const std::size_t row = rows.begin + k;
    for (std::size_t column = columns.begin; column < columns.end; ++column) {
      int& cell = raster.lobes[row * raster_side + column];
      if (cell == 0 && winding(curve, raster.centre(column, row)).number != 0) cell = number;
    }
  });
}

}  // namespace

Point LobeRaster::centre(std::size_t column, std::size_t row) const {
  const auto between = [](double low, double high, std::size_t cell) {
    const double t = (static_cast<double>(cell) + 0.5) / static_cast<double>(raster_side);
    return (1 - t) * low + t * high;
  };
  return {between(window.min_x, window.max_x, column), between(window.min_y, window.max_y, row)};
}

LobeRaster rasterise(const Tangle& tangle) {
  LobeRaster raster;
  raster.lobes.resize(raster_side * raster_side);
  for (std::size_t k = 0; k < tangle.lobes.size(); ++k) {
    raster.window = bounds(raster.window, lobe_outline(tangle, k));
  }
  if (tangle.lobes.empty()) raster.window = bounds(bounds({}, tangle.u().points), tangle.s().points);
  for (std::size_t k = 0; k < tangle.lobes.size(); ++k) mark(raster, tangle, k);
  return raster;
}

}  // namespace lober

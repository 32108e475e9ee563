#include "cli/picture/view.hpp"

#include <algorithm>
#include <cmath>

namespace lober::cli {
namespace {

constexpr long double max_aspect = 8;

void widen(double& low, double& high) {
  if (!(low <= high)) {
    low = 0;
    high = 1;
  }
  if (low < high && std::isfinite(high / 2 - low / 2)) return;
  const double half = low != 0 ? 0.05 * std::fabs(low) : 0.5;
  low -= half;
  high += half;
  if (!(low < high)) {  // the least numbers there are
    low = -std::numeric_limits<double>::min();
    high = std::numeric_limits<double>::min();
  }
}

}  // namespace

Rectangle drawable_window(const Rectangle& window) {
  Rectangle result = window;
  widen(result.min_x, result.max_x);
  widen(result.min_y, result.max_y);
  return result;
}

Frame fitted_frame(const Rectangle& window, const Frame& available) {
  const long double width = static_cast<long double>(window.max_x) - window.min_x;
  const long double height = static_cast<long double>(window.max_y) - window.min_y;
  const long double aspect = height / width;
  if (!(aspect <= max_aspect && aspect >= 1 / max_aspect)) return available;
  Frame frame = available;
  const auto wanted = static_cast<double>(available.width * aspect);
  if (wanted <= available.height) {
    frame.height = wanted;
  } else {
    frame.width = static_cast<double>(available.height / aspect);
  }
  return frame;
}

}  // namespace lober::cli

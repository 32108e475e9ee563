// From a window of the plane, y up, to a frame of the picture, y down.
#pragma once

#include "lober/curve/point.hpp"

namespace lober::cli {

/// A point of the picture, in points of print (1/72 inch), x to the right and y down.
using PrintPoint = Point;

/// A rectangle of the picture.
struct Frame {
  double x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] double right() const { return x + width; }
  [[nodiscard]] double bottom() const { return y + height; }
  [[nodiscard]] bool holds(PrintPoint p) const { return p.x > x && p.x < right() && p.y > y && p.y < bottom(); }
};

/// Positions are taken against the window in extended precision: windows of 1e-12 and of 1e300 are drawn alike.
class View {
 public:
  View(const Rectangle& window, const Frame& frame) : window_(window), frame_(frame) {
    scale_x_ = frame.width / extent(window.min_x, window.max_x);
    scale_y_ = frame.height / extent(window.min_y, window.max_y);
  }
  [[nodiscard]] PrintPoint operator()(Point p) const { return at(p.x, p.y); }
  [[nodiscard]] PrintPoint at(long double x, long double y) const {
    return {static_cast<double>(frame_.x + (x - window_.min_x) * scale_x_),
            static_cast<double>(frame_.bottom() - (y - window_.min_y) * scale_y_)};
  }
  [[nodiscard]] const Rectangle& window() const { return window_; }
  [[nodiscard]] const Frame& frame() const { return frame_; }
  [[nodiscard]] bool contains(Point p) const { return window_.contains(p); }
  /// Lengths of the plane in a point of print.
  [[nodiscard]] long double unit_x() const { return 1 / scale_x_; }
  [[nodiscard]] long double unit_y() const { return 1 / scale_y_; }

 private:
  static long double extent(double low, double high) {
    const long double difference = static_cast<long double>(high) - low;
    return difference > 0 ? difference : 1;
  }
  Rectangle window_;
  Frame frame_;
  long double scale_x_, scale_y_;
};

/// The window widened where it has no extent, so that something can be drawn: a window of a single point, of none.
[[nodiscard]] Rectangle drawable_window(const Rectangle& window);

/// The frame within `available` that has the window's proportions, so that both axes have one scale, its upper left
/// corner as that. The whole of `available` where the window is more than `max_aspect` times longer than wide.
[[nodiscard]] Frame fitted_frame(const Rectangle& window, const Frame& available);

}  // namespace lober::cli

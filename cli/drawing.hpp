// Curves of the plane as paths of an SVG picture.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/text.hpp"
#include "engine/curve/curve.hpp"

namespace lober::cli {

inline constexpr double width = 960;                   // of the plot, in pixels
inline constexpr double widest = 0.5, tallest = 1.25;  // height to width of the plot
inline constexpr double margin = 24;
inline constexpr int subpixels = 20;  // coordinates are whole numbers of these, so that paths are short
inline constexpr std::size_t most_points = 200'000;

struct Pixel {
  double x, y;
};

// From the plane, y up, to pixels, y down. Both axes have one scale, unless the data are much longer than wide.
class View {
 public:
  /// All of the curves is seen; there has to be a point.
  explicit View(std::span<const CurveView> curves) {
    low_ = high_ = curves[0].points[0];
    for (const CurveView& curve : curves) {
      for (const Point& p : curve.points) {
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
        high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
      }
    }
    // Halves, because a difference of two finite numbers need not be finite.
    half_ = {0.5 * high_.x - 0.5 * low_.x, 0.5 * high_.y - 0.5 * low_.y};
    const double aspect = half_.x > 0 ? half_.y / half_.x : 1;
    height_ = width * std::clamp(aspect, widest, tallest);
    const bool keep_scale = aspect >= widest;
    plot_width_ = keep_scale && aspect > tallest && aspect < 4 ? height_ / aspect : width;
  }

  [[nodiscard]] Pixel operator()(Point p) const {
    const auto fraction = [](double value, double low, double half) {
      return half > 0 ? (0.5 * value - 0.5 * low) / half : 0.5;
    };
    return {margin + 0.5 * (width - plot_width_) + plot_width_ * fraction(p.x, low_.x, half_.x),
            margin + height_ * (1 - fraction(p.y, low_.y, half_.y))};
  }
  [[nodiscard]] double height() const { return height_; }

 private:
  Point low_, high_, half_;
  double height_ = width, plot_width_ = width;
};

inline int subpixel(double pixels) {
  return static_cast<int>(std::lround(pixels * subpixels));
}

// Draws polygons into the `d` of a path, leaving out points closer than `tolerance` pixels to the last one
// drawn.
class PathWriter {
 public:
  PathWriter(const View& view, double tolerance) : view_(view), tolerance_(tolerance) {}

  void add(std::span<const Point> polygon) {
    drawn_.clear();
    Pixel last{};
    for (const Point& point : polygon) {
      const Pixel here = view_(point);
      if (!drawn_.empty() && std::hypot(here.x - last.x, here.y - last.y) < tolerance_) continue;
      drawn_.push_back(here);
      last = here;
    }
    if (drawn_.size() < 3) return;  // nothing to be seen at this scale
    points_ += drawn_.size();
    int x = subpixel(drawn_[0].x), y = subpixel(drawn_[0].y);
    append_all(path_, "M", x, " ", y, "l");
    for (std::size_t k = 1; k < drawn_.size(); ++k) {
      const int next_x = subpixel(drawn_[k].x), next_y = subpixel(drawn_[k].y);
      const int step_x = next_x - x, step_y = next_y - y;
      append_all(path_, k > 1 && step_x >= 0 ? " " : "", step_x, step_y >= 0 ? " " : "", step_y);
      x = next_x;
      y = next_y;
    }
    path_ += "z";
  }

  [[nodiscard]] std::size_t points() const { return points_; }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  const View& view_;
  double tolerance_;
  std::vector<Pixel> drawn_;
  std::size_t points_ = 0;
  std::string path_;
};

// Paths by what draws them, with a tolerance that keeps the picture small however many points there are.
template <typename Draw>
std::string path_of(const View& view, const Draw& draw) {
  for (double tolerance = 0.2;; tolerance *= 2) {
    PathWriter writer(view, tolerance);
    draw(writer);
    if (writer.points() <= most_points || tolerance > 8) return writer.path();
  }
}

inline std::string curve_path(const View& view, const CurveView& curve) {
  return path_of(view, [&](PathWriter& writer) { writer.add(curve.points); });
}

inline std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

inline std::string rounded(double value) {
  std::array<char, 32> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 6).ptr;
  return {buffer.data(), end};
}

}  // namespace lober::cli

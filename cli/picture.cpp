// The picture of an overlay: two curves, and the lobes between them in two colours.

#include <algorithm>
#include <cmath>

#include "cli/overlay_report.hpp"
#include "cli/text.hpp"

namespace lober::cli {
namespace {

constexpr double width = 960;                   // of the plot, in pixels
constexpr double widest = 0.5, tallest = 1.25;  // height to width of the plot
constexpr double margin = 24;
constexpr double legend_line = 24;
constexpr double legend_height = 2 * legend_line + 12;
constexpr int subpixels = 20;  // coordinates are whole numbers of these, so that paths are short
constexpr std::size_t most_points = 200'000;
constexpr std::size_t most_dots = 500;

constexpr const char* colour1 = "#1f5fa8";
constexpr const char* colour2 = "#c8501e";
constexpr const char* dot_colour = "#222222";

struct Pixel {
  double x, y;
};

// From the plane, y up, to pixels, y down. Both axes have one scale, unless the data are much longer than
// wide.
class View {
 public:
  View(const CurveView& c1, const CurveView& c2) {
    low_ = high_ = c1.points[0];
    for (const CurveView& curve : {c1, c2}) {
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

int subpixel(double pixels) {
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

std::string pieces_path(const View& view, const Overlay& result, Pairing pairing) {
  return path_of(view, [&](PathWriter& writer) {
    for (std::size_t k = 0; k < result.pieces(pairing).size(); ++k) {
      for (const std::vector<Point>& polygon : outline(result, pairing, k)) writer.add(polygon);
    }
  });
}

std::string curve_path(const View& view, const CurveView& curve) {
  return path_of(view, [&](PathWriter& writer) { writer.add(curve.points); });
}

std::string escaped(std::string_view text) {
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

std::string rounded(double value) {
  std::array<char, 32> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 6).ptr;
  return {buffer.data(), end};
}

void add_dots(std::string& svg, const View& view, const Crossings& nodes) {
  if (nodes.crossings() >= most_dots) return;
  append_all(svg, "<g fill=\"", dot_colour, "\" stroke=\"#ffffff\" stroke-width=\"", subpixels, "\">\n");
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node node = nodes[k];
    if (node.rho == 0) continue;
    const Pixel at = view(node.begin);
    append_all(svg, "<circle cx=\"", subpixel(at.x), "\" cy=\"", subpixel(at.y), "\" r=\"", 3 * subpixels, "\"/>\n");
  }
  svg += "</g>\n";
}

void add_legend(std::string& svg, const OverlayReport& report, double top) {
  const auto entry = [&](double x, double y, const char* swatch, const std::string& text) {
    append_all(svg, "<g transform=\"translate(", x, " ", y, ")\">", swatch,
               "<text x=\"34\" y=\"5\" font-family=\"sans-serif\" font-size=\"15\" fill=\"#333333\">", escaped(text),
               "</text></g>\n");
  };
  const auto line = [](const char* colour) {
    return std::string("<path d=\"M0 0h26\" stroke=\"") + colour + "\" stroke-width=\"2\"/>";
  };
  const auto patch = [](const char* colour) {
    return std::string("<rect y=\"-8\" width=\"26\" height=\"16\" fill=\"") + colour + "\" fill-opacity=\"0.4\"/>";
  };
  const auto pieces = [&](Pairing pairing) {
    const std::size_t count = report.result.pieces(pairing).size();
    return std::to_string(count) + (count == 1 ? " lobe, area " : " lobes, area ");
  };
  const Areas& areas = report.result.areas;
  const double right = margin + width / 2;
  entry(margin, top, line(colour1).c_str(), "C1, area " + rounded(areas.c1));
  entry(right, top, patch(colour1).c_str(), "C1 \\ C2: " + pieces(Pairing::c1_minus_c2) + rounded(areas.c1_minus_c2));
  entry(margin, top + legend_line, line(colour2).c_str(), "C2, area " + rounded(areas.c2));
  entry(right, top + legend_line, patch(colour2).c_str(),
        "C2 \\ C1: " + pieces(Pairing::c2_minus_c1) + rounded(areas.c2_minus_c1));
}

}  // namespace

void write_picture(const std::string& path, const OverlayReport& report) {
  const Overlay& result = report.result;
  const CurveView &c1 = result.nodes.curve1(), &c2 = result.nodes.curve2();
  const View view(c1, c2);
  const double full_width = width + 2 * margin, full_height = view.height() + 2 * margin + legend_height;
  std::string svg;
  append_all(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", full_width, "\" height=\"", full_height,
             "\" viewBox=\"0 0 ", full_width, " ", full_height, "\">\n", "<title>Lobes between two curves</title>\n",
             "<rect width=\"100%\" height=\"100%\" fill=\"#fbfaf7\"/>\n", "<g transform=\"scale(", 1.0 / subpixels,
             ")\" stroke-linejoin=\"round\">\n");
  const auto fill = [&](Pairing pairing, const char* colour) {
    append_all(svg, "<path fill=\"", colour, "\" fill-opacity=\"0.4\" fill-rule=\"evenodd\" d=\"",
               pieces_path(view, result, pairing), "\"/>\n");
  };
  const auto stroke = [&](const CurveView& curve, const char* colour, double pixels) {
    append_all(svg, "<path fill=\"none\" stroke=\"", colour, "\" stroke-width=\"", pixels * subpixels, "\" d=\"",
               curve_path(view, curve), "\"/>\n");
  };
  fill(Pairing::c1_minus_c2, colour1);
  fill(Pairing::c2_minus_c1, colour2);
  // The first curve is the wider one, so that it can be seen where they share an arc.
  stroke(c1, colour1, 2.4);
  stroke(c2, colour2, 1.2);
  add_dots(svg, view, result.nodes);
  svg += "</g>\n";
  add_legend(svg, report, view.height() + 2 * margin + 8);
  svg += "</svg>\n";
  write_file(path, svg);
}

}  // namespace lober::cli

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "bench/accuracy/accuracy.hpp"

namespace lober::bench {
namespace {

constexpr double panel = 320, gap = 62, top = 30, bottom = 44;
constexpr int columns = 2;

// A range of whole powers of ten.
struct Decades {
  int first = 100, last = -100;
  void cover(double value) {
    first = std::min(first, static_cast<int>(std::floor(std::log10(value))));
    last = std::max(last, static_cast<int>(std::ceil(std::log10(value))));
  }
  [[nodiscard]] double at(double value) const {
    return panel * (std::log10(value) - first) / std::max(last - first, 1);
  }
};

constexpr double smallest_error = 1e-17;  // what comes out exact is drawn here

void write_panel(std::ostream& svg, const AccuracyPanel& data) {
  Decades time, error;
  for (const AccuracyCurve& curve : data.curves) {
    for (const AccuracyPoint& point : curve.points) {
      time.cover(point.seconds);
      error.cover(std::max(point.error, smallest_error));
    }
  }
  svg << "<text x='" << panel / 2 << "' y='-10' text-anchor='middle' font-weight='bold'>" << data.title << "</text>\n";
  svg << "<rect width='" << panel << "' height='" << panel << "' fill='none' stroke='#444'/>\n";
  for (int decade = time.first; decade <= time.last; ++decade) {
    const double x = time.at(std::pow(10, decade));
    svg << "<path d='M" << x << " 0V" << panel << "' stroke='#e4e4e4'/><text x='" << x << "' y='" << panel + 16
        << "' text-anchor='middle'>1e" << decade << "</text>\n";
  }
  const int every = error.last - error.first > 10 ? 2 : 1;
  for (int decade = error.first; decade <= error.last; decade += every) {
    const double y = panel - error.at(std::pow(10, decade));
    svg << "<path d='M0 " << y << "H" << panel << "' stroke='#e4e4e4'/><text x='-6' y='" << y + 4
        << "' text-anchor='end'>1e" << decade << "</text>\n";
  }
  for (const AccuracyCurve& curve : data.curves) {
    svg << "<path fill='none' stroke='" << curve.colour << "' stroke-width='1.8' d='";
    char command = 'M';
    for (const AccuracyPoint& point : curve.points) {
      svg << command << time.at(point.seconds) << ' ' << panel - error.at(std::max(point.error, smallest_error)) << ' ';
      command = 'L';
    }
    svg << "'/>\n";
    for (const AccuracyPoint& point : curve.points) {
      svg << "<circle r='2.4' fill='" << curve.colour << "' cx='" << time.at(point.seconds) << "' cy='"
          << panel - error.at(std::max(point.error, smallest_error)) << "'/>";
    }
    svg << '\n';
  }
}

}  // namespace

void write_plot(std::ostream& stream, const std::vector<AccuracyPanel>& panels, std::string_view caption) {
  const auto count = static_cast<int>(panels.size());
  const int rows = (count + columns - 1) / columns;
  const double legend = 22.0 * static_cast<double>((panels.empty() ? 0 : panels[0].curves.size() + 1) / 2) + 20;
  const double width = columns * (panel + gap) + 20, height = rows * (panel + top + bottom) + legend;
  stream << std::setprecision(5) << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << width << ' ' << height
         << "' font-family='sans-serif' font-size='12'>\n<rect width='" << width << "' height='" << height
         << "' fill='white'/>\n";
  for (int k = 0; k < count; ++k) {
    stream << "<g transform='translate(" << gap + k % columns * (panel + gap) << ' '
           << top + k / columns * (panel + top + bottom) << ")'>\n";
    write_panel(stream, panels[static_cast<std::size_t>(k)]);
    stream << "</g>\n";
  }
  const double below = rows * (panel + top + bottom);
  stream << "<text x='" << width / 2 << "' y='" << below - 4 << "' text-anchor='middle'>" << caption << "</text>\n";
  if (!panels.empty()) {
    for (std::size_t k = 0; k < panels[0].curves.size(); ++k) {
      const double x = gap + static_cast<double>(k % 2) * (panel + gap),
                   y = below + 20 + 22.0 * static_cast<double>(k / 2);
      stream << "<path d='M" << x << ' ' << y - 4 << "h24' stroke='" << panels[0].curves[k].colour
             << "' stroke-width='3'/><text x='" << x + 32 << "' y='" << y << "'>" << panels[0].curves[k].method
             << "</text>\n";
    }
  }
  stream << "</svg>\n";
}

}  // namespace lober::bench

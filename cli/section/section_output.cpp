#include "cli/section/section_output.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "cli/picture/cells.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/program/output_names.hpp"
#include "cli/report/text.hpp"
#include "engine/files/npy_header.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

constexpr std::array<const char*, 6> density_colours{"#8fb0d4", "#6f98c6", "#5080b5", "#35659c", "#1d457a", "#0d2749"};

// One level of counts is twice the one before, up to the last, which is the darkest.
std::size_t level_of(std::uint32_t count, std::uint32_t largest) {
  const auto levels = static_cast<std::size_t>(std::bit_width(largest));
  const auto level = static_cast<std::size_t>(std::bit_width(count)) - 1;
  const std::size_t colours = density_colours.size();
  return levels <= colours ? level + colours - levels : level * colours / levels;
}

template <typename Has>
std::vector<Rectangle> section_boxes(const Rectangle& window, std::size_t columns, std::size_t rows, const Has& has) {
  return cell_boxes(columns, rows, has, [&](std::size_t column, std::size_t row) {
    return cell_corner(window, columns, rows, column, row);
  });
}

// Colours of orbits that leave after crossing 1, 2, ..., the last one for all later ones; and of those that stay.
constexpr std::array<const char*, 8> exit_colours{"#440154", "#46327e", "#365c8d", "#277f8e",
                                                  "#1fa187", "#4ac16d", "#a0da39", "#fde725"};
constexpr const char* staying_colour = "#dddddd";

Figure section_frame(const Rectangle& window, const System& system, const char* what) {
  Figure figure{.what = what, .title = system_title(system.info)};
  name_axes(figure, system);
  figure.window = window;
  return figure;
}

}  // namespace

Density::Density(const Rectangle& window, std::size_t columns, std::size_t rows)
    : window_(window), columns_(columns), rows_(rows), counts_(columns * rows) {}

void Density::add(std::span<const Point> points) {
  for (const Point& point : points) {
    const double x = (point.x - window_.min_x) / window_.width(), y = (point.y - window_.min_y) / window_.height();
    if (std::isnan(x) || std::isnan(y)) continue;
    if (!(x >= 0 && x < 1 && y >= 0 && y < 1)) {
      ++outside_;
      continue;
    }
    ++inside_;
    const auto column = std::min(columns_ - 1, static_cast<std::size_t>(x * static_cast<double>(columns_)));
    const auto row = std::min(rows_ - 1, static_cast<std::size_t>(y * static_cast<double>(rows_)));
    std::uint32_t& count = counts_[row * columns_ + column];
    if (count != 0xffffffff) ++count;
  }
}

std::uint32_t Density::largest() const {
  return *std::max_element(counts_.begin(), counts_.end());
}

void OrbitFile::require_name(const std::string& path) {
  const Format format = path == "-" ? Format::csv : table_format(path);
  if (format == Format::npy || format == Format::csv) return;
  throw UsageError("-o " + path + ": orbits are written as .npy or .csv; use one of these endings");
}

OrbitFile::OrbitFile(const std::string& path, std::size_t orbits, std::size_t iterates)
    : file_(path), each_(iterates + 1), npy_(path != "-" && table_format(path) == Format::npy) {
  file_.write(npy_ ? detail::npy_head(std::array{orbits, each_, std::size_t{2}}) : "orbit,iterate,x,y\n");
}

void OrbitFile::add(std::size_t first, std::span<const Point> points) {
  if (npy_) return file_.write({reinterpret_cast<const char*>(points.data()), points.size_bytes()});
  std::string text;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!std::isfinite(points[k].x) || !std::isfinite(points[k].y)) continue;
    append_all(text, first + k / each_, ",", k % each_, ",", points[k].x, ",", points[k].y, "\n");
    if (text.size() < (std::size_t{1} << 20)) continue;
    file_.write(text);
    text.clear();
  }
  file_.write(text);
}

Figure section_figure(const Density& density, const System& system) {
  Figure figure = section_frame(density.window(), system, "Orbits on a section");
  const std::uint32_t largest = density.inside() > 0 ? density.largest() : 0;
  for (std::size_t level = 0; level < density_colours.size() && largest > 0; ++level) {
    // The least and the largest count of the level.
    std::uint64_t low = 0, high = 0;
    for (std::uint64_t power = 1; power <= largest; power *= 2) {
      if (level_of(static_cast<std::uint32_t>(power), largest) != level) continue;
      if (low == 0) low = power;
      high = std::min<std::uint64_t>(2 * power - 1, largest);
    }
    if (low == 0) continue;
    const std::string text = (low == high ? std::to_string(low) : std::to_string(low) + " to " + std::to_string(high)) +
                             (high == 1 ? " point a cell" : " points a cell");
    Layer layer = box_layer(text, text, density_colours[level]);
    layer.boxes =
        section_boxes(density.window(), density.columns(), density.rows(), [&](std::size_t column, std::size_t row) {
          const std::uint32_t count = density.count(column, row);
          return count > 0 && level_of(count, largest) == level;
        });
    figure.layers.push_back(std::move(layer));
  }
  add_section_edge(figure, system);
  return figure;
}

Figure exit_times_figure(const operations::ExitTimes& times, std::size_t iterates, const System& system) {
  Figure figure = section_frame(times.window, system, "When orbits leave");
  const std::vector<std::uint64_t> counts = times.counts();
  const std::size_t shown = std::min(counts.size(), exit_colours.size() + 1);
  const auto add = [&](const char* colour, const std::string& text, const auto& has) {
    Layer layer = box_layer(text, text, colour);
    layer.boxes = section_boxes(times.window, times.columns, times.rows,
                                [&](std::size_t column, std::size_t row) { return has(times.of(column, row)); });
    figure.layers.push_back(std::move(layer));
  };
  const auto is_last = [&](std::size_t n) { return n == exit_colours.size(); };
  for (std::size_t n = 1; n < shown; ++n) {
    add(exit_colours[n - 1],
        "leaves after crossing " + std::to_string(n) + (is_last(n) && counts.size() > shown ? " or later" : ""),
        [&](std::uint32_t time) {
          return time != operations::ExitTimes::stays && (is_last(n) ? time >= n : time == n);
        });
  }
  add(staying_colour, "does not leave in " + std::to_string(iterates) + " crossings",
      [](std::uint32_t time) { return time == operations::ExitTimes::stays; });
  add_section_edge(figure, system);
  return figure;
}

}  // namespace lober::cli

#include "cli/report/report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lober::cli {

std::string spec_of(const NamedCurve& input) {
  if (input.zones < 2) return input.file;
  return input.file + "#" + (input.group.empty() ? std::to_string(input.zone) : input.group);
}

Table areas_table(const std::string& of, const std::string& what) {
  return Table({{of, 16, Align::left, 0}, {what, 23}, {"+- rounding", 11, Align::right, 2}});
}

std::vector<std::string> area_cells(const NamedArea& area, const Areas& areas, const Areas& rounding) {
  return {area.label, fmt::format("{:.16g}", areas.*area.member), fmt::format("{:.1e}", rounding.*area.member)};
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string meetings_text(const Crossings& nodes) {
  if (nodes.same_curve()) return "the two curves are one and the same";
  return fmt::format("{}, {}, {}", counted(nodes.crossings(), "crossing", "crossings"),
                     counted(nodes.touches(), "touch", "touches"),
                     counted(nodes.shared_arcs(), "shared arc", "shared arcs"));
}

std::string inputs_text(const std::array<NamedCurve, 2>& inputs, const std::array<Orientation, 2>& orientations) {
  const std::array<std::string, 2> specs{spec_of(inputs[0]), spec_of(inputs[1])};
  const std::size_t width = std::max(specs[0].size(), specs[1].size());
  std::string text;
  for (std::size_t k = 0; k < 2; ++k) {
    text += fmt::format(
        "C{}  {:<{}}  {:>9} points  {}\n", k + 1, specs[k], width, inputs[k].curve.points.size(),
        orientations[k] == Orientation::counter_clockwise ? "counter-clockwise" : std::string(name(orientations[k])));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    if (!inputs[k].remark.empty()) text += fmt::format("C{} {}\n", k + 1, inputs[k].remark);
  }
  return text;
}

std::vector<std::uint32_t> largest(std::span<const double> areas) {
  std::vector<std::uint32_t> order(areas.size());
  std::iota(order.begin(), order.end(), 0U);
  const std::size_t count = std::min(max_table_rows, order.size());
  std::partial_sort(
      order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
      [&](std::uint32_t x, std::uint32_t y) { return areas[x] != areas[y] ? areas[x] > areas[y] : x < y; });
  order.resize(count);
  return order;
}

}  // namespace lober::cli

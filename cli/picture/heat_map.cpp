#include "cli/picture/heat_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "cli/picture/system_figure.hpp"
#include "cli/picture/ticks.hpp"
#include "viewer/palette.hpp"

namespace lober::cli {
namespace {

constexpr int max_classes = 8;
constexpr double max_step_ratio = 3;

std::string heat_colour(double part) {
  const double at = std::clamp(part, 0.0, 1.0) * (palette::heat.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(at), palette::heat.size() - 2);
  std::array<int, 3> mixed{};
  for (std::size_t c = 0; c < mixed.size(); ++c) {
    mixed[c] = static_cast<int>(std::lround(palette::heat[k][c] + (palette::heat[k + 1][c] - palette::heat[k][c]) *
                                                                      (at - static_cast<double>(k))));
  }
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", static_cast<unsigned>(mixed[0]),
                static_cast<unsigned>(mixed[1]), static_cast<unsigned>(mixed[2]));
  return text.data();
}

// Numbers with as many digits as they need to be told apart.
std::vector<std::string> distinct_texts(const std::vector<double>& numbers) {
  std::vector<std::string> texts;
  for (int digits = 4; digits <= 17; ++digits) {
    texts.clear();
    for (const double number : numbers) {
      std::array<char, 40> text{};
      std::snprintf(text.data(), text.size(), "%.*g", digits, number == 0 ? 0.0 : number);
      texts.emplace_back(text.data());
    }
    if (numbers.front() == numbers.back() || std::adjacent_find(texts.begin(), texts.end()) == texts.end()) break;
  }
  return texts;
}

// Round limits of classes, from below the least value to above the largest one; none where all are equal.
std::vector<double> class_limits(double low, double high) {
  std::vector<double> limits;
  const Ticks ticks = ticks_between(low, high, max_classes);
  for (const Tick& tick : ticks.list) {
    if (tick.fraction > 1e-9 && tick.fraction < 1 - 1e-9) limits.push_back(low + tick.fraction * (high - low));
  }
  return limits;
}

}  // namespace

HeatAxis HeatAxis::of_names(std::string name, std::vector<std::string> names) {
  HeatAxis made{.axis = {std::move(name)}};
  for (std::size_t k = 0; k <= names.size(); ++k) made.edges.push_back(static_cast<double>(k) - 0.5);
  made.axis.categories = std::move(names);
  return made;
}

HeatAxis HeatAxis::of_numbers(std::string name, const std::vector<double>& numbers, std::size_t max_names) {
  double least = HUGE_VAL, largest = 0;
  for (std::size_t k = 0; k + 1 < numbers.size(); ++k) {
    least = std::min(least, numbers[k + 1] - numbers[k]);
    largest = std::max(largest, numbers[k + 1] - numbers[k]);
  }
  const bool are_few = numbers.size() <= max_names && (numbers.size() == 2 || largest <= 1.01 * least);
  if (numbers.size() < 2 || are_few || !(largest <= max_step_ratio * least)) {
    return of_names(std::move(name), distinct_texts(numbers));
  }
  HeatAxis made{.axis = {std::move(name)}};
  made.axis.whole_numbers =
      std::all_of(numbers.begin(), numbers.end(), [](double number) { return number == std::floor(number); });
  made.edges.push_back(numbers[0] - (numbers[1] - numbers[0]) / 2);
  for (std::size_t k = 0; k + 1 < numbers.size(); ++k) made.edges.push_back(numbers[k] / 2 + numbers[k + 1] / 2);
  made.edges.push_back(numbers.back() + (numbers.back() - numbers[numbers.size() - 2]) / 2);
  return made;
}

void add_heat_map(Figure& figure, const HeatAxis& x, const HeatAxis& y, const std::vector<HeatCell>& cells) {
  figure.x = x.axis;
  figure.y = y.axis;
  figure.plane = false;
  figure.guides = false;
  figure.window = {x.edges.front(), y.edges.front(), x.edges.back(), y.edges.back()};
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const HeatCell& cell : cells) {
    if (!std::isfinite(cell.value)) continue;
    low = std::min(low, cell.value);
    high = std::max(high, cell.value);
  }
  if (low > high) {
    figure.notes.emplace_back("no values");
    return;
  }
  std::vector<double> limits = class_limits(low, high);
  limits.insert(limits.begin(), low);
  limits.push_back(high);
  const std::vector<std::string> texts = distinct_texts(limits);
  const std::size_t classes = low < high ? limits.size() - 1 : 1;
  for (std::size_t k = 0; k < classes; ++k) {
    const bool is_last = k + 1 == classes;
    const std::string text = low < high ? texts[k] + " to " + texts[k + 1] : texts[0];
    const double part = classes > 1 ? static_cast<double>(k) / static_cast<double>(classes - 1) : 0.5;
    Layer layer = box_layer(text, text, heat_colour(part));
    for (const HeatCell& cell : cells) {
      if (!(cell.value >= limits[k] && (is_last ? cell.value <= high : cell.value < limits[k + 1]))) continue;
      layer.values.push_back(cell.value);
      layer.boxes.push_back({x.edges[cell.column], y.edges[cell.row], x.edges[cell.column + 1], y.edges[cell.row + 1]});
    }
    figure.layers.push_back(std::move(layer));
  }
}

}  // namespace lober::cli

#include "cli/picture/figure_data.hpp"

#include <cmath>

#include "cli/report/json.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr std::array<const char*, 4> kind_names{"fill", "line", "dots", "boxes"};

const char* kind_name(const Layer& layer) {
  return kind_names[static_cast<std::size_t>(layer.kind)];
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

Json pair_json(Point point) {
  return Json::array({point.x, point.y});
}

Json points_json(std::span<const Point> points) {
  Json list = Json::array();
  for (const Point& point : points) list.push_back(pair_json(point));
  return list;
}

Json box_json(const Rectangle& box) {
  return Json::array({box.min_x, box.min_y, box.max_x, box.max_y});
}

Json layer_json(const Layer& layer) {
  Json json{{"name", layer.name}, {"kind", kind_name(layer)}, {"legend", layer.legend}, {"colour", layer.colour}};
  Json items = Json::array();
  for (const Polyline& line : layer.lines) {
    items.push_back({{"name", line.name},
                     {"closed", line.closed || layer.kind == LayerKind::fill},
                     {"points", points_json(line.points())}});
  }
  if (!layer.points.empty()) {
    Json item{{"name", ""}, {"closed", false}, {"points", points_json(layer.points)}};
    if (!layer.errors.empty()) item["errors"] = layer.errors;
    items.push_back(std::move(item));
  }
  json["items"] = std::move(items);
  if (layer.kind == LayerKind::boxes) {
    Json boxes = Json::array();
    for (const Rectangle& box : layer.boxes) boxes.push_back(box_json(box));
    json["boxes"] = std::move(boxes);
    if (!layer.values.empty()) json["values"] = layer.values;
  }
  return json;
}

}  // namespace

std::string figure_csv(const Figure& figure) {
  std::string text = "layer,item,name,x,y,error\n";
  for (const Layer& layer : figure.layers) {
    const std::string name = quoted(layer.name);
    std::size_t item = 0;
    for (const Polyline& line : layer.lines) {
      const std::string line_name = quoted(line.name);
      for (const Point& point : line.points()) {
        append_all(text, name, ",", item, ",", line_name, ",", point.x, ",", point.y, ",\n");
      }
      ++item;
    }
    for (std::size_t k = 0; k < layer.points.size(); ++k) {
      append_all(text, name, ",", item + k, ",,", layer.points[k].x, ",", layer.points[k].y, ",");
      if (k < layer.errors.size()) append(text, layer.errors[k]);
      text += "\n";
    }
    for (std::size_t k = 0; k < layer.boxes.size(); ++k) {
      const Rectangle& box = layer.boxes[k];
      std::string value;
      if (k < layer.values.size()) append(value, layer.values[k]);
      append_all(text, name, ",", item + k, ",", value, ",", box.min_x, ",", box.min_y, ",\n", name, ",", item + k, ",",
                 value, ",", box.max_x, ",", box.max_y, ",\n");
    }
  }
  return text;
}

std::string figure_json(const Figure& figure) {
  const auto axis = [](const Axis& one) {
    Json made{{"name", one.name}, {"unit", one.unit}};
    if (one.exponents) made["scale"] = "values are powers of ten";
    if (!one.categories.empty()) made["categories"] = one.categories;
    return made;
  };
  Json json{{"picture", figure.what},
            {"title", figure.title},
            {"x", axis(figure.x)},
            {"y", axis(figure.y)},
            {"window", box_json(figure.window)},
            {"vertical_lines", figure.x_marks}};
  Json layers = Json::array();
  for (const Layer& layer : figure.layers) layers.push_back(layer_json(layer));
  json["layers"] = std::move(layers);
  return json.dump(1) + "\n";
}

}  // namespace lober::cli

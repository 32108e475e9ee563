#include "viewer/page_data.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/base/append_text.hpp"
#include "engine/base/json_text.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/utf8.hpp"
#include "engine/files/formats/gzip.hpp"
#include "lober/base/error.hpp"
#include "viewer/base64.hpp"
#include "viewer/runs.hpp"
#include "viewer/series.hpp"

namespace lober::viewer {
namespace {

using detail::append_all;

constexpr std::size_t part_values = 65536;
constexpr std::size_t tiny_curve = 4096;  // points of curves that are always exact

// Names of files may be any bytes.
std::string text_json(std::string_view text) {
  return detail::json_string(detail::as_utf8(text));
}

std::string list_of(const std::vector<std::string>& texts) {
  std::string json = "[";
  for (const std::string& text : texts) append_all(json, json.size() > 1 ? ",\n" : "", text_json(text));
  return json + "]";
}

const char* name_of(Layer::Kind kind) {
  switch (kind) {
    case Layer::Kind::lines:
      return "lines";
    case Layer::Kind::areas:
      return "areas";
    case Layer::Kind::outlines:
      return "outlines";
    case Layer::Kind::dots:
      break;
  }
  return "dots";
}

// Collects series, whose parts are written in parallel in the end.
class SeriesList {
 public:
  // The members n and at of a series, which is copied.
  std::string add(std::vector<double> values) {
    const auto kept = std::make_shared<const std::vector<double>>(std::move(values));
    const std::string members = begin(kept->size());
    for (std::size_t first = 0; first < kept->size(); first += part_values) {
      parts_.emplace_back([kept, first](bool) {
        return encode_series(std::span(*kept).subspan(first, std::min(part_values, kept->size() - first)));
      });
    }
    return members;
  }

  // Of points, which stay alive. `step`: see encode_series, where they may be rounded; `exact`: numbers of points that
  // may not, ascending.
  std::string add(std::span<const Point> points, double step, const std::vector<std::uint32_t>& exact) {
    const std::string members = begin(points.size());
    for (std::size_t first = 0; first < points.size(); first += part_values) {
      const auto part = points.subspan(first, std::min(part_values, points.size() - first));
      std::vector<std::uint32_t> here;
      for (auto at = std::lower_bound(exact.begin(), exact.end(), first);
           at != exact.end() && *at < first + part.size(); ++at) {
        here.push_back(*at - static_cast<std::uint32_t>(first));
      }
      parts_.emplace_back([part, step, here](bool rounds) {
        std::vector<double> x, y;
        for (const Point& point : part) {
          x.push_back(point.x);
          y.push_back(point.y);
        }
        return encode_points(x, y, rounds ? step : 0, here);
      });
    }
    return members;
  }

  [[nodiscard]] std::vector<std::string> written(bool deflates, bool rounds) const {
    std::vector<std::string> texts(parts_.size());
    detail::for_each_block(parts_.size(), 1, [&](std::size_t k, std::size_t) {
      const std::string bytes = parts_[k](rounds);
      texts[k] = base64(deflates ? *detail::deflated(bytes) : bytes);
    });
    return texts;
  }

 private:
  std::string begin(std::size_t size) const {
    return "\"n\":" + std::to_string(size) + ",\"at\":" + std::to_string(parts_.size());
  }

  std::vector<std::function<std::string(bool)>> parts_;
};

// To half of this, coordinates of the curve may be rounded: 2^-50 of its size.
double step_of(std::span<const Point> points) {
  Rectangle box;
  for (const Point& point : points) box.add(point);
  const double size = std::max(box.width(), box.height());
  return size > 0 && std::isfinite(size) ? std::ldexp(1.0, std::ilogb(size) - 50) : 0;
}

std::string curve_json(const Line& line, SeriesList& series) {
  const std::span<const Point> points = line.curve.points;
  std::vector<std::uint32_t> ends;
  for (const std::uint32_t segment : line.exact) {
    ends.push_back(segment);
    ends.push_back(segment + 1 < points.size() ? segment + 1 : 0);
  }
  std::sort(ends.begin(), ends.end());
  const double step = points.size() <= tiny_curve ? 0 : step_of(points);
  return "{\"name\":" + text_json(line.name) + ",\"closed\":" + (line.curve.closed ? "true" : "false") + "," +
         series.add(points, step, ends) + "}";
}

std::string areas_json(const Layer& layer, const RunFinder& finder, std::vector<Point>& pool, SeriesList& series) {
  std::vector<double> rings, runs, curve, first, last;
  for (const Polygons& area : layer.areas) {
    rings.push_back(static_cast<double>(area.size()));
    for (const std::vector<Point>& ring : area) {
      const std::vector<Run> found = finder.runs(ring, pool);
      runs.push_back(static_cast<double>(found.size()));
      for (const Run& run : found) {
        curve.push_back(run.curve);
        first.push_back(run.first);
        last.push_back(run.last);
      }
    }
  }
  std::string json;
  for (auto& [name, values] :
       {std::pair{"rings", &rings}, {"runs", &runs}, {"curve", &curve}, {"first", &first}, {"last", &last}}) {
    append_all(json, ",\"", name, "\":{", series.add(std::move(*values)), "}");
  }
  return json;
}

std::string columns_json(const Layer& layer, SeriesList& series) {
  std::string json = "[";
  for (const Column& column : layer.columns) {
    append_all(json, json.size() > 1 ? "," : "", "{\"name\":", text_json(column.name), ",", series.add(column.values));
    if (!column.bar.empty()) append_all(json, ",\"bar\":{", series.add(column.bar), "}");
    json += "}";
  }
  return json + "]";
}

std::string iterates_json(const std::vector<int>& iterates) {
  std::string json = ",\"iterates\":[";
  for (const int n : iterates) append_all(json, json.ends_with('[') ? "" : ",", n);
  return json + "]";
}

void require_finite(const Scene& scene) {
  const auto finite = [](const Point& point) { return std::isfinite(point.x) && std::isfinite(point.y); };
  for (const Layer& layer : scene.layers) {
    for (const Line& line : layer.lines) {
      if (!std::all_of(line.curve.points.begin(), line.curve.points.end(), finite)) {
        throw DataError(line.name + ": a coordinate is not finite");
      }
    }
  }
}

// No character that HTML reads within a script, and none that ends one.
std::string without_markup(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::size_t size_of(const std::vector<std::string>& texts) {
  std::size_t size = 0;
  for (const std::string& text : texts) size += text.size();
  return size;
}

}  // namespace

PageData page_data(const Scene& scene, std::size_t max_size) {
  require_finite(scene);
  std::vector<std::span<const Point>> curves;
  bool has_areas = false;
  for (const Layer& layer : scene.layers) {
    for (const Line& line : layer.lines) {
      curves.push_back(line.curve.points);
    }
    has_areas = has_areas || !layer.areas.empty();
  }
  const RunFinder finder(has_areas ? curves : std::vector<std::span<const Point>>(curves.size()));
  SeriesList series;
  std::vector<Point> pool;
  std::string json =
      "{\"title\":" + text_json(scene.title) + ",\n\"notes\":" + list_of(scene.notes) + ",\n\"layers\":[";
  for (const Layer& layer : scene.layers) {
    append_all(json, &layer == scene.layers.data() ? "" : ",\n", "{\"kind\":\"", name_of(layer.kind),
               "\",\"name\":", text_json(layer.name), ",\"one\":", text_json(layer.one),
               ",\"colour\":", text_json(layer.colour), ",\"width\":", layer.width,
               ",\"shown\":", layer.shown ? "true" : "false", ",\"iterate\":", layer.iterate_column);
    if (!layer.iterates.empty()) json += iterates_json(layer.iterates);
    if (layer.kind == Layer::Kind::lines) {
      json += ",\"curves\":[";
      for (const Line& line : layer.lines) {
        append_all(json, &line == layer.lines.data() ? "" : ",\n", curve_json(line, series));
      }
      json += "]";
    } else {
      append_all(json, ",\"n\":", layer.size(), ",\"names\":", list_of(layer.names),
                 ",\"columns\":", columns_json(layer, series));
      if (layer.kind == Layer::Kind::dots) {
        append_all(json, ",\"points\":{", series.add(layer.dots, 0, {}), "}");
      } else {
        json += areas_json(layer, finder, pool, series);
      }
    }
    json += "}";
  }
  append_all(json, "],\n\"pool\":{", series.add(pool, 0, {}), "}");
  const bool deflates = detail::deflated("").has_value();
  PageData data;
  data.series = series.written(deflates, false);
  const bool rounds = size_of(data.series) > max_size;
  if (rounds) data.series = series.written(deflates, true);
  append_all(json, ",\n\"deflated\":", deflates ? "true" : "false", ",\"rounded\":", rounds ? "true}" : "false}");
  data.json = without_markup(json);
  return data;
}

}  // namespace lober::viewer

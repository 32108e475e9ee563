// The files of curves: one of all of them, or one for each.

#include <spdlog/fmt/fmt.h>

#include "cli/image/image_report.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/system_options.hpp"
#include "cli/report/curve_file.hpp"
#include "lober/base/error.hpp"

namespace lober::cli {
namespace {

constexpr std::string_view iterate_placeholder = "{n}";

// The zones of an image: closed ones without a copy of their first point at the end.
void add_zones(std::vector<Zone>& zones, const std::string& name, const std::vector<ImagePart>& parts) {
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Buffer<Point>& points = parts[k].points;
    zones.push_back({parts.size() == 1 ? name : fmt::format("{} part {} of {}", name, k + 1, parts.size()),
                     {points.begin(), points.end()}});
    zones.back().closed = parts[k].closed;
  }
}

CurveFileOptions options_of(const ImageReport& report, const std::string& format) {
  return {.format = format,
          .notes = notes_of("image", report.outcome,
                            report.input ? std::vector{note_on(*report.input)} : std::vector<std::string>{},
                            system_note(*report.system.system)),
          .zone_lines = ZoneLines::always};
}

// The one curve of the one image that any format takes.
const ImagePart& only_curve(const ImageReport& report, const std::string& path) {
  const auto& images = report.found().images;
  if (images.size() == 1 && images[0].parts.size() == 1) return images[0].parts[0];
  throw DataError("-o " + path +
                  ": the image has gaps and is several curves, which need a format that holds "
                  "several, as .dat (Tecplot), .npz or .geojson, or a name with {n}");
}

}  // namespace

bool takes_images(const std::string& path, const std::string& format) {
  return path != "-" && (path.find(iterate_placeholder) != std::string::npos || takes_several(path, format));
}

std::string image_path(const std::string& path, int iterate, std::size_t curve, std::size_t part) {
  const std::size_t at = path.find(iterate_placeholder);
  if (at == std::string::npos) return path;
  std::string number = std::to_string(iterate);
  if (curve > 0) number += fmt::format("-boundary{}", curve + 1);
  if (part > 0) number += fmt::format("-part{}", part);
  return std::string(path).replace(at, iterate_placeholder.size(), number);
}

void write_images(const std::string& path, const std::string& format, const ImageReport& report) {
  CurveFileOptions options = options_of(report, format);
  if (path.find(iterate_placeholder) == std::string::npos) {
    if (!takes_several(path, format)) {
      const ImagePart& only = only_curve(report, path);
      options.closed = only.closed;
      return write_curve_file(path, only.points, options);
    }
    std::vector<Zone> zones;
    for (const auto& one : report.found().images) add_zones(zones, one.name(), one.parts);
    return write_curve_file(path, zones, options);
  }
  options.zone_lines = ZoneLines::where_needed;
  for (const auto& one : report.found().images) {
    for (std::size_t part = 0; part < one.parts.size(); ++part) {
      options.closed = one.parts[part].closed;
      write_curve_file(image_path(path, one.image.iterate, one.curve, one.parts.size() == 1 ? 0 : part + 1),
                       one.parts[part].points, options);
    }
  }
}

}  // namespace lober::cli

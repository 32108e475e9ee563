#include "cli/point_file.hpp"

#include <array>
#include <filesystem>
#include <utility>

#include "engine/error.hpp"

namespace lober::cli {

PointFormat format_of(const std::string& path) {
  if (path == "-") return PointFormat::text;
  const std::string ending = std::filesystem::path(path).extension().string();
  constexpr std::array<std::pair<const char*, PointFormat>, 5> endings{{{".npy", PointFormat::npy},
                                                                        {".csv", PointFormat::csv},
                                                                        {".txt", PointFormat::text},
                                                                        {".dat", PointFormat::tecplot},
                                                                        {".raw", PointFormat::raw}}};
  for (const auto& [known, format] : endings) {
    if (ending == known) return format;
  }
  throw UsageError(path + ": the ending has to say the format: .npy, .csv, .txt, .dat (Tecplot) or .raw");
}

void write_points(const std::string& path, const Buffer<Point>& points) {
  switch (format_of(path)) {
    case PointFormat::npy:
      return write_npy(path, points);
    case PointFormat::csv:
      return write_text(path, points, ',');
    case PointFormat::text:
      return write_text(path, points);
    case PointFormat::raw:
      return write_raw(path, points);
    case PointFormat::tecplot:
      break;
  }
  const Zone zone{"", {points.begin(), points.end()}, 1};
  write_tecplot(path, {&zone, 1});
}

}  // namespace lober::cli

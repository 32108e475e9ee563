#include "engine/batch/manifest/file_unit.hpp"

#include <algorithm>
#include <filesystem>
#include <new>
#include <span>

#include "lober/curve/curve.hpp"
#include "lober/curve/cylinders.hpp"
#include "lober/curve/files.hpp"

namespace lober::detail {
namespace {

LoadedCurve take_zone(CurveFile& file, const CurveSource& wanted, bool last_use) {
  LoadedCurve loaded;
  if (!file.sha256.empty()) loaded.digest = zone_digest(file.sha256, wanted);
  const std::size_t zones = file.zones.size();
  if (!wanted.zone && zones > 1) {
    const std::string name = file.path + (wanted.columns.empty() ? "" : ":" + wanted.columns);
    loaded.error =
        file.path + ": has " + std::to_string(zones) + " zones, choose with " + name + "#0 or " + name + "#*";
    return loaded;
  }
  const std::size_t number = wanted.zone.value_or(0);
  if (number >= zones) {
    loaded.error = wanted.location() + ": there is no such zone, the file has " + std::to_string(zones);
    return loaded;
  }
  Zone& zone = file.zones[number];
  Curve curve{last_use ? std::move(zone.points) : zone.points, wanted.closed, wanted.location()};
  curve.latitude_first = latitude_first(file);
  unwrap(curve.points, wanted.periods);
  if (const std::string warning = date_line_warning(file.header, curve.points); !warning.empty()) {
    loaded.warning = wanted.location() + ": " + warning + "; the manifest needs " + period_of_longitudes(curve);
  }
  if (wanted.closed) {
    drop_closing_vertex(curve.points);
    try {
      require_closed_in_the_plane(curve.points, wanted.periods, wanted.location());
    } catch (const DataError& error) {
      loaded.error = error.what();
      return loaded;
    }
  }
  loaded.curve = std::make_shared<const Curve>(std::move(curve));
  return loaded;
}

// The curves of an unreadable file, known by its content all the same, so that a later run knows the failures again.
std::vector<LoadedCurve> unreadable(const std::string& path, std::span<const CurveSource> zones, bool digests,
                                    const std::string& error) {
  std::string sha256;
  try {
    if (digests) sha256 = file_sha256(path);
  } catch (const DataError&) {  // there is no content
  }
  std::vector<LoadedCurve> loaded;
  for (const CurveSource& zone : zones) {
    loaded.push_back({nullptr, sha256.empty() ? std::string() : zone_digest(sha256, zone), error});
  }
  return loaded;
}

}  // namespace

CurveUnit file_unit(std::string path, std::vector<CurveSource> zones, std::size_t points) {
  CurveUnit unit;
  unit.curves = zones.size();
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  // A file of no size is not read.
  unit.points = !ignored && size == 0 ? 0 : points != 0 ? points : estimate_points(path);
  if (!ignored) unit.reading_memory = size + unit.points * sizeof(Point);  // the bytes, and chunks being joined
  unit.load = [path = std::move(path), zones = std::move(zones)](const Loading& loading) {
    CurveFile file;
    try {
      require_regular(path);
      file = read_curve_file(path, {.hash = loading.digests, .columns = zones.front().columns});
    } catch (const DataError& error) {
      return unreadable(path, zones, loading.digests, error.what());
    } catch (const std::bad_alloc&) {
      return unreadable(path, zones, loading.digests, "out of memory");
    }
    std::vector<LoadedCurve> loaded;
    for (std::size_t k = 0; k < zones.size(); ++k) {
      const bool last_use = std::none_of(zones.begin() + static_cast<std::ptrdiff_t>(k) + 1, zones.end(),
                                         [&](const CurveSource& later) { return later.zone == zones[k].zone; });
      loaded.push_back(take_zone(file, zones[k], last_use));
    }
    return loaded;
  };
  return unit;
}

std::string zone_digest(const std::string& sha256, const CurveSource& zone) {
  return sha256 + (zone.columns.empty() ? "" : ":" + zone.columns) +
         (zone.zone ? "#" + std::to_string(*zone.zone) : "") + zone.periodic() + (zone.closed ? "" : " open");
}

void require_regular(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status)) return;
  if (std::filesystem::is_regular_file(status)) {
    // Files under /proc have a size of zero and content without end, for which no memory could be booked.
    if (std::filesystem::file_size(path, ignored) > 0) return;
    throw DataError(path + ": is empty, or has a size that is not known before it is read; copy it to a file first");
  }
  throw DataError(path + ": is not a regular file; a batch reads its inputs more than once");
}

std::string file_sha256(const std::string& path) {
  require_regular(path);
  return sha256_of_file(path);
}

}  // namespace lober::detail

#include <cstring>

#include "engine/base/finite.hpp"
#include "engine/files/binary_file.hpp"

namespace lober::detail {

void add_only_zone(std::vector<Point> points, CurveFile& file) {
  if (points.empty()) throw DataError(file.path + ": no points");
  if (const std::size_t bad = first_not_finite(points); bad != points.size()) {
    throw DataError(file.path + ": point " + std::to_string(bad) + " is not a finite number");
  }
  file.zones.push_back({{}, std::move(points), 1});
}

void read_raw(std::span<const std::byte> bytes, CurveFile& file) {
  file.format = Format::raw;
  if (bytes.size() % sizeof(Point) != 0) {
    throw DataError(file.path + ": neither text nor NPY, and " + std::to_string(bytes.size()) +
                    " bytes are not a whole number of raw float64 pairs");
  }
  std::vector<Point> points(bytes.size() / sizeof(Point));
  if (!points.empty()) std::memcpy(points.data(), bytes.data(), bytes.size());
  add_only_zone(std::move(points), file);
}

}  // namespace lober::detail

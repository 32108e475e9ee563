// Scans on finer and finer grids, and the index of the box, which tells whether points are missing.

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/dynamics/fixed_points/index.hpp"
#include "engine/dynamics/fixed_points/scan.hpp"
#include "engine/dynamics/fixed_points/uncertainty.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

// Work that an image of a point of the box takes, from some that are spread over it.
double work_of_image(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& options) {
  constexpr std::size_t side = 8;
  std::vector<Point> points;
  for (std::size_t k = 0; k < side * side; ++k) {
    const std::size_t column = k % side, row = k / side;
    const double x = (static_cast<double>(column) + 0.5) / side, y = (static_cast<double>(row) + 0.5) / side;
    points.push_back({box.min_x + x * box.width(), box.min_y + y * box.height()});
  }
  const std::uint64_t before = map.work();
  map.iterate(points, options.period);
  return static_cast<double>(map.work() - before) / static_cast<double>(points.size());
}

bool same_points(const std::vector<FixedPoint>& a, const std::vector<FixedPoint>& b, double extent) {
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const FixedPoint& point) {
           return std::any_of(b.begin(), b.end(),
                              [&](const FixedPoint& other) { return are_same(other, point, extent); });
         });
}

// Leaves some dozens of the degenerate points.
void thin_out(std::vector<FixedPoint>& points, int period) {
  constexpr std::size_t enough = 48;
  const auto degenerate = [&](const FixedPoint& point) { return index_of(point, period) == 0; };
  const auto count = static_cast<std::size_t>(std::count_if(points.begin(), points.end(), degenerate));
  const std::size_t step = std::max<std::size_t>(1, (count + enough - 1) / enough);
  std::size_t number = 0;
  std::erase_if(points, [&](const FixedPoint& point) { return degenerate(point) && number++ % step != 0; });
}

bool inside(const Rectangle& box, Point z) {
  return box.min_x < z.x && z.x < box.max_x && box.min_y < z.y && z.y < box.max_y;
}

// The sum for the points inside the box; none where that of a degenerate one is not known. `sign`: the factor that the
// turns of the map's displacements have to be multiplied by.
std::optional<int> sum_of_indices(const PlanarMap& map, int sign, const std::vector<FixedPoint>& points,
                                  const Rectangle& box, const FixedPointOptions& options) {
  int sum = 0;
  for (const FixedPoint& point : points) {
    const Point z = point.at;
    if (!inside(box, z)) continue;
    if (const int index = index_of(point, options.period); index != 0) {
      sum += index;
      continue;
    }
    double free = std::min({z.x - box.min_x, box.max_x - z.x, z.y - box.min_y, box.max_y - z.y});
    for (const FixedPoint& other : points) {
      if (&other != &point) free = std::min(free, length(other.at - z));
    }
    const std::optional<int> index = index_around(map, z, 0.5 * free, options);
    if (!index) return std::nullopt;
    sum += sign * *index;
  }
  return sum;
}

}  // namespace

double residue(const FixedPoint& point) {
  return 0.25 * (2 - (point.derivative.xx + point.derivative.yy));
}

FixedPointSearch search_fixed_points(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& given,
                                     int max_grid, const Progress& progress) {
  const FixedPointOptions options = options_of_scan(box, given);
  if (max_grid < options.grid) throw UsageError("the last grid of a search must not be coarser than the first one");
  FixedPointSearch search;
  const HalfWayMap half_way = half_way_map(map);
  const SearchAllowance allowance(map, half_way, options);
  const double an_image = work_of_image(map, box, options);
  // Not wanted before all points of a grid have images.
  std::optional<std::optional<int>> edge;
  FixedPointOptions each = options;
  double maps = half_way.helps(options.period) ? 2 : 1;
  const auto work_of_grid = [&] { return maps * an_image * each.grid * each.grid; };
  const auto name_of_grid = [&] {
    const std::string side = std::to_string(each.grid);
    return "grid of " + side + " x " + side;
  };
  std::vector<FixedPoint> of_smaller_periods;  // by the first scans: finer ones mend what those do not resolve
  constexpr int coarsest_grid = 12;
  while (each.grid > coarsest_grid && work_of_grid() > allowance.part(0.25))
    each.grid = std::max(each.grid / 2, coarsest_grid);
  for (bool first = true;; first = false, each.grid = std::min(2 * each.grid, max_grid)) {
    if (!progress(name_of_grid())) throw Cancelled();
    if (!first && !allowance.has(work_of_grid())) {
      search.out_of_work = true;
      return search;
    }
    const ScanGrids grids(map, half_way, box, each);
    if (grids.whole() == nullptr) maps = 1;
    std::vector<FixedPoint> found = scan(map, box, each, grids, half_way, &allowance);
    if (first) of_smaller_periods = scan_for_smaller_periods(map, box, each, half_way, &allowance);
    add_points(found, of_smaller_periods, each.extent);
    if (!allowance.has(0)) {  // the seeds may not be through: of two scans the one that found more
      search.out_of_work = true;
      if (!first && found.size() < search.points.size()) return search;
    }
    const bool same = !first && same_points(found, search.points, extent_of(box));
    search.points = std::move(found);
    search.grid = each.grid;
    if (fill_a_curve(map, search.points, each, grids.cell())) {
      search.isolated = false;
      thin_out(search.points, options.period);
      return search;
    }
    const PlanarMap* const turned = grids.with_all_images();
    const Point middle{0.5 * (box.min_x + box.max_x), 0.5 * (box.min_y + box.max_y)};
    const int sign = turned == &half_way ? half_way.orientation(options.period, middle) : 1;
    const std::optional<int> sum = sum_of_indices(turned != nullptr ? *turned : map, sign, search.points, box, each);
    search.index_sum = sum.value_or(0);
    const bool defined = sum && turned != nullptr;
    if (defined && !edge) {
      edge = index_of_edge(*turned, box, each, an_image, allowance);
      if (*edge) **edge *= sign;
    }
    search.index_of_box = defined ? *edge : std::nullopt;
    search.settled = same && sum && (!search.index_of_box || *search.index_of_box == *sum);
    // Nothing twice says little where the edge does not tell either: so it is with thin resonances.
    if (search.points.empty() && !search.index_of_box) search.settled = false;
    if (search.out_of_work) search.settled = false;
    if (search.settled || search.out_of_work || each.grid == max_grid) return search;
  }
}

}  // namespace lober

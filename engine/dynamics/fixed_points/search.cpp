// Scans on finer and finer grids, and the index of the box, which tells whether points are missing.

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>

#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/fixed_points/scan.hpp"
#include "kernels/elementary.hpp"
#include "lober/base/error.hpp"

namespace lober {
using namespace detail;
namespace {

// Where z is on its way round the box, for 0 <= t <= 4, counter-clockwise from the lower left corner.
Point on_edge(const Rectangle& box, double t) {
  const auto between = [](double low, double high, double f) { return low * (1 - f) + high * f; };
  if (t <= 1) return {between(box.min_x, box.max_x, t), box.min_y};
  if (t <= 2) return {box.max_x, between(box.min_y, box.max_y, t - 1)};
  if (t <= 3) return {between(box.max_x, box.min_x, t - 2), box.max_y};
  return {box.min_x, between(box.max_y, box.min_y, t - 3)};
}

// A point of the edge and its displacement.
struct Sample {
  double t;
  Point gap;
};

double turn(Point a, Point b) {
  return elementary::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

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

// Samples are put in until neighbouring displacements differ by less than `most` in direction; none where that takes
// more than a quarter of the work.
std::optional<int> index_of_edge(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& options,
                                 double an_image, const SearchAllowance& allowance) {
  constexpr std::size_t first_samples = 512;  // a side
  constexpr double most = 0.5;
  constexpr int rounds = 24;
  const auto displaced = [&](const std::vector<double>& ts) {
    std::vector<Point> points(ts.size());
    for_each_block(ts.size(), std::max(std::size_t{64}, map.batch()), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) points[k] = on_edge(box, ts[k]);
      map.iterate(std::span(points).subspan(begin, end - begin), options.period);
    });
    std::vector<Sample> samples(ts.size());
    for (std::size_t k = 0; k < ts.size(); ++k) {
      samples[k] = {ts[k], gap_between(on_edge(box, ts[k]), points[k], options)};
    }
    return samples;
  };
  double left = allowance.part(0.25) / std::max(an_image, 1e-3);
  if (left < 4 * first_samples) return std::nullopt;
  std::vector<double> ts;
  for (std::size_t k = 0; k <= 4 * first_samples; ++k) ts.push_back(static_cast<double>(k) / first_samples);
  std::vector<Sample> samples = displaced(ts);
  for (int round = 0;; ++round) {
    const auto usable = [](const Sample& s) { return is_finite(s.gap) && length(s.gap) > 0; };
    if (!std::all_of(samples.begin(), samples.end(), usable)) return std::nullopt;
    ts.clear();
    for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
      if (std::fabs(turn(samples[k].gap, samples[k + 1].gap)) > most) {
        ts.push_back(0.5 * (samples[k].t + samples[k + 1].t));
      }
    }
    if (ts.empty()) break;
    left -= static_cast<double>(ts.size());
    if (left < 4 * first_samples) return std::nullopt;
    if (round == rounds) return std::nullopt;  // a point lies on the edge, or the map is not continuous there
    const std::vector<Sample> more = displaced(ts);
    samples.insert(samples.end(), more.begin(), more.end());
    std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.t < b.t; });
  }
  double sum = 0;
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) sum += turn(samples[k].gap, samples[k + 1].gap);
  return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
}

bool same_points(const std::vector<FixedPoint>& a, const std::vector<FixedPoint>& b, double extent) {
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const FixedPoint& point) {
           return std::any_of(b.begin(), b.end(), [&](const FixedPoint& other) {
             return length({other.at.x - point.at.x, other.at.y - point.at.y}) <= 1e-6 * size_at(other.at, extent);
           });
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

}  // namespace

double residue(const FixedPoint& point) {
  return 0.25 * (2 - (point.derivative.xx + point.derivative.yy));
}

int index_of(const FixedPoint& point, int period) {
  if (period < 1 || period % point.period != 0) {
    throw UsageError("the period of an index has to be a multiple of the point's");
  }
  std::complex<double> product = 1;
  for (const std::complex<double>& eigenvalue : point.multipliers) {
    std::complex<double> power = 1;
    for (int k = 0; k < period / point.period; ++k) power *= eigenvalue;
    product *= 1.0 - power;
  }
  return product.real() > 1e-7 ? 1 : product.real() < -1e-7 ? -1 : 0;
}

FixedPointSearch search_fixed_points(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& options,
                                     int max_grid, const Progress& progress) {
  require_scan(box, options);
  if (max_grid < options.grid) throw UsageError("the last grid of a search must not be coarser than the first one");
  FixedPointSearch search;
  const std::unique_ptr<HalfWayMap> half_way = half_way_map(map);
  const SearchAllowance allowance(map, half_way.get(), options);
  const double an_image = work_of_image(map, box, options);
  // Not wanted before all points of a grid have images.
  std::optional<std::optional<int>> edge;
  FixedPointOptions each = options;
  const double maps = half_way ? 2 : 1;
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
    const DisplacementGrid grid(map, box, each);
    std::vector<FixedPoint> found = scan(map, box, each, grid, half_way.get(), &allowance);
    if (first) of_smaller_periods = scan_for_smaller_periods(map, box, each, half_way.get(), &allowance);
    add_points(found, of_smaller_periods, std::min(each.extent, extent_of(box)));
    if (!allowance.has(0)) {  // the seeds may not be through: of two scans the one that found more
      search.out_of_work = true;
      if (!first && found.size() < search.points.size()) return search;
    }
    const bool same = !first && same_points(found, search.points, extent_of(box));
    search.points = std::move(found);
    search.grid = each.grid;
    FixedPointOptions near = each;
    near.extent = std::min(each.extent, extent_of(box));
    if (fill_a_curve(map, search.points, near, grid.cell())) {
      search.isolated = false;
      thin_out(search.points, options.period);
      return search;
    }
    search.index_sum = 0;
    bool degenerate = false;
    for (const FixedPoint& point : search.points) {
      if (!inside(box, point.at)) continue;
      search.index_sum += index_of(point, options.period);
      degenerate = degenerate || index_of(point, options.period) == 0;
    }
    const bool defined = !degenerate && grid.all_have_images();
    if (defined && !edge) edge = index_of_edge(map, box, options, an_image, allowance);
    search.index_of_box = defined ? *edge : std::nullopt;
    search.settled = same && (!search.index_of_box || *search.index_of_box == search.index_sum);
    // Nothing twice says little where the edge does not tell either: so it is with thin resonances.
    if (search.points.empty() && !search.index_of_box) search.settled = false;
    if (search.out_of_work) search.settled = false;
    if (search.settled || search.out_of_work || each.grid == max_grid) return search;
  }
}

}  // namespace lober

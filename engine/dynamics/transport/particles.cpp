#include "engine/dynamics/transport/particles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/box.hpp"
#include "kernels/splitmix.hpp"
#include "lober/error.hpp"
#include "lober/interior.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t particles_a_block = 1024;

class ParticleCounter {
 public:
  ParticleCounter(const PlanarMap& map, const Cylinder* cylinder, std::span<const Barrier> barriers,
                  const Partition& partition, const ParticleOptions& options)
      : map_(map), cylinder_(cylinder), partition_(partition), options_(options) {
    for (const Barrier& barrier : barriers) outlines_.push_back(outline_of(barrier, 0));
    for (const std::vector<Point>& outline : outlines_) curves_.emplace_back(CurveView{outline});
  }

  std::vector<RegionMatrix> count(int iterates) {
    const std::size_t regions = partition_.size();
    std::vector<RegionMatrix> result(static_cast<std::size_t>(iterates), RegionMatrix(regions));
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (RegionMatrix& matrix : result) {
      for (std::size_t i = 0; i < regions; ++i) {
        for (std::size_t j = 0; j < regions; ++j) matrix(i, j) = {unknown, 0};
      }
    }
    runs_ = 0;
    for (const Region& region : partition_.regions()) all_runs_ += 2 * iterates * static_cast<int>(region.bounded);
    for (std::size_t i = 0; i < regions; ++i) {
      if (!partition_.regions()[i].bounded) continue;
      const std::vector<Point> start = scatter(i);
      for (const int direction : {1, -1}) {
        std::vector<Point> points = start;
        for (int n = 1; n <= iterates; ++n) {
          const std::vector<std::uint64_t> counts = step_and_count(points, direction);
          RegionMatrix& matrix = result[static_cast<std::size_t>(n - 1)];
          for (std::size_t j = 0; j < regions; ++j) {
            const Measured share = share_of(partition_.regions()[i].area, counts[j]);
            if (direction > 0) {
              matrix(i, j) = share;
            } else if (!partition_.regions()[j].bounded) {
              matrix(j, i) = share;
            }
          }
        }
      }
    }
    return result;
  }

 private:
  [[nodiscard]] Measured share_of(Measured area, std::uint64_t count) const {
    const auto all = static_cast<double>(options_.count), found = static_cast<double>(count);
    // Never certain, however few or many were found.
    const double likely = (found + 1) / (all + 2);
    return {area.value * found / all, area.error + area.value * std::sqrt(likely * (1 - likely) / all)};
  }

  // The region of each point of the (wrapped) plane.
  [[nodiscard]] std::vector<std::size_t> locate(std::span<const Point> points) const {
    std::vector<std::vector<Winding>> found;
    for (const IndexedCurve& curve : curves_) found.push_back(windings(curve, points));
    std::vector<std::size_t> regions(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      for (std::size_t i = 0; i < partition_.size(); ++i) {
        const std::vector<int>& coefficients = partition_.regions()[i].coefficients;
        int value = coefficients[0];
        for (std::size_t c = 0; c < curves_.size(); ++c) value += coefficients[c + 1] * (found[c][k].number != 0);
        if (value == 1) regions[k] = i;
      }
    }
    return regions;
  }

  // Evenly in a region: candidates in its box until one lies in it.
  [[nodiscard]] std::vector<Point> scatter(std::size_t region) const {
    Box box;
    const std::vector<int>& coefficients = partition_.regions()[region].coefficients;
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      if (coefficients[c + 1] == 1) box = box_of(outlines_[c]);
    }
    std::vector<Point> points(options_.count);
    for_each_block(points.size(), particles_a_block, [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> open(end - begin);
      for (std::size_t k = begin; k < end; ++k) open[k - begin] = k;
      for (std::uint64_t attempt = 0; !open.empty(); ++attempt) {
        std::vector<Point> tries;
        for (const std::size_t k : open) {
          const std::uint64_t hash = mixed(mixed(mixed(options_.seed) + region) + k) + 2 * attempt;
          tries.push_back(
              {box.min_x() + box.width() * unit(mixed(hash)), box.min_y() + box.height() * unit(mixed(hash + 1))});
        }
        const std::vector<std::size_t> found = locate(tries);
        std::vector<std::size_t> left;
        for (std::size_t j = 0; j < open.size(); ++j) {
          if (found[j] != region) {
            left.push_back(open[j]);
          } else {
            points[open[j]] = cylinder_ != nullptr ? cylinder_->unwrap(tries[j]) : tries[j];
          }
        }
        open = std::move(left);
      }
    });
    return points;
  }

  std::vector<std::uint64_t> step_and_count(std::vector<Point>& points, int direction) {
    const std::size_t blocks = (points.size() + particles_a_block - 1) / particles_a_block;
    std::vector<std::vector<std::uint64_t>> counts(blocks, std::vector<std::uint64_t>(partition_.size()));
    for_each_block(points.size(), particles_a_block, [&](std::size_t begin, std::size_t end) {
      const std::span<Point> some = std::span(points).subspan(begin, end - begin);
      map_.iterate(some, direction);
      std::vector<Point> positions;
      std::vector<std::uint64_t>& here = counts[begin / particles_a_block];
      for (const Point at : some) {
        if (!std::isfinite(at.x) || !std::isfinite(at.y)) {
          ++here[outside()];
        } else {
          positions.push_back(cylinder_ != nullptr ? cylinder_->wrap(at) : at);
          // Below what the cylinder was cut at.
          if (!std::isfinite(positions.back().x)) positions.back() = {0, 0};
        }
      }
      for (const std::size_t region : locate(positions)) ++here[region];
    });
    std::vector<std::uint64_t> sums(partition_.size());
    for (const auto& here : counts) {
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += here[i];
    }
    if (options_.progress && !options_.progress(static_cast<double>(++runs_) / all_runs_)) throw Cancelled();
    return sums;
  }
  [[nodiscard]] std::size_t outside() const {
    const std::vector<Region>& regions = partition_.regions();
    return static_cast<std::size_t>(
        std::find_if(regions.begin(), regions.end(), [](const Region& r) { return r.coefficients[0] == 1; }) -
        regions.begin());
  }

  const PlanarMap& map_;
  const Cylinder* cylinder_;
  const Partition& partition_;
  const ParticleOptions& options_;
  std::vector<std::vector<Point>> outlines_;
  std::vector<IndexedCurve> curves_;
  int runs_ = 0, all_runs_ = 0;
};

}  // namespace

std::vector<RegionMatrix> count_particles(const PlanarMap& map, const Cylinder* cylinder,
                                          std::span<const Barrier> barriers, const Partition& partition, int iterates,
                                          const ParticleOptions& options) {
  return ParticleCounter(map, cylinder, barriers, partition, options).count(iterates);
}

}  // namespace lober::detail

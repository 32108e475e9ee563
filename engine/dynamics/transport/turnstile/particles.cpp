#include "engine/dynamics/transport/turnstile/particles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/transport/turnstile/cylinder.hpp"
#include "kernels/box.hpp"
#include "kernels/splitmix.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t particles_a_block = 1024;

class ParticleCounter {
 public:
  ParticleCounter(const PlanarMap& map, std::span<const Barrier> barriers, const Partition& partition,
                  const ParticleOptions& options)
      : map_(map), partition_(partition), options_(options), lattice_(barriers.front().lattice) {
    for (const Barrier& barrier : barriers) insides_.emplace_back(barrier);
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

  // The region of each point.
  [[nodiscard]] std::vector<std::size_t> locate(std::span<const Point> points) const {
    std::vector<std::vector<bool>> found;
    for (const InsideOfBarrier& inside : insides_) found.push_back(inside.of(points));
    std::vector<std::size_t> regions(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      for (std::size_t i = 0; i < partition_.size(); ++i) {
        const std::vector<int>& coefficients = partition_.regions()[i].coefficients;
        int value = coefficients[0];
        for (std::size_t c = 0; c < insides_.size(); ++c) value += coefficients[c + 1] * static_cast<int>(found[c][k]);
        if (value == 1) regions[k] = i;
      }
    }
    return regions;
  }

  // Where a region is, each point once: the box of its outer boundary; on a cylinder one period, in the coordinates
  // along_and_above, down to the lowest of all boundaries.
  [[nodiscard]] Box box_of_region(std::size_t region) const {
    Box box, all;
    const std::vector<int>& coefficients = partition_.regions()[region].coefficients;
    for (std::size_t c = 0; c < insides_.size(); ++c) {
      all = union_of(all, insides_[c].box());
      if (coefficients[c + 1] == 1) box = insides_[c].box();
    }
    if (lattice_ == Point{}) return box;
    return Box::of({0, all.min_y()}, {length(lattice_), box.max_y()});
  }
  [[nodiscard]] Point in_plane(Point at) const {
    if (lattice_ == Point{}) return at;
    const double period = length(lattice_);
    return {(lattice_.x * at.x - lattice_.y * at.y) / period, (lattice_.y * at.x + lattice_.x * at.y) / period};
  }

  // Evenly in a region: candidates in its box until one lies in it.
  [[nodiscard]] std::vector<Point> scatter(std::size_t region) const {
    const Box box = box_of_region(region);
    std::vector<Point> points(options_.count);
    for_each_block(points.size(), particles_a_block, [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> open(end - begin);
      for (std::size_t k = begin; k < end; ++k) open[k - begin] = k;
      for (std::uint64_t attempt = 0; !open.empty(); ++attempt) {
        std::vector<Point> tries;
        for (const std::size_t k : open) {
          const std::uint64_t hash = mixed(mixed(mixed(options_.seed) + region) + k) + 2 * attempt;
          tries.push_back(in_plane(
              {box.min_x() + box.width() * unit(mixed(hash)), box.min_y() + box.height() * unit(mixed(hash + 1))}));
        }
        const std::vector<std::size_t> found = locate(tries);
        std::vector<std::size_t> left;
        for (std::size_t j = 0; j < open.size(); ++j) {
          if (found[j] != region) {
            left.push_back(open[j]);
          } else {
            points[open[j]] = tries[j];
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
          positions.push_back(at);
        }
      }
      for (const std::size_t region : locate(positions)) ++here[region];
    });
    std::vector<std::uint64_t> sums(partition_.size());
    for (const auto& here : counts) {
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += here[i];
    }
    if (!options_.progress(static_cast<double>(++runs_) / all_runs_)) throw Cancelled();
    return sums;
  }
  [[nodiscard]] std::size_t outside() const {
    const std::vector<Region>& regions = partition_.regions();
    return static_cast<std::size_t>(
        std::find_if(regions.begin(), regions.end(), [](const Region& r) { return r.coefficients[0] == 1; }) -
        regions.begin());
  }

  const PlanarMap& map_;
  const Partition& partition_;
  const ParticleOptions& options_;
  Point lattice_;
  std::vector<InsideOfBarrier> insides_;
  int runs_ = 0, all_runs_ = 0;
};

}  // namespace

std::vector<RegionMatrix> count_particles(const PlanarMap& map, std::span<const Barrier> barriers,
                                          const Partition& partition, int iterates, const ParticleOptions& options) {
  return ParticleCounter(map, barriers, partition, options).count(iterates);
}

}  // namespace lober::detail

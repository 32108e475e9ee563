#include "viewer/runs.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace lober::viewer {
namespace {

bool same_bits(Point a, Point b) {
  return std::bit_cast<std::uint64_t>(a.x) == std::bit_cast<std::uint64_t>(b.x) &&
         std::bit_cast<std::uint64_t>(a.y) == std::bit_cast<std::uint64_t>(b.y);
}

std::uint64_t hash_of(Point point) {
  std::uint64_t hash = std::bit_cast<std::uint64_t>(point.x) * 0x9e3779b97f4a7c15u;
  hash = (hash ^ (hash >> 29) ^ std::bit_cast<std::uint64_t>(point.y)) * 0xbf58476d1ce4e5b9u;
  return hash ^ (hash >> 32);
}

constexpr int max_equal_points = 64;  // that are looked at: curves that stand still would cost squares

}  // namespace

RunFinder::RunFinder(std::vector<std::span<const Point>> curves) : curves_(std::move(curves)) {
  std::size_t total = 0;
  for (const auto& curve : curves_) {
    begins_.push_back(static_cast<std::uint32_t>(total));
    total += curve.size();
  }
  slots_.resize(std::bit_ceil(2 * total + 1));
  mask_ = slots_.size() - 1;
  for (std::uint32_t number = 0; number < total; ++number) {
    const Location at = location(number);
    std::uint64_t slot = hash_of(curves_[at.curve][at.point]) & mask_;
    int tries = 0;
    while (slots_[slot] != 0 && tries++ < max_equal_points) slot = (slot + 1) & mask_;
    if (slots_[slot] == 0) slots_[slot] = number + 1;
  }
}

RunFinder::Location RunFinder::location(std::uint32_t number) const {
  const auto next = std::upper_bound(begins_.begin(), begins_.end(), number);
  const auto curve = static_cast<std::uint32_t>(next - begins_.begin() - 1);
  return {curve, number - begins_[curve]};
}

template <typename Accepts>
bool RunFinder::find(Point point, const Accepts& accepts, Location& found) const {
  std::uint64_t slot = hash_of(point) & mask_;
  bool any = false;
  for (int tries = 0; slots_[slot] != 0 && tries <= max_equal_points; ++tries, slot = (slot + 1) & mask_) {
    const Location at = location(slots_[slot] - 1);
    if (!same_bits(curves_[at.curve][at.point], point)) continue;
    if (accepts(at)) {
      found = at;
      return true;
    }
    if (!any) found = at;
    any = true;
  }
  return any;
}

std::vector<Run> RunFinder::runs(std::span<const Point> polygon, std::vector<Point>& pool) const {
  std::vector<Run> all;
  const auto pool_number = static_cast<std::uint32_t>(curves_.size());
  int direction = 0;  // of the last run; 0: not known yet
  const auto neighbour = [&](const Location& at, int step, Point point) {
    const auto& curve = curves_[at.curve];
    const std::int64_t next = std::int64_t{at.point} + step;
    return next >= 0 && next < static_cast<std::int64_t>(curve.size()) &&
           same_bits(curve[static_cast<std::size_t>(next)], point);
  };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point point = polygon[k];
    if (!all.empty() && all.back().curve != pool_number) {
      Run& last = all.back();
      bool goes_on = false;
      for (const int step : {1, -1}) {
        if (direction != -step && neighbour({last.curve, last.last}, step, point)) {
          last.last = static_cast<std::uint32_t>(std::int64_t{last.last} + step);
          direction = step;
          goes_on = true;
          break;
        }
      }
      if (goes_on) continue;
    }
    Location at{};
    const auto accepts = [&](const Location& one) {
      return k + 1 < polygon.size() && (neighbour(one, 1, polygon[k + 1]) || neighbour(one, -1, polygon[k + 1]));
    };
    if (find(point, accepts, at)) {
      all.push_back({at.curve, at.point, at.point});
      direction = 0;
      continue;
    }
    if (all.empty() || all.back().curve != pool_number) {
      const auto number = static_cast<std::uint32_t>(pool.size());
      all.push_back({pool_number, number, number});
    } else {
      ++all.back().last;
    }
    pool.push_back(point);
  }
  return all;
}

}  // namespace lober::viewer

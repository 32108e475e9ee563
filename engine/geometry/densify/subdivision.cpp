#include "engine/geometry/densify/subdivision.hpp"

#include <algorithm>
#include <array>

#include "engine/base/parallel/running_sums.hpp"

namespace lober::detail {

Buffer<Point> subdivided(const Interpolant& interpolant, const Buffer<std::uint32_t>& parts,
                         Buffer<std::uint64_t>& begin) {
  const std::span<const Point> points = interpolant.curve().points;
  // The last vertex of an open curve begins no segment.
  begin = running_sums(points.size(), [&](std::size_t k) { return k < parts.size() ? parts[k] : 1; });
  Buffer<Point> result(begin.back());
  for_each_block(result.size(), pass_grain, [&](std::size_t first, std::size_t last) {
    // Pieces are made a batch ahead: what has just been stored by halves cannot be loaded as vectors without a wait.
    constexpr std::size_t batch = 64;
    std::array<CubicPiece, batch> pieces;
    std::size_t k = static_cast<std::size_t>(std::upper_bound(begin.begin(), begin.end(), first) - begin.begin()) - 1;
    std::size_t batch_begin = k, ready = k;
    for (std::size_t at = first; at < last; ++k) {
      if (k == ready) {
        for (; ready < std::min(k + batch, parts.size()) && begin[ready] < last; ++ready) {
          pieces[ready - k] = interpolant.piece(ready);
        }
        batch_begin = k;
      }
      if (at == begin[k]) result[at++] = points[k];
      const std::size_t end = std::min<std::size_t>(begin[k + 1], last);
      if (at >= end) continue;
      const auto from = static_cast<std::uint32_t>(at - begin[k]), to = static_cast<std::uint32_t>(end - begin[k]);
      subdivide(pieces[k - batch_begin], parts[k], from, to, &result[at]);
      at = end;
    }
  });
  return result;
}

}  // namespace lober::detail

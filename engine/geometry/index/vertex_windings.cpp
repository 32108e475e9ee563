#include "engine/geometry/index/vertex_windings.hpp"

#include <algorithm>
#include <atomic>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/index/index.hpp"
#include "kernels/predicates.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t rays_a_task = 256;
// With fewer vertices for each leaf, they are located one by one: a ray takes a microsecond, ten of them past many
// folds, as long as a search takes for some leaves.
constexpr double worth_a_search = 1.0 / 16;

// All points of C1 are moved by (e^2, e), e less than any number: then no vertex of one curve lies on the other one,
// and no three of both lie on a line. The sign of (b - a) x (e^2, e), the side of a -> b to which that moves:
int side_of_move(Point a, Point b) {
  if (a.x != b.x) return a.x < b.x ? 1 : -1;
  return a.y < b.y ? -1 : a.y > b.y ? 1 : 0;
}

// Findings at the segments and vertices of a curve. Blocks of a search share them: integers are added in any
// order.
class AlongCurve {
 public:
  explicit AlongCurve(const CurveView& curve)
      : points_(curve.points), gained_(points_.size(), 0), on_(points_.size(), std::uint8_t{0}) {}

  void gain(std::uint32_t segment, int by) {
    std::atomic_ref(gained_[segment]).fetch_add(by, std::memory_order_relaxed);
  }
  void set_on(std::uint32_t vertex) {
    std::atomic_ref(on_[vertex == on_.size() ? 0 : vertex]).store(1, std::memory_order_relaxed);
  }

  // The numbers of `vertices`, when the search is done.
  [[nodiscard]] Buffer<RayCrossings> at(std::span<const std::uint32_t> vertices, const BoxTree& other) const {
    Buffer<RayCrossings> found(vertices.size());
    std::int32_t number = 0;
    std::uint32_t vertex = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      while (vertex < vertices[k]) number += gained_[vertex++];
      found[k] = {number, is_on(vertex)};
    }
    const auto beside = std::find_if(found.begin(), found.end(), [](const RayCrossings& there) { return !there.on; });
    if (beside == found.end()) return found;
    const Point point = points_[vertices[static_cast<std::size_t>(beside - found.begin())]];
    const std::int32_t missing = ray_crossings(other, point).number - beside->number;
    for (RayCrossings& there : found) there.number += missing;
    return found;
  }

 private:
  // A search may leave out segments of no length, so that of several vertices at one point it sees the outer ones.
  [[nodiscard]] bool is_on(std::uint32_t vertex) const {
    const auto size = static_cast<std::uint32_t>(points_.size());
    const auto seen = [&](std::uint32_t step) {
      for (std::uint32_t k = vertex, passed = 0; passed < size; k = (k + step) % size, ++passed) {
        if (!(points_[k] == points_[vertex])) return false;
        if (on_[k] != 0) return true;
      }
      return false;
    };
    return seen(1) || seen(size - 1);
  }

  std::span<const Point> points_;
  Buffer<std::int32_t> gained_;  // by segment
  Buffer<std::uint8_t> on_;      // by vertex
};

class GainFinder final : public PairConsumer {
 public:
  GainFinder(const CurveView& c1, const CurveView& c2, std::array<AlongCurve, 2>& along)
      : c1_(c1), c2_(c2), along_(along) {}

  std::uint32_t consume(std::uint32_t /*block*/, std::span<const SegmentPair> pairs) override {
    PredicateCounts counts;
    for (const auto& [i, j] : pairs) compare(i, j, counts);
    return 0;
  }
  void finish(std::uint32_t /*block*/) override {}

 private:
  void compare(std::uint32_t i, std::uint32_t j, PredicateCounts& counts) {
    const auto [p, q] = c1_.segment(i);
    const auto [a, b] = c2_.segment(j);
    const int at_a = orient2d(p, q, a, counts), at_b = orient2d(p, q, b, counts);
    if (at_a * at_b > 0) return;
    const int at_p = orient2d(a, b, p, counts), at_q = orient2d(a, b, q, counts);
    if (at_p * at_q > 0) return;
    if (at_p == 0 && on_segment(a, b, p, counts)) along_[0].set_on(i);
    if (at_q == 0 && on_segment(a, b, q, counts)) along_[0].set_on(i + 1);
    if (at_a == 0 && on_segment(p, q, a, counts)) along_[1].set_on(j);
    if (at_b == 0 && on_segment(p, q, b, counts)) along_[1].set_on(j + 1);
    if (p == q || a == b) return;
    const int move = side_of_move(a, b), opposite_move = -side_of_move(p, q);
    const int moved_p = at_p != 0 ? at_p : move, moved_q = at_q != 0 ? at_q : move;
    const int moved_a = at_a != 0 ? at_a : opposite_move, moved_b = at_b != 0 ? at_b : opposite_move;
    if (moved_p == moved_q || moved_a == moved_b) return;
    along_[0].gain(i, moved_q);  // a curve winds once more to its left
    along_[1].gain(j, moved_b);
  }

  CurveView c1_, c2_;
  std::array<AlongCurve, 2>& along_;
};

Buffer<RayCrossings> one_by_one(const IndexedCurve& own, const BoxTree& other,
                                std::span<const std::uint32_t> vertices) {
  Buffer<RayCrossings> found(vertices.size());
  for_each_block(vertices.size(), rays_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) found[k] = ray_crossings(other, own.view().points[vertices[k]]);
  });
  return found;
}

}  // namespace

std::array<Buffer<RayCrossings>, 2> vertex_windings(const IndexedCurve& c1, const IndexedCurve& c2,
                                                    std::array<std::span<const std::uint32_t>, 2> vertices) {
  const std::size_t leaves = c1.tree().leaves() + c2.tree().leaves();
  if (static_cast<double>(vertices[0].size() + vertices[1].size()) < worth_a_search * static_cast<double>(leaves)) {
    return {one_by_one(c1, c2.tree(), vertices[0]), one_by_one(c2, c1.tree(), vertices[1])};
  }
  std::array<AlongCurve, 2> along{AlongCurve(c1.view()), AlongCurve(c2.view())};
  GainFinder finder(c1.view(), c2.view(), along);
  (void)find_pairs(c1, c2, IndexKind::tree, finder);
  return {along[0].at(vertices[0], c2.tree()), along[1].at(vertices[1], c1.tree())};
}

}  // namespace lober::detail

#include "engine/geometry/interior/arc_labels.hpp"

#include <cstdint>
#include <span>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/index/vertex_windings.hpp"
#include "kernels/predicates.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t arcs_a_block = 1024;
constexpr std::uint32_t no_vertex = 0xffffffff;

// Whether q lies ahead of `at` in the direction of p, all three on one line.
bool same_way(Point at, Point p, Point q) {
  return (p.x > at.x) == (q.x > at.x) && (p.x < at.x) == (q.x < at.x) && (p.y > at.y) == (q.y > at.y) &&
         (p.y < at.y) == (q.y < at.y);
}

// On which side of the way back -> at -> onwards the direction from `at` to q leads: +1 left, -1 right, 0 along it.
int side_of_bend(Point back, Point at, Point onwards, Point q) {
  PredicateCounts counts;
  const int of_first = orient2d(back, at, q, counts), of_second = orient2d(at, onwards, q, counts);
  if (of_second == 0 && same_way(at, onwards, q)) return 0;
  if (of_first == 0 && same_way(at, back, q)) return 0;
  const int bend = orient2d(back, at, onwards, counts);
  const bool left = bend > 0 ? of_first > 0 && of_second > 0 : bend < 0 ? of_first > 0 || of_second > 0 : of_second > 0;
  return left ? 1 : -1;
}

class ArcLabeller {
 public:
  ArcLabeller(const CurveView& own, const IndexedCurve& other, bool other_clockwise, const ContactsAlong& contacts)
      : own_(own), other_(other), other_clockwise_(other_clockwise), contacts_(contacts) {}

  // The first vertex strictly between contact k and the next one, by its number; `no_vertex` if there is none.
  [[nodiscard]] std::uint32_t vertex_after(std::size_t k) const {
    const SeenContact from = contacts_[k];
    const bool last = k + 1 == contacts_.size();
    const SeenContact to = contacts_[last ? 0 : k + 1];
    if (!last && from.own_segment == to.own_segment) return no_vertex;
    const auto size = static_cast<std::uint32_t>(own_.points.size());
    const std::uint32_t vertex = from.own_segment + 1 == size ? 0 : from.own_segment + 1;
    // Repeated vertices carry no segment, and the contact is at the last of them.
    if (to.at_own_vertex && own_.points[to.own_segment] == own_.points[vertex]) return no_vertex;
    return vertex;
  }

  // The side of a part without a vertex, which is straight.
  [[nodiscard]] Side label_straight(std::size_t k) const {
    const SeenContact from = contacts_[k];
    if (from.proper) return to_left(!from.other_goes_left);
    const CurveView& other = other_.view();
    const auto [begin, onwards] = other.segment(from.other_segment);
    const Point at = from.at_own_vertex ? own_.points[from.own_segment] : begin;
    const Point back = from.at_other_vertex ? vertex_before(other, from.other_segment) : begin;
    const int side = side_of_bend(back, at, onwards, own_.segment(from.own_segment).b);
    return side == 0 ? Side::on : to_left(side > 0);
  }

 private:
  [[nodiscard]] Side to_left(bool left) const { return left != other_clockwise_ ? Side::inside : Side::outside; }

  // The last vertex before `vertex` at another point.
  static Point vertex_before(const CurveView& curve, std::size_t vertex) {
    std::size_t before = vertex;
    do {
      before = before == 0 ? curve.points.size() - 1 : before - 1;
    } while (curve.points[before] == curve.points[vertex] && before != vertex);
    return curve.points[before];
  }

  const CurveView& own_;
  const IndexedCurve& other_;
  bool other_clockwise_;
  const ContactsAlong& contacts_;
};

// The vertices that label the parts after all contacts, `no_vertex` where there is none, and those that there are, in
// ascending order but for the last one: the way from the last contact to the first one may begin with the first vertex.
struct LabellingVertices {
  Buffer<std::uint32_t> after, all;
  bool wraps = false;

  [[nodiscard]] std::span<const std::uint32_t> in_order() const {
    return std::span(all).first(all.size() - static_cast<std::size_t>(wraps));
  }
};

LabellingVertices labelling_vertices(const ArcLabeller& labeller, std::size_t count) {
  LabellingVertices vertices;
  vertices.after.resize(count);
  for_each_block(count, arcs_a_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) vertices.after[k] = labeller.vertex_after(k);
  });
  vertices.all.resize(count);
  std::size_t queries = 0;
  for (std::size_t k = 0; k < count; ++k) {
    vertices.all[queries] = vertices.after[k];
    queries += static_cast<std::size_t>(vertices.after[k] != no_vertex);
  }
  vertices.all.resize(queries);
  vertices.wraps = queries > 1 && vertices.all[queries - 1] < vertices.all[queries - 2];
  return vertices;
}

ArcLabels labels_by(const ArcLabeller& labeller, const LabellingVertices& vertices,
                    const Buffer<RayCrossings>& windings, const IndexedCurve& own, const IndexedCurve& other) {
  const auto side_by = [](const RayCrossings& there) {
    return there.on ? Side::on : there.number != 0 ? Side::inside : Side::outside;
  };
  const std::size_t count = vertices.after.size();
  ArcLabels result;
  result.queries = vertices.all.size();
  result.after.resize(count);
  std::size_t next = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t vertex = vertices.after[k];
    if (vertex == no_vertex) continue;
    result.after[k] = next < windings.size() ? side_by(windings[next]) : locate(other, own.view().points[vertex]);
    ++next;
  }
  for_each_block(count, arcs_a_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (vertices.after[k] == no_vertex) result.after[k] = labeller.label_straight(k);
    }
  });
  return result;
}

}  // namespace

std::array<ArcLabels, 2> label_arcs(const IndexedCurve& c1, const IndexedCurve& c2, std::array<bool, 2> clockwise,
                                    const std::array<ContactsAlong, 2>& contacts) {
  const ArcLabeller labeller1(c1.view(), c2, clockwise[1], contacts[0]);
  const ArcLabeller labeller2(c2.view(), c1, clockwise[0], contacts[1]);
  const LabellingVertices vertices1 = labelling_vertices(labeller1, contacts[0].size());
  const LabellingVertices vertices2 = labelling_vertices(labeller2, contacts[1].size());
  const auto windings = vertex_windings(c1, c2, {vertices1.in_order(), vertices2.in_order()});
  return {labels_by(labeller1, vertices1, windings[0], c1, c2), labels_by(labeller2, vertices2, windings[1], c2, c1)};
}

}  // namespace lober::detail

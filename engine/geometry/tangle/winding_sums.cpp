#include "engine/geometry/tangle/winding_sums.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/tangle/boundary.hpp"
#include "engine/geometry/tangle/gaps.hpp"
#include "engine/geometry/tangle/lobe_topology.hpp"
#include "kernels/predicates.hpp"
#include "kernels/shoelace.hpp"
#include "lober/overlay/interior.hpp"

namespace lober::detail {
namespace {

bool before(const PrecisePosition& x, const PrecisePosition& y) {
  if (x.segment != y.segment) return x.segment < y.segment;
  return x.t.hi != y.t.hi ? x.t.hi < y.t.hi : x.t.lo < y.t.lo;
}

// The smooth curves may cross up to two segments from where the polygons do (smooth_crossing.cpp): a crossing this many
// segments behind another one may come before it.
constexpr std::uint32_t may_pass = 4;

bool crosses(const NodeGraph& graph, std::uint32_t node) {
  return graph.order[node] < first_touch;
}

}  // namespace

WindingSums::WindingSums(const Tangle& tangle, const ClosingPath& path)
    : tangle_(tangle), curves_(*tangle.curves), path_(path) {
  add_manifold_nodes();
  add_path_nodes();
  sort_nodes();
  usable_ = usable_ && find_boundary();
  positions_.clear();
}

void WindingSums::add_nodes(const IndexedCurve& first, const IndexedCurve& second, const NodeGraph& graph, Curve a,
                            Curve b, const std::vector<std::uint32_t>& numbers, const SmoothGaps& smooth) {
  const Buffer<DD> gaps = polygon_gaps_at(first, second, curves_.origin(), graph, numbers);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const Contact contact = graph.contacts[graph.span(numbers[k]).first];
    const SmoothGap& gap = smooth.at[k];
    positions_.push_back({PrecisePosition{contact.segment1, contact.t1}, {contact.segment2, contact.t2}});
    nodes_.push_back({{a, b},
                      graph.order[numbers[k]] == rightward_to_left ? 1 : -1,
                      {},
                      {gap.position1, gap.position2},
                      {gap.error1, gap.error2},
                      gap.at,
                      gaps[k].hi,
                      gap.twice.hi + gap.twice.lo,
                      gap.uncertainty});
  }
}

// Crossings of U and S up to the last pip, beyond which no lobe has an arc.
void WindingSums::add_manifold_nodes() {
  const NodeGraph& graph = graph_of(tangle_.nodes);
  const std::uint32_t last_u = tangle_.pips.back().u.segment, last_s = tangle_.pips.front().s.segment;
  std::vector<std::uint32_t> numbers;
  pip_nodes_.reserve(tangle_.pips.size());
  for (std::uint32_t node = 0; node < graph.size(); ++node) {
    const Contact contact = graph.contacts[graph.span(node).first];
    if (contact.segment1 > last_u + may_pass) break;
    if (!crosses(graph, node) || contact.segment2 > last_s + may_pass) continue;
    if (pip_nodes_.size() < tangle_.pips.size() && tangle_.pips[pip_nodes_.size()].node == node)
      pip_nodes_.push_back(static_cast<std::uint32_t>(numbers.size()));
    numbers.push_back(node);
  }
  add_nodes(curves_.u(), curves_.s(), graph, on_u, on_s, numbers, curves_.smooth_gaps_at(graph, numbers));
}

void WindingSums::add_path_nodes() {
  const Point origin = curves_.origin();
  const std::vector<Point>& points = path_.points();
  for (std::size_t k = 1; k < points.size(); ++k) path_end_ += shoelace(points[k - 1], points[k], origin);
  usable_ = !path_.meets_itself();
  if (!usable_ || !path_.has_length()) return;
  const SmoothCurve straight(path_.index().view(), true);
  const ChordAreaTable no_chords(straight);
  const Pip &last_u = tangle_.pips.back(), &last_s = tangle_.pips.front();
  const auto add = [&](const IndexedCurve& curve, const NodeGraph& graph, const ChordAreaTable& chords, Curve which,
                       Position last) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
      const NodeSpan span = graph.span(node);
      const Contact contact = graph.contacts[span.first];
      if (contact.segment1 > last.segment + may_pass) break;
      if (span.direction == 0 && ClosingPath::at_start(curve, contact)) continue;
      const bool usable = span.direction == 0 && crosses(graph, node);
      const bool behind =
          contact.segment1 > last.segment || (contact.segment1 == last.segment && contact.t1.hi > last.t);
      if (behind && !usable) continue;
      usable_ = usable_ && usable;
      numbers.push_back(node);
    }
    if (!usable_) return;
    add_nodes(curve, path_.index(), graph, which, on_path, numbers,
              smooth_gaps(SmoothCurve(curve.view()), straight, chords, no_chords, graph, numbers));
  };
  add(curves_.u(), path_.on_u(), *curves_.chords_u, on_u, last_u.u);
  if (usable_) add(curves_.s(), path_.on_s(), *curves_.chords_s, on_s, last_s.s);
}

void WindingSums::sort_nodes() {
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
    for (const Curve curve : nodes_[node].curve) along_[curve].push_back(node);
  }
  for (const Curve curve : {on_u, on_s, on_path}) {
    const auto position = [&](std::uint32_t node) { return positions_[node][nodes_[node].side(curve)]; };
    std::stable_sort(along_[curve].begin(), along_[curve].end(),
                     [&](std::uint32_t x, std::uint32_t y) { return before(position(x), position(y)); });
    for (std::uint32_t k = 0; k < along_[curve].size(); ++k) {
      Node& node = nodes_[along_[curve][k]];
      node.rank[node.side(curve)] = k;
    }
  }
}

// The winding number of the boundary on the left of U where it begins.
std::optional<int> WindingSums::left_of_first_arc() const {
  const std::vector<Point> outline = boundary_outline(tangle_);
  const Point begin = outline.front();
  const auto next = std::find_if(outline.begin(), outline.end(), [&](Point p) { return !(p == begin); });
  if (next == outline.end()) return std::nullopt;
  double t = 0.5;  // before the first crossing, if it lies on this segment
  if (!along_[on_u].empty()) {
    const PrecisePosition first = positions_[along_[on_u][0]][nodes_[along_[on_u][0]].side(on_u)];
    const std::span<const Point> points = tangle_.u().points.first(first.segment + 1);
    if (std::all_of(points.begin(), points.end(), [&](Point p) { return p == begin; })) t = first.t.hi / 2;
  }
  const Point point{begin.x + t * (next->x - begin.x), begin.y + t * (next->y - begin.y)};
  const IndexedCurve index(ClosedCurve::borrow(outline));
  const Winding found = winding(index, point);
  PredicateCounts counts;
  const int side = orient2d(begin, *next, point, counts);
  if (!found.on) return side == 0 ? std::nullopt : std::optional(side > 0 ? found.number : found.number + 1);
  // The principal value is the mean of both sides.
  const double turns = interior_function(index, point).j / (2 * std::numbers::pi);
  return static_cast<int>(std::lround(turns + 0.5));
}

WindingSums::Runs WindingSums::no_runs() const {
  Runs runs;
  for (const Curve curve : {on_u, on_s, on_path}) runs[curve].resize(along_[curve].size() + 1);
  return runs;
}

// The winding numbers beside the arcs of a curve, from those beside its first arc.
void WindingSums::carry(const Runs& runs, Curve curve, Sides first, Windings& windings) const {
  std::vector<Sides>& sides = windings[curve];
  sides.assign(1, first);
  for (const std::uint32_t number : along_[curve]) {
    const Node& node = nodes_[number];
    const std::size_t own = node.side(curve);
    const std::vector<int>& other = runs[node.curve[1 - own]];
    const int in = other[node.rank[1 - own]], out = other[node.rank[1 - own] + 1];
    const Sides here = sides.back();
    const bool from_right = (node.sign > 0) == (own == 0);
    sides.push_back(from_right ? Sides{here.left - out, here.right - in} : Sides{here.left + in, here.right + out});
  }
}

// Whether both curves of every crossing see the same winding numbers round it, and where the closure ends as U does.
bool WindingSums::consistent(const Windings& windings) const {
  for (const Node& node : nodes_) {
    const std::vector<Sides>&first = windings[node.curve[0]], &second = windings[node.curve[1]];
    const Sides in = first[node.rank[0]], out = first[node.rank[0] + 1];
    const Sides before_it = second[node.rank[1]], behind_it = second[node.rank[1] + 1];
    const bool up = node.sign > 0;
    const Sides right{up ? in.right : out.right, up ? out.right : in.right};
    const Sides left{up ? in.left : out.left, up ? out.left : in.left};
    if (!((up ? right : left) == before_it) || !((up ? left : right) == behind_it)) return false;
  }
  return windings[on_path].back().left == windings[on_u].front().left;
}

bool WindingSums::find_boundary() {
  const std::optional<int> left = left_of_first_arc();
  if (!left) return false;
  const Node& bip = nodes_[pip_nodes_[tangle_.boundary->bip]];
  Runs runs = no_runs();
  std::fill_n(runs[on_u].begin(), bip.rank[0] + 1, 1);
  std::fill_n(runs[on_s].begin(), bip.rank[1] + 1, -1);
  std::fill(runs[on_path].begin(), runs[on_path].end(), 1);
  carry(runs, on_u, {*left, *left - 1}, boundary_);
  // Where the boundary turns from one curve to another one, its left stays the same.
  carry(runs, on_s, {-1, 0}, boundary_);
  const int shift = boundary_[on_u][bip.rank[0]].left - boundary_[on_s][bip.rank[1]].right;
  for (Sides& sides : boundary_[on_s]) sides = {sides.left + shift, sides.right + shift};
  const int start = boundary_[on_s].front().right;
  carry(runs, on_path, {start, start - 1}, boundary_);
  return consistent(boundary_);
}

std::optional<WindingSums::Windings> WindingSums::windings_of(std::size_t lobe) const {
  const Node &first = nodes_[pip_nodes_[lobe]], &last = nodes_[pip_nodes_[lobe + 1]];
  Runs runs = no_runs();
  std::fill(runs[on_u].begin() + first.rank[0] + 1, runs[on_u].begin() + last.rank[0] + 1, 1);
  std::fill(runs[on_s].begin() + last.rank[1] + 1, runs[on_s].begin() + first.rank[1] + 1, 1);
  const int orientation = tangle_.lobes[lobe].orientation();
  const int at_u = holds_start_of_u(tangle_, lobe) ? orientation : 0;
  const int at_s = holds_start_of_s(tangle_, lobe) ? orientation : 0;
  Windings windings;
  carry(runs, on_u, {at_u, at_u}, windings);
  carry(runs, on_s, {at_s, at_s}, windings);
  carry(runs, on_path, {at_s, at_s}, windings);
  if (!consistent(windings)) return std::nullopt;
  return windings;
}

// A share of twice the area that lies elsewhere because two crossings along a curve have changed places: the triangle
// that it makes with the other two curves lies on the other side of each of them, and the sums count it up to three
// times too often or too rarely. All three sides find it.
double WindingSums::twice_turned_over(const Node& one, const Node& other, Curve curve) const {
  const auto gap = [](const Node& node, Curve first) {
    return (node.side(first) == 0 ? 1 : -1) * (node.polygons + node.smooth);
  };
  const auto turned = [](const Node& x, const Node& y, Curve along) {
    const std::size_t i = x.side(along), j = y.side(along);
    return (x.rank[i] < y.rank[j]) == (x.at[i] > y.at[j]);
  };
  const Curve second = one.curve[1 - one.side(curve)], third = other.curve[1 - other.side(curve)];
  constexpr std::size_t near = 8;  // crossings
  const std::vector<std::uint32_t>& along = along_[second];
  const std::size_t at = one.rank[1 - one.side(curve)], end = std::min(at + near + 1, along.size());
  for (std::size_t k = at > near ? at - near : 0; second != third && k < end; ++k) {
    const Node& node = nodes_[along[k]];
    if (node.curve[1 - node.side(second)] != third) continue;
    if (turned(node, one, second) && turned(node, other, third))
      return std::fabs(gap(one, curve) - gap(other, curve) + gap(node, second));
  }
  // A triangle of sides a, b, c has (a^2 + b^2 + c^2) / (4 sqrt 3) at most.
  const Point apart = other.point - one.point;
  return dot(apart, apart);
}

std::optional<Measured> WindingSums::measure(std::optional<std::size_t> lobe, double polygon_area) const {
  if (!usable_) return std::nullopt;
  std::optional<Windings> of_lobe;
  if (lobe) {
    of_lobe = windings_of(*lobe);
    if (!of_lobe) return std::nullopt;
  }
  // The weight of arc k of a curve.
  const auto weight = [&](Curve curve, std::size_t k) {
    Sides in = boundary_[curve][k];
    in = {in.left != 0 ? 1 : 0, in.right != 0 ? 1 : 0};
    if (of_lobe) {
      const Sides also = (*of_lobe)[curve][k];
      in = {also.left != 0 ? in.left : 0, also.right != 0 ? in.right : 0};
    }
    return in.left - in.right;
  };
  const auto jump = [&](const Node& node) {
    return weight(node.curve[0], node.rank[0]) - weight(node.curve[0], node.rank[0] + std::size_t{1});
  };
  // Whether these closed curves wind beside one of two nodes.
  const auto wind_beside = [&](const Windings& windings, const Node& one, const Node& other) {
    for (const Node* node : {&one, &other}) {
      for (const std::size_t own : {std::size_t{0}, std::size_t{1}}) {
        const Sides* const sides = &windings[node->curve[own]][node->rank[own]];
        if (!(sides[0] == Sides{} && sides[1] == Sides{})) return true;
      }
    }
    return false;
  };
  DD polygons = DD{static_cast<double>(weight(on_path, along_[on_path].size())), 0} * path_end_;
  double smooth = 0, error = 0, sizes = 0;
  for (const Node& node : nodes_) {
    const int times = jump(node);
    sizes += std::fabs(node.polygons);  // corners of outlines are rounded, which leaves specks of what is apart
    if (times == 0) continue;
    polygons += DD{times * node.polygons, 0};
    smooth += times * node.smooth;
    error += std::abs(times) * node.uncertainty;
  }
  for (const Curve curve : {on_u, on_s, on_path}) {
    double sum = 0;
    std::vector<double> farthest;  // the largest `at` up to each node
    for (std::size_t k = 0; k < along_[curve].size(); ++k) {
      const Node& node = nodes_[along_[curve][k]];
      const std::size_t own = node.side(curve);
      error += std::abs(weight(curve, k)) * std::max(node.error[own] - sum, 0.0);
      sum = node.error[own];
      // Smooth curves that cross in another order than the polygons do bound other regions.
      const double at = node.at[own];
      for (std::size_t j = k; j-- > 0 && farthest[j] > at;) {
        const Node& other = nodes_[along_[curve][j]];
        if (!(other.at[other.side(curve)] > at)) continue;
        if (jump(node) != 0 && jump(other) != 0) return std::nullopt;
        if (wind_beside(boundary_, node, other) && (!of_lobe || wind_beside(*of_lobe, node, other)))
          error += twice_turned_over(node, other, curve);
      }
      farthest.push_back(k == 0 ? at : std::max(farthest.back(), at));
    }
  }
  const double area = polygon_area + curves_.area({smooth, 0});
  // The sums for the polygons have to lead to their area too.
  constexpr double of_rounding = 1e-12;
  const double off = std::fabs(curves_.area(polygons) - polygon_area);
  if (off > of_rounding * (curves_.area({sizes, 0}) + polygon_area)) return std::nullopt;
  return Measured{area, curves_.area({error, 0}) + off + tangle_.rounding(area)};
}

}  // namespace lober::detail

#include <algorithm>
#include <stdexcept>

#include "tests/oracle/exact_subdivision.hpp"

namespace lober::oracle {
namespace {

constexpr std::uint32_t none = 0xffffffff;

class Tracer {
 public:
  explicit Tracer(Arrangement& arrangement) : arrangement_(arrangement), edges_(arrangement.edges) {}

  void run() {
    link();
    trace();
    if (edges_.size() == arrangement_.chain[0].size() + arrangement_.chain[1].size() && !curves_touch()) {
      nest();
    } else {
      make_faces();
    }
    label();
  }

 private:
  // Half-edge h starts at `from` of edge h / 2 when even, at `to` when odd; h ^ 1 is its twin.
  [[nodiscard]] std::uint32_t start(std::uint32_t h) const {
    return h % 2 == 0 ? edges_[h / 2].from : edges_[h / 2].to;
  }

  // The direction of a half-edge: that of its segment times this sign.
  [[nodiscard]] int sense(std::uint32_t h) const {
    const SubEdge& edge = edges_[h / 2];
    return h % 2 == 0 ? edge.along[edge.curve] : -edge.along[edge.curve];
  }

  // Upper half plane with the positive x axis: 0; lower with the negative one: 1.
  [[nodiscard]] int half_plane(std::uint32_t h) const {
    const SubEdge& edge = edges_[h / 2];
    const ExactCurve& curve = arrangement_.curves[edge.curve];
    const int dy = sense(h) * sgn(curve.dy[edge.segment]);
    const int dx = sense(h) * sgn(curve.dx[edge.segment]);
    return dy > 0 || (dy == 0 && dx > 0) ? 0 : 1;
  }

  [[nodiscard]] bool earlier(std::uint32_t g, std::uint32_t h) const {
    const int plane_g = half_plane(g);
    const int plane_h = half_plane(h);
    if (plane_g != plane_h) return plane_g < plane_h;
    const SubEdge& a = edges_[g / 2];
    const SubEdge& b = edges_[h / 2];
    return sense(g) * sense(h) *
               turn(arrangement_.curves[a.curve], a.segment, arrangement_.curves[b.curve], b.segment) >
           0;
  }

  // next_[h]: the half-edge that continues h around the face on its left. At the end of h that is the one
  // which comes clockwise after its twin.
  void link() {
    std::vector<std::vector<std::uint32_t>> leaving(arrangement_.points.size());
    const auto count = static_cast<std::uint32_t>(2 * edges_.size());
    for (std::uint32_t h = 0; h < count; ++h) leaving[start(h)].push_back(h);
    next_.resize(count);
    for (auto& fan : leaving) {
      std::sort(fan.begin(), fan.end(), [&](std::uint32_t g, std::uint32_t h) { return earlier(g, h); });
      for (std::size_t k = 0; k < fan.size(); ++k) next_[fan[(k + 1) % fan.size()] ^ 1U] = fan[k];
    }
  }

  void trace() {
    std::vector<Rational> cross(edges_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const ExactPoint& a = arrangement_.points[edges_[e].from];
      const ExactPoint& b = arrangement_.points[edges_[e].to];
      cross[e] = a.x * b.y - a.y * b.x;
    }
    cycle_.assign(next_.size(), none);
    for (std::uint32_t seed = 0; seed < next_.size(); ++seed) {
      if (cycle_[seed] != none) continue;
      std::vector<Rational> terms;
      for (std::uint32_t h = seed; cycle_[h] == none; h = next_[h]) {
        cycle_[h] = static_cast<std::uint32_t>(area_.size());
        terms.push_back(h % 2 == 0 ? cross[h / 2] : -cross[h / 2]);
      }
      area_.push_back(sum(std::move(terms)) / 2);
    }
  }

  [[nodiscard]] bool curves_touch() const {
    std::vector<bool> seen(arrangement_.points.size());
    for (const std::uint32_t point : arrangement_.chain[0]) seen[point] = true;
    return std::any_of(arrangement_.chain[1].begin(), arrangement_.chain[1].end(),
                       [&](std::uint32_t point) { return seen[point]; });
  }

  // Touching curves are connected, so every face has one boundary cycle, and the unbounded one is traced
  // clockwise.
  void make_faces() {
    std::vector<std::uint32_t> face(area_.size(), none);
    arrangement_.faces.resize(1);
    arrangement_.faces[0].bounded = false;
    for (std::size_t cycle = 0; cycle < area_.size(); ++cycle) {
      if (sgn(area_[cycle]) < 0) {
        face[cycle] = 0;
      } else {
        face[cycle] = static_cast<std::uint32_t>(arrangement_.faces.size());
        arrangement_.faces.push_back({area_[cycle], true, {}});
      }
    }
    if (std::count(face.begin(), face.end(), 0U) != 1) throw std::logic_error("no single unbounded face");
    set_left(face);
  }

  // Curves apart: two cycles each. If one encloses the other, its inner cycle and the other's outer one bound
  // a ring.
  void nest() {
    if (area_.size() != 4) throw std::logic_error("two curves apart without four cycles");
    const auto& [first, second] = arrangement_.curves;
    const bool second_within = contains(first, second, 0);
    const bool first_within = contains(second, first, 0);
    arrangement_.faces.resize(3);
    arrangement_.faces[0].bounded = false;
    std::vector<std::uint32_t> face(area_.size(), none);
    for (std::uint32_t c = 0; c < 2; ++c) {
      const std::uint32_t edge = arrangement_.chain_edges[c][0];
      const std::uint32_t forward = 2 * edge + (edges_[edge].along[c] > 0 ? 0 : 1);
      const bool surrounded = c == 0 ? first_within : second_within;
      face[cycle_[forward]] = c + 1;
      face[cycle_[forward ^ 1U]] = surrounded ? 2 - c : 0;
    }
    for (std::size_t cycle = 0; cycle < area_.size(); ++cycle) {
      if (face[cycle] != 0) arrangement_.faces[face[cycle]].area += area_[cycle];
    }
    set_left(face);
  }

  void set_left(const std::vector<std::uint32_t>& face) {
    arrangement_.left.resize(cycle_.size());
    for (std::size_t h = 0; h < cycle_.size(); ++h) arrangement_.left[h] = face[cycle_[h]];
  }

  // In and out change across an edge of a curve and nowhere else; flooded from the unbounded face, then
  // checked: the inside has to be to the left of each counter-clockwise curve.
  void label() {
    std::vector<std::vector<std::uint32_t>> around(arrangement_.faces.size());
    for (std::uint32_t h = 0; h < arrangement_.left.size(); ++h) around[arrangement_.left[h]].push_back(h);
    std::vector<bool> known(arrangement_.faces.size());
    std::vector<std::uint32_t> open{0};
    known[0] = true;
    while (!open.empty()) {
      const std::uint32_t face = open.back();
      open.pop_back();
      for (const std::uint32_t h : around[face]) {
        const std::uint32_t beyond = arrangement_.left[h ^ 1U];
        if (known[beyond]) continue;
        known[beyond] = true;
        open.push_back(beyond);
        for (std::size_t c = 0; c < 2; ++c) {
          arrangement_.faces[beyond].inside[c] = arrangement_.faces[face].inside[c] != (edges_[h / 2].along[c] != 0);
        }
      }
    }
    for (std::uint32_t h = 0; h < arrangement_.left.size(); ++h) {
      for (std::size_t c = 0; c < 2; ++c) {
        const int along = h % 2 == 0 ? edges_[h / 2].along[c] : -edges_[h / 2].along[c];
        if (along != 0 && arrangement_.left_face(h).inside[c] != (along > 0)) {
          throw std::logic_error("a face lies on the wrong side of a curve");
        }
      }
    }
  }

  Arrangement& arrangement_;
  const std::vector<SubEdge>& edges_;
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> cycle_;  // per half-edge
  std::vector<Rational> area_;        // per cycle, signed
};

}  // namespace

void trace_faces(Arrangement& arrangement) {
  Tracer(arrangement).run();
}

}  // namespace lober::oracle

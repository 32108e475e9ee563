// Pieces of a region: faces joined across edges, their boundaries walked from the outside.

#include <algorithm>
#include <numeric>

#include "engine/geometry/regions/arrangement.hpp"
#include "kernels/shoelace.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::uint32_t none = 0xffffffff;

class PieceFinder {
 public:
  PieceFinder(const Arrangement& scene, FillRule rule, Pairing pairing)
      : scene_(scene), graph_(scene.graph), faces_(scene.faces), piece_of_(faces_.size(), none) {
    for (std::uint32_t face = 0; face < faces_.size(); ++face) {
      if (belongs(faces_.labels[face].windings, rule, pairing)) piece_of_[face] = face;
    }
  }

  RegionPieces find(std::shared_ptr<const Arrangement> arrangement) {
    join_faces();
    measure();
    counter_clockwise_.resize(graph_.size());
    for (std::uint32_t half = 0; half < graph_.size(); ++half) {
      if (graph_.stands(half)) counter_clockwise_[graph_.clockwise[half]] = half;
    }
    walk_boundaries();
    result_.arrangement = std::move(arrangement);
    return RegionPieces(std::make_shared<const RegionPiecesData>(std::move(result_)));
  }

 private:
  // Gives the faces of the region the numbers of their pieces.
  void join_faces() {
    const auto root = [&](std::uint32_t face) {
      while (piece_of_[face] != face) face = piece_of_[face] = piece_of_[piece_of_[face]];
      return face;
    };
    for (std::uint32_t half = 0; half < graph_.size(); half += 2) {
      if (!graph_.stands(half)) continue;
      const std::uint32_t left = faces_.of[half], right = faces_.of[half + 1];
      if (piece_of_[left] == none || piece_of_[right] == none) continue;
      const std::uint32_t x = root(left), y = root(right);
      if (x != y) piece_of_[std::max(x, y)] = std::min(x, y);
    }
    for (std::uint32_t face = 0; face < faces_.size(); ++face) {
      if (piece_of_[face] == none) continue;
      // Parents come before their children, so what they hold is the number of a piece already.
      piece_of_[face] = piece_of_[face] == face ? pieces_++ : piece_of_[piece_of_[face]];
    }
  }

  void measure() {
    std::vector<RunningSum> sums(pieces_);
    outermost_.assign(pieces_, none);
    for (std::uint32_t face = 0; face < faces_.size(); ++face) {
      const std::uint32_t piece = piece_of_[face];
      if (piece == none) continue;
      sums[piece].add(faces_.twice_area[face]);
      std::uint32_t& outermost = outermost_[piece];
      if (outermost == none || faces_.labels[face].rank < faces_.labels[outermost].rank) outermost = face;
    }
    result_.areas.resize(pieces_);
    for (std::uint32_t piece = 0; piece < pieces_; ++piece) {
      result_.areas[piece] = scene_.area(sums[piece].value());
    }
  }

  [[nodiscard]] bool on_boundary(std::uint32_t half) const {
    return graph_.stands(half) && piece_of_[faces_.of[half]] != none && piece_of_[faces_.of[half ^ 1U]] == none;
  }

  // The region beyond a boundary, a component of the complement of the piece, is simply connected on the sphere. So a
  // walk that turns as that component does goes round all of it: there is one for the outside and one for each hole.
  void walk_boundaries() {
    std::vector<std::uint32_t> loops(pieces_, 0), halves(pieces_, 0);
    Buffer<std::uint8_t> seen(graph_.size(), 0);
    std::vector<Loop> list;
    Buffer<std::uint32_t> steps;
    const auto walk = [&](std::uint32_t start) {
      const std::uint32_t piece = piece_of_[faces_.of[start]];
      const std::size_t begin = steps.size();
      for (std::uint32_t half = start; seen[half] == 0; half = following(half, piece)) {
        seen[half] = 1;
        steps.push_back(half);
      }
      list.push_back({piece, begin, steps.size()});
    };
    // The face of a piece that is nearest to the outside is entered from outside the piece: that edge is on the outer
    // boundary.
    for (std::uint32_t piece = 0; piece < pieces_; ++piece) walk(faces_.labels[outermost_[piece]].entry);
    for (std::uint32_t half = 0; half < graph_.size(); ++half) {
      if (seen[half] == 0 && on_boundary(half)) walk(half);
    }
    std::stable_sort(list.begin(), list.end(), [](const Loop& x, const Loop& y) { return x.piece < y.piece; });
    result_.halves.reserve(steps.size());
    result_.first_loop.assign(pieces_ + std::size_t{1}, 0);
    result_.first_half.push_back(0);
    for (const Loop& loop : list) {
      ++result_.first_loop[loop.piece + 1];
      for (std::size_t k = loop.begin; k < loop.end; ++k) result_.halves.push_back(steps[k]);
      result_.first_half.push_back(static_cast<std::uint32_t>(result_.halves.size()));
    }
    for (std::uint32_t piece = 0; piece < pieces_; ++piece) {
      result_.first_loop[piece + 1] += result_.first_loop[piece];
    }
  }

  // The boundary of the piece after `half`, seen from the outside: the first half-edge, turning counter-clockwise from
  // the way back, that has the piece on its left.
  [[nodiscard]] std::uint32_t following(std::uint32_t half, std::uint32_t piece) const {
    std::uint32_t next = counter_clockwise_[half ^ 1U];
    while (piece_of_[faces_.of[next]] != piece) next = counter_clockwise_[next];
    return next;
  }

  struct Loop {
    std::uint32_t piece;
    std::size_t begin, end;
  };

  const Arrangement& scene_;
  const HalfEdges& graph_;
  const RegionFaces& faces_;
  Buffer<std::uint32_t> piece_of_;  // by face; none outside the region
  std::uint32_t pieces_ = 0;
  Buffer<std::uint32_t> outermost_;  // by piece: its face of lowest rank
  Buffer<std::uint32_t> counter_clockwise_;
  RegionPiecesData result_;
};

}  // namespace

RegionPieces Regions::pieces(FillRule rule, Pairing pairing) const {
  return PieceFinder(*arrangement_, rule, pairing).find(arrangement_);
}

RegionPieces::RegionPieces() {
  static const auto none = std::make_shared<const RegionPiecesData>();
  data_ = none;
}

std::span<const double> RegionPieces::areas() const& {
  return data_->areas;
}

RegionPiece RegionPieces::operator[](std::size_t piece) const {
  return {data_->areas[piece], data_->first_loop[piece + 1] - data_->first_loop[piece] - 1};
}

std::vector<std::vector<Point>> RegionPieces::outline(std::size_t piece) const {
  const Arrangement& scene = *data_->arrangement;
  const EdgeChains& edge_chains = scene.edge_chains;
  const Events& events = scene.events;
  // Appends the first point of a half-edge and the vertices inside it.
  const auto append = [&](std::uint32_t half, std::vector<Point>& points) {
    points.push_back(scene.node_point(events.node[origin(events, half)]));
    const std::uint32_t from = half / 2, to = events.next(from);
    const Event first = events[from], last = events[to];
    const int curve = edge_chains.curve_of(first.segment);
    const std::uint32_t offset = edge_chains.first_of(curve);
    const auto size = static_cast<std::uint32_t>(edge_chains.curve(curve).points.size());
    // Vertices begin + 1 .. begin + count lie between the two events, the second excluded if it is one of them.
    std::uint32_t count =
        last.segment >= first.segment ? last.segment - first.segment : size - (first.segment - last.segment);
    if (to <= from && last.segment == first.segment) count = size;  // once round the curve
    if (last.kind == Event::Kind::at_start && count > 0) --count;
    const std::size_t end = points.size() + count;
    for (std::uint32_t k = 1; k <= count; ++k) {
      points.push_back(edge_chains.curve(curve).points[(first.segment - offset + k) % size]);
    }
    if (half % 2 == 1) std::reverse(points.begin() + static_cast<std::ptrdiff_t>(end - count), points.end());
  };
  std::vector<std::vector<Point>> polygons;
  for (std::uint32_t loop = data_->first_loop[piece]; loop < data_->first_loop[piece + 1]; ++loop) {
    std::vector<Point>& polygon = polygons.emplace_back();
    for (std::uint32_t k = data_->first_half[loop]; k < data_->first_half[loop + 1]; ++k)
      append(data_->halves[k], polygon);
  }
  return polygons;
}

}  // namespace lober

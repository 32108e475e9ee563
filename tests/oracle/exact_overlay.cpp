#include "tests/oracle/exact_overlay.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "tests/oracle/disjoint_sets.hpp"
#include "tests/oracle/exact_result.hpp"

namespace lober::oracle {
namespace {

// Disjoint sets of faces.
bool in_region(const Face& face, std::size_t pairing) {
  const auto [in1, in2] = face.inside;
  switch (pairing) {
    case c1_minus_c2:
      return in1 && !in2;
    case c2_minus_c1:
      return in2 && !in1;
    case intersection:
      return in1 && in2;
    default:
      return in1 || in2;
  }
}

// Components of the complement of one piece, less the unbounded one. The complement is open across every edge
// that has it on both sides; faces that meet in a vertex only are not joined.
unsigned count_holes(const Arrangement& arrangement, const std::vector<bool>& in_piece) {
  DisjointSets sets(arrangement.faces.size());
  for (std::size_t e = 0; e < arrangement.edges.size(); ++e) {
    const std::uint32_t left = arrangement.left[2 * e];
    const std::uint32_t right = arrangement.left[2 * e + 1];
    if (!in_piece[left] && !in_piece[right]) sets.join(left, right);
  }
  unsigned components = 0;
  for (std::uint32_t face = 0; face < arrangement.faces.size(); ++face) {
    if (!in_piece[face] && sets.find(face) == face) ++components;
  }
  return components - 1;
}

Rational total(const std::vector<ExactPiece>& pieces) {
  std::vector<Rational> terms;
  for (const ExactPiece& piece : pieces) terms.push_back(piece.area);
  return sum(std::move(terms));
}

}  // namespace

std::vector<ExactPiece> find_pieces(const Arrangement& arrangement, std::size_t pairing) {
  const std::size_t count = arrangement.faces.size();
  DisjointSets sets(count);
  for (std::size_t e = 0; e < arrangement.edges.size(); ++e) {
    const std::uint32_t left = arrangement.left[2 * e];
    const std::uint32_t right = arrangement.left[2 * e + 1];
    if (in_region(arrangement.faces[left], pairing) && in_region(arrangement.faces[right], pairing)) {
      sets.join(left, right);
    }
  }
  std::vector<ExactPiece> pieces;
  for (std::uint32_t root = 0; root < count; ++root) {
    if (!in_region(arrangement.faces[root], pairing) || sets.find(root) != root) continue;
    std::vector<bool> in_piece(count);
    std::vector<Rational> areas;
    for (std::uint32_t face = 0; face < count; ++face) {
      if (sets.find(face) != root) continue;
      in_piece[face] = true;
      areas.push_back(arrangement.faces[face].area);
    }
    pieces.push_back({sum(std::move(areas)), count_holes(arrangement, in_piece)});
  }
  std::sort(pieces.begin(), pieces.end(), [](const ExactPiece& a, const ExactPiece& b) { return a.area > b.area; });
  return pieces;
}

ExactOverlay exact_overlay(std::span<const Point> first, std::span<const Point> second) {
  const Arrangement arrangement = arrange(first, second);
  const int area_exponent = 2 * arrangement.curves[0].exponent;
  ExactOverlay overlay;
  find_nodes(arrangement, overlay);
  for (std::size_t pairing = 0; pairing < 4; ++pairing) {
    overlay.pieces[pairing] = find_pieces(arrangement, pairing);
    for (ExactPiece& piece : overlay.pieces[pairing]) piece.area = scaled(piece.area, area_exponent);
  }
  overlay.area1 = scaled(Rational(arrangement.curves[0].twice_area) / 2, area_exponent);
  overlay.area2 = scaled(Rational(arrangement.curves[1].twice_area) / 2, area_exponent);
  const Rational common = total(overlay.pieces[intersection]);
  overlay.areas = {overlay.area1 - common, overlay.area2 - common, common, overlay.area1 + overlay.area2 - common};
  for (const std::size_t pairing : {c1_minus_c2, c2_minus_c1, union_}) {
    if (total(overlay.pieces[pairing]) != overlay.areas[pairing]) {
      throw std::logic_error("pieces do not add up to their area");
    }
  }
  return overlay;
}

}  // namespace lober::oracle

#include "tests/oracle/cgal_overlay.hpp"

#include <CGAL/Arr_default_overlay_traits.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_overlay_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <utility>

namespace lober::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_segment_traits_2<Kernel>;
// A face's number says which polygons it is inside of: bit 0 the first, bit 1 the second.
using Dcel = CGAL::Arr_face_extended_dcel<Traits, unsigned>;
using Subdivision = CGAL::Arrangement_2<Traits, Dcel>;
using FaceHandle = Subdivision::Face_const_handle;

struct JoinBits {
  unsigned operator()(unsigned first, unsigned second) const { return first | second; }
};
using OverlayTraits = CGAL::Arr_face_overlay_traits<Subdivision, Subdivision, Subdivision, JoinBits>;

// CGAL's interval filters assume that products neither overflow nor underflow, so very large or small
// polygons are scaled by a power of two, exactly, until their largest coordinate is near 1.
int size_exponent(std::span<const Point> first, std::span<const Point> second) {
  double largest = 0;
  for (const auto points : {first, second}) {
    for (const Point& point : points) largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
  }
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  return std::abs(exponent) > 200 ? exponent : 0;
}

std::vector<Point> scaled_down(std::span<const Point> points, int exponent) {
  std::vector<Point> result;
  for (const Point& point : points) {
    result.push_back({std::ldexp(point.x, -exponent), std::ldexp(point.y, -exponent)});
    const Point back{std::ldexp(result.back().x, exponent), std::ldexp(result.back().y, exponent)};
    if (!(back == point)) throw std::invalid_argument("coordinates of too many magnitudes for CGAL");
  }
  return result;
}

Subdivision subdivide(const std::vector<Point>& points, unsigned bit) {
  std::vector<Traits::X_monotone_curve_2> segments;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& a = points[i];
    const Point& b = points[(i + 1) % points.size()];
    if (a == b) continue;
    segments.emplace_back(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y));
  }
  Subdivision subdivision;
  CGAL::insert(subdivision, segments.begin(), segments.end());
  for (auto face = subdivision.faces_begin(); face != subdivision.faces_end(); ++face) {
    face->set_data(face->is_unbounded() ? 0U : bit);
  }
  return subdivision;
}

// CGAL picks its number type by what it was built with: a Boost wrapper of GMP's rationals, or its own.
template <class Number>
Rational from_cgal(const Number& number) {
  if constexpr (requires { number.backend().data(); }) {
    return Rational(number.backend().data());
  } else {
    return Rational(number.mpq());
  }
}

Rational exact(const Kernel::FT& value) {
  return from_cgal(value.exact());
}

template <class Circulator>
Rational cycle_area(Circulator start) {
  std::vector<Rational> terms;
  Circulator edge = start;
  do {
    const auto& a = edge->source()->point();
    const auto& b = edge->target()->point();
    terms.push_back(exact(a.x()) * exact(b.y()) - exact(a.y()) * exact(b.x()));
  } while (++edge != start);
  return sum(std::move(terms)) / 2;
}

Rational face_area(FaceHandle face) {
  std::vector<Rational> terms;
  for (auto cycle = face->outer_ccbs_begin(); cycle != face->outer_ccbs_end(); ++cycle)
    terms.push_back(cycle_area(*cycle));
  for (auto cycle = face->inner_ccbs_begin(); cycle != face->inner_ccbs_end(); ++cycle)
    terms.push_back(cycle_area(*cycle));
  return sum(std::move(terms));
}

bool in_region(unsigned inside, std::size_t pairing) {
  constexpr std::array<std::array<bool, 4>, 4> table{{{false, true, false, false},
                                                      {false, false, true, false},
                                                      {false, false, false, true},
                                                      {false, true, true, true}}};
  return table[pairing][inside];
}

class Pieces {
 public:
  explicit Pieces(const Subdivision& subdivision) : subdivision_(subdivision) {
    for (auto face = subdivision.faces_begin(); face != subdivision.faces_end(); ++face) {
      area_.emplace(face, face->is_unbounded() ? Rational(0) : face_area(face));
    }
  }

  [[nodiscard]] std::vector<CgalPiece> find(std::size_t pairing) const {
    const auto wanted = [&](FaceHandle face) { return in_region(face->data(), pairing); };
    std::vector<CgalPiece> pieces;
    for (const std::vector<FaceHandle>& component : components(wanted)) {
      CgalPiece piece;
      for (const FaceHandle face : component) piece.area += area_.at(face);
      const auto beyond = [&](FaceHandle face) {
        return std::find(component.begin(), component.end(), face) == component.end();
      };
      piece.holes = static_cast<unsigned>(components(beyond).size() - 1);
      pieces.push_back(piece);
    }
    std::sort(pieces.begin(), pieces.end(), [](const CgalPiece& a, const CgalPiece& b) { return a.area > b.area; });
    return pieces;
  }

 private:
  // Components of the chosen faces, two of them being neighbours when an edge lies between them.
  template <class Wanted>
  [[nodiscard]] std::vector<std::vector<FaceHandle>> components(const Wanted& wanted) const {
    std::vector<std::vector<FaceHandle>> result;
    std::map<FaceHandle, bool> seen;
    for (auto seed = subdivision_.faces_begin(); seed != subdivision_.faces_end(); ++seed) {
      if (!wanted(seed) || seen[seed]) continue;
      seen[seed] = true;
      std::vector<FaceHandle> component{seed};
      for (std::size_t k = 0; k < component.size(); ++k) {
        for (auto edge = subdivision_.halfedges_begin(); edge != subdivision_.halfedges_end(); ++edge) {
          const FaceHandle next = edge->twin()->face();
          if (edge->face() != component[k] || !wanted(next) || seen[next]) continue;
          seen[next] = true;
          component.push_back(next);
        }
      }
      result.push_back(std::move(component));
    }
    return result;
  }

  const Subdivision& subdivision_;
  std::map<FaceHandle, Rational> area_;
};

}  // namespace

CgalOverlay cgal_overlay(std::span<const Point> first, std::span<const Point> second) {
  const int exponent = size_exponent(first, second);
  const Subdivision one = subdivide(scaled_down(first, exponent), 1);
  const Subdivision two = subdivide(scaled_down(second, exponent), 2);
  Subdivision both;
  OverlayTraits traits;
  CGAL::overlay(one, two, both, traits);
  const Pieces finder(both);
  CgalOverlay overlay;
  overlay.faces = both.number_of_faces();
  for (std::size_t pairing = 0; pairing < 4; ++pairing) {
    overlay.pieces[pairing] = finder.find(pairing);
    for (CgalPiece& piece : overlay.pieces[pairing]) {
      piece.area = scaled(piece.area, 2 * exponent);
      overlay.areas[pairing] += piece.area;
    }
  }
  return overlay;
}

}  // namespace lober::oracle

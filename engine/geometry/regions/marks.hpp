// Nodes of the arrangement, and where along the curves they lie (private to regions/).
//
// A *mark* is a place on a curve where something happens: another strand meets it there, or a spike has its tip, or it
// is the extreme vertex of its curve. Marks that are one point of the plane make a *node*. No coordinates are compared
// to find out: each two strands through a point are a pair whose incidence is known and unites their marks, and marks
// of one strand are compared by their exact order along it.
#pragma once

#include <array>
#include <cstdint>

#include "engine/geometry/regions/incidences.hpp"

namespace lober {

/// Every incidence places its point within 2^-91 of the scene (crossing_parameters.hpp), so where several make one mark
/// the parameter of any of them will do.
struct Mark {
  enum class Kind : std::uint8_t {
    at_start,     ///< the first end of the segment
    at_vertex,    ///< inside the segment, the first end of `other`
    at_crossing,  ///< inside both the segment and `other`
  };
  DD t;
  std::uint32_t segment;
  std::uint32_t other;  ///< of all segments that would do, the same one whatever the order of incidences
  std::uint32_t node;
  Kind kind;
};

struct Marks {
  Buffer<Mark> list;                       ///< in order along C1, then along C2
  std::array<std::uint32_t, 3> begin{};    ///< marks of curve c (0, 1): begin[c] .. begin[c + 1]; at least one each
  std::uint32_t nodes = 0;                 ///< numbered in the order of their first marks
  std::uint32_t plain = 0;                 ///< of these, points where nothing meets and no spike has its tip
  std::array<std::uint32_t, 2> extreme{};  ///< the mark at the vertex of each curve that is greatest by x, then y
  std::uint64_t exact_orders = 0;          ///< pairs of marks compared in exact arithmetic

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(list.size()); }
  /// The marks before and after a mark along its curve, cyclically.
  [[nodiscard]] std::uint32_t next(std::uint32_t mark) const {
    const std::size_t curve = mark < begin[1] ? 0 : 1;
    return mark + 1 == begin[curve + 1] ? begin[curve] : mark + 1;
  }
  [[nodiscard]] std::uint32_t previous(std::uint32_t mark) const {
    const std::size_t curve = mark < begin[1] ? 0 : 1;
    return mark == begin[curve] ? begin[curve + 1] - 1 : mark - 1;
  }
};

/// `extreme`: the segments whose first ends are the extreme vertices. O(incidences), parallel where it is long.
[[nodiscard]] Marks make_marks(const Strands& strands, const Incidences& incidences,
                               std::array<std::uint32_t, 2> extreme);

/// The mark as a point along its segment, for compare_along.
[[nodiscard]] ImplicitPoint implicit_point(const Strands& strands, const Mark& mark);

/// The mark rounded to double: exact if it is a vertex, else right to about an ulp.
[[nodiscard]] Point place(const Strands& strands, const Mark& mark);

}  // namespace lober

// Families of pairs of simple closed polygons, on which engine and oracles have to agree.
//
// A pair is named by its family and a seed. (Shapes use cos, sin and pow of the C library, whose last bit may
// differ between machines: a pair to be kept is kept as its coordinates, not as its seed.)
#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "tests/oracle/shapes.hpp"

namespace lober::oracle {

struct CurvePair {
  std::string family;
  std::uint64_t seed = 0;
  Polygon first, second;
};

struct Family {
  std::string_view name;
  PolygonPair (*make)(Random&);
};

/// For the names of tests.
inline std::ostream& operator<<(std::ostream& stream, const Family& family) {
  return stream << family.name;
}

[[nodiscard]] std::span<const Family> families();

/// The pair of that name. Both polygons are simple (checked exactly; attempts that fail are dropped), in
/// either orientation, start anywhere, and now and then repeat vertices.
[[nodiscard]] CurvePair make_curve_pair(const Family& family, std::uint64_t seed);

/// Moves and scales both by a map drawn from the seed: a shift of about 1e6 in units of the pair's size, a
/// scale between 1e-8 and 1e8, or both. The result, as rounded, need not be simple.
[[nodiscard]] CurvePair transformed(const CurvePair& pair);

/// The same pair with the curves exchanged, one backwards and one from its middle vertex on.
[[nodiscard]] CurvePair rearranged(const CurvePair& pair);

// The members of `families()`.
namespace family {
PolygonPair stars(Random& random);
PolygonPair scattered_points(Random& random);
PolygonPair mixed(Random& random);
PolygonPair wavy(Random& random);
PolygonPair lattice(Random& random);
PolygonPair polyominoes(Random& random);
PolygonPair rectangles(Random& random);
PolygonPair combs(Random& random);
PolygonPair spirals(Random& random);
PolygonPair collinear(Random& random);
PolygonPair shared_same_way(Random& random);
PolygonPair shared_border(Random& random);
PolygonPair shared_on_lattice(Random& random);
PolygonPair shared_to_one_ulp(Random& random);
PolygonPair identical(Random& random);
PolygonPair nested(Random& random);
PolygonPair disjoint(Random& random);
PolygonPair touching(Random& random);
PolygonPair inscribed(Random& random);
PolygonPair own_scales(Random& random);
PolygonPair anisotropic(Random& random);
PolygonPair log_uniform(Random& random);
PolygonPair slivers(Random& random);
PolygonPair far_away(Random& random);
PolygonPair extreme_scale(Random& random);
PolygonPair powers_of_2_200(Random& random);
PolygonPair denormal_axis(Random& random);
}  // namespace family

}  // namespace lober::oracle

// Random closed polygons, the raw material of the families. They are nearly always simple, not always.
#pragma once

#include <utility>
#include <vector>

#include "kernels/point.hpp"
#include "tests/oracle/random.hpp"

namespace lober::oracle {
using namespace lober::detail;

using Polygon = std::vector<Point>;
using PolygonPair = std::pair<Polygon, Polygon>;

/// Star-shaped about `centre`, with `count` vertices at distances between the two radii.
[[nodiscard]] Polygon star(Random& random, int count, Point centre, double near, double far);

/// The given points joined by a tour without crossings (2-opt).
[[nodiscard]] Polygon untangled(Polygon points);

/// `count` random points of the unit square, untangled.
[[nodiscard]] Polygon scattered(Random& random, int count);

/// `count` distinct points with integer coordinates in [0, size], untangled.
[[nodiscard]] Polygon on_lattice(Random& random, int count, int size);

/// The outline of a connected set of `cells` unit squares; vertices on straight sides are kept at random.
[[nodiscard]] Polygon polyomino(Random& random, int cells);

/// An axis-parallel rectangle with integer corners in [0, size] and some more lattice points along its sides.
[[nodiscard]] Polygon rectangle(Random& random, int size);

/// A strip wound `turns` times round the origin.
[[nodiscard]] Polygon spiral(Random& random, double turns);

/// A comb with vertical teeth in [0, 1] x [0, 1] (times `size` and rounded to integers when `lattice`).
[[nodiscard]] Polygon comb(Random& random, int teeth, bool lattice);

/// A polygon of the given width along the straight line from a to b.
[[nodiscard]] Polygon needle(Random& random, Point a, Point b, double width);

/// Some shape of moderate size near the unit square.
[[nodiscard]] Polygon any_shape(Random& random);

/// Some shape with small integer coordinates.
[[nodiscard]] Polygon any_lattice_shape(Random& random);

/// x -> scale x + shift, componentwise.
[[nodiscard]] Polygon moved(const Polygon& polygon, Point scale, Point shift);

/// Inserts exact midpoints into some segments, where both coordinates have one in integers.
[[nodiscard]] Polygon with_midpoints(Random& random, const Polygon& polygon, double probability);

}  // namespace lober::oracle

// The curves of Naik, Lekien & Ross (2017), tables 1 to 4.
#pragma once

#include <vector>

#include "lober/curve/point.hpp"

namespace lober::test {

// C1 runs along the bottom of a rectangle through the crossings 1 to 6; C2 passes them in the order 1, 2, 5, 4, 3, 6,
// above the bottom between 1 and 2, 5 and 4, 3 and 6, and goes round the whole rectangle from 6 to 1.
inline const std::vector<Point> six_crossings_c1{{0, 0}, {7, 0}, {7, 4}, {0, 4}};
inline const std::vector<Point> six_crossings_c2{{1, 1}, {2, 1}, {2, -3}, {5, -3}, {5, 1}, {4, 1},  {4, -1},  {3, -1},
                                                 {3, 2}, {6, 2}, {6, -1}, {8, -1}, {8, 5}, {-1, 5}, {-1, -1}, {1, -1}};

}  // namespace lober::test

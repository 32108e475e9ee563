// The copy of a stable manifold, among those that whole periods move, that belongs to an unstable manifold.
#pragma once

#include <span>
#include <string>

#include "lober/curve/periods.hpp"
#include "lober/curve/point.hpp"

namespace lober::cli {

/// Moves the points of S by whole periods to where it meets U first. The saddles, where the curves begin, are known up
/// to whole periods; where U leaves its saddle towards larger values of a periodic coordinate and S leaves its own
/// towards smaller ones, the saddle of S is the next one on that side, a whole period farther if both are the same
/// point; where both leave to the same side of one saddle it stays one. Otherwise the middles of the curves are brought
/// as near as can be (move_near). Returns a sentence about it, for the report; empty without a period. O(n).
[[nodiscard]] std::string lift_manifold(std::span<Point> s, std::span<const Point> u, Periods periods);

}  // namespace lober::cli

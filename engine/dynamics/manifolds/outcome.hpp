// From samples to a curve with flaws (private to dynamics/).
#pragma once

#include <cstddef>
#include <vector>

#include "engine/dynamics/manifolds/trace.hpp"

namespace lober {

/// Appends the samples from number `first` on to a curve, without those whose image is not finite; flaws are numbered
/// by the segments of the curve, and neighbouring ones of the same cause joined.
void append_finite(const Trace& trace, std::size_t first, Buffer<Point>& points, Buffer<double>& parameters,
                   std::vector<GrowthFlaw>& flaws);

/// Drops flaws of segments from number `segments` on.
void cut_flaws(std::vector<GrowthFlaw>& flaws, std::size_t segments);

}  // namespace lober

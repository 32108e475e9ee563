// The curve that samples make, with diagnostics (private to dynamics/).
#pragma once

#include <cstddef>
#include <vector>

#include "engine/dynamics/manifolds/trace.hpp"

namespace lober::detail {

/// Appends the samples from number `first` on to a curve, without those whose image is not finite; diagnostics are
/// numbered by the segments of the curve, and neighbouring ones of the same cause joined. Parameters are multiplied by
/// `sign`, 1 or -1.
void append_finite(const Trace& trace, std::size_t first, double sign, Buffer<Point>& points,
                   Buffer<double>& parameters, std::vector<GrowthDiagnostic>& diagnostics);

/// Drops diagnostics of segments from number `segments` on.
void cut_diagnostics(std::vector<GrowthDiagnostic>& diagnostics, std::size_t segments);

}  // namespace lober::detail

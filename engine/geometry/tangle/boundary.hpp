// The boundary B(q) and the parts of the lobes inside it (private to tangle/).
#pragma once

#include "engine/geometry/tangle/curves.hpp"

namespace lober::detail {

/// The number of the pip that the options ask for. Throws UsageError if it does not exist, or lies farther from the
/// point that was given than from where U and S begin. There must be a pip.
[[nodiscard]] std::size_t choose_bip(const Tangle& tangle, const TangleOptions& options);

/// Twice the signed area of what U[p-, q], S[q, p+] and the closure enclose, q the pip of this number, at the scale of
/// TangleCurves.
[[nodiscard]] DD twice_swept(const Tangle& tangle, std::size_t pip);

/// Fills in `boundary` for its bip, and `inside` and `outside` of every lobe. Exact decisions only: a lobe that the
/// boundary does not cross lies inside or outside by the side on which it is, with no area computed.
///
/// Lobe m >= b shares S_m with the boundary, and its U_m may cross S[q_b, p+]; lobe m < b shares U_m, and its S_m may
/// cross U[p-, q_b]. With o_m, o_B the orientations, it lies inside along the shared arc if o_m = -o_B (m >= b) or
/// o_m = o_B (m < b); then
///   2 inside = [inside along the shared arc] 2 |area| -+ o_m o_B sum of rho D over those crossings.
/// This holds if neither p- nor p+ lies in the lobe and the closure meets neither the lobe nor the rest of the
/// boundary. Otherwise polygons are overlaid, and smooth curves are measured by winding numbers (winding_sums.hpp).
void bound_lobes(Tangle& tangle);

}  // namespace lober::detail

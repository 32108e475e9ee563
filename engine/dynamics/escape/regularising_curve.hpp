// A closed curve about an exit that the map can carry over: the part of an image in it is cut off (private to
// escape/, see cut_images.hpp).
#pragma once

#include "lober/dynamics/tubes.hpp"

namespace lober::detail {

/// Both tubes of a bottleneck, towards the section.
struct BottleneckTubes {
  const Tube* unstable = nullptr;
  const Tube* stable = nullptr;
  Branch in = Branch::plus, out = Branch::plus;
  int exit_direction = 0;   ///< in which X is crossed
  int entry_direction = 0;  ///< in which E is crossed
};

/// The trajectories with s w = I (1 + small) next to the orbit of a bottleneck, with w and s both near the square root
/// of I: those of one turn. Sums of points of the two local manifolds are not exact coordinates, so that turn and
/// product are adapted until the end of the turn is the image of its beginning. Flow and tubes must outlive it.
class RegularisingCurve {
 public:
  /// `strip` is the area between it and the exit, on `section`. Throws DataError when it cannot be closed.
  RegularisingCurve(const Flow& flow, const Section& section, const BottleneckTubes& tubes, double strip,
                    const IntegrationOptions& integration);

  /// Where the trajectory of parameter u begins, with period 1 and the whole turn [0, 1] in one piece.
  [[nodiscard]] FlowState state(double u) const;

 private:
  [[nodiscard]] Point point(double part) const;

  const Flow& flow_;
  BottleneckTubes tubes_;
  double product_, log_multiplier_, widest_;
  double turn_ = 1, growth_ = 0;
};

}  // namespace lober::detail

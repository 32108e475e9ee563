// The areas of the regions that two closed curves bound; overlay/ and interior/ compute them independently.
#pragma once

namespace lober {

/// Areas in squared units of the coordinates, all >= 0.
struct Areas {
  double c1 = 0, c2 = 0;                    ///< each region
  double intersection = 0, union_ = 0;      ///< the common part, and both together
  double c1_minus_c2 = 0, c2_minus_c1 = 0;  ///< the part of one outside of the other
  double symmetric_difference = 0;          ///< either, not both
};

}  // namespace lober

// Symmetries of a well that show in its table of escape: a second route to fractions (private to escape/).
//
// Tried are the changes of sign of single coordinates, that across the section about the section's value. One that
// leaves the Hamiltonian as it is maps solutions onto solutions: in the same direction of time when it keeps p dq in
// both pairs, backwards when it turns both round. Exits then become entrances:
//
//   F_ij(m) = F_s(i)s(j)(m),   or, backwards,   area(E_i) F_ij(m) = area(E_s(j)) F_s(j)s(i)(m),
//
// s(i) being the bottleneck that i becomes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lober/transport/escape.hpp"

namespace lober::detail {

struct EscapeSymmetry {
  bool backwards = false;            ///< exchanges past and future
  std::vector<std::size_t> becomes;  ///< by bottleneck
};

/// The symmetries of the Hamiltonian, by its values at a few dozen states about the orbits, and that map bottlenecks
/// onto bottlenecks; the identity left out.
[[nodiscard]] std::vector<EscapeSymmetry> symmetries(const Flow& flow, const Section& section,
                                                     std::span<const Bottleneck> bottlenecks);

}  // namespace lober::detail

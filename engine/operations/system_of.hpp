// The system that an operation is about (private to operations/).
#pragma once

#include <span>

#include "engine/operations/option_list.hpp"
#include "lober/operations.hpp"

namespace lober::detail::table {
using namespace operations;

/// The first input.
[[nodiscard]] const SystemInput& system_input_of(std::span<const Input> inputs);
/// Throws UsageError unless it has a planar map.
[[nodiscard]] const SystemInput& system_of(std::span<const Input> inputs);

/// How::turns, by how many shifts of the system's lattice a periodic point moves in a period.
template <typename How>
OptionList<How>& add_turns_option(OptionList<How>& list) {
  return list.option(
      "turns", &How::turns,
      "number of shifts of the plane, of those after which the system repeats, by which a point moves in a period: the "
      "turns of a lifted angle",
      {.min = -1e6, .max = 1e6, .value = "M"});
}
/// Those turns as a shift of the plane. Throws UsageError unless they are 0 or the system repeats after a shift.
[[nodiscard]] Point shift_by(int turns, const System& system);

}  // namespace lober::detail::table

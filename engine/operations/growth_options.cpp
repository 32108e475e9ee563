#include "engine/operations/growth_options.hpp"

#include <cmath>
#include <string>

#include "kernels/elementary.hpp"

namespace lober::detail::table {

double tolerance_in(const System& system, std::optional<double> given) {
  if (given) return *given;
  constexpr int digits = 5;
  // Read from its decimal form, so that it is that number and not one beside it.
  return std::stod("1e" +
                   std::to_string(static_cast<int>(std::lround(elementary::log10(system.map->unit()))) - digits));
}

}  // namespace lober::detail::table

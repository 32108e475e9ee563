// All operations. A new one is a file beside this one and a line in the list below.
#include "engine/batch/operations/table.hpp"

#include <algorithm>
#include <array>

namespace lober::detail {

std::span<const Operation> all_operations() {
  static const std::array table{
      overlay_operation(),      interior_operation(),        regions_operation(), winding_operation(),
      tangle_operation(),       manifold_tangle_operation(), densify_operation(), simplify_operation(),
      transport_operation(),    curve_transport_operation(), sweep_operation(),   escape_operation(),
      fixed_points_operation(), levels_operation(),          section_operation(), grow_operation()};
  return table;
}

bool takes(Arity arity, std::size_t curves) {
  switch (arity) {
    case Arity::none:
      return curves == 0;
    case Arity::one:
      return curves == 1;
    case Arity::two:
      return curves == 2;
    case Arity::one_or_two:
      return curves == 1 || curves == 2;
  }
  return false;
}

const Operation* find_operation(std::string_view name) {
  const std::span<const Operation> table = all_operations();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Operation& any) { return any.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace lober::detail

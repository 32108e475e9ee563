#include "engine/operations/curves_tangle.hpp"

#include "engine/operations/curve_of.hpp"
#include "lober/base/error.hpp"

namespace lober::detail::table {
using namespace operations;

std::vector<InputSpec> manifold_inputs() {
  return {{"u", InputKind::open_curve, "the unstable manifold, outward from its fixed point"},
          {"s", InputKind::open_curve, "the stable manifold, outward from its fixed point"}};
}

Tangle tangle_of_curves(const Operation& operation, std::span<const Input> inputs, CurvesHow& how,
                        const Context& context) {
  if (how.bip_number) how.bip = static_cast<std::size_t>(*how.bip_number);
  if (how.period_given) how.period = static_cast<std::uint32_t>(*how.period_given);
  if (how.closure_corners) {
    const std::vector<double>& numbers = *how.closure_corners;
    if (numbers.size() % 2 != 0) throw UsageError("option \"closure\" needs two coordinates for each corner");
    for (std::size_t k = 0; k < numbers.size(); k += 2) how.closure.push_back({numbers[k], numbers[k + 1]});
  }
  how.progress = context.progress;
  if (known_simple(inputs, 0) && known_simple(inputs, 1)) how.check_simple = false;
  Tangle found = tangle(indexed_curve(operation, inputs, 0), indexed_curve(operation, inputs, 1), how);
  if (!found.images.misfit.empty()) throw UsageError("option \"period\": " + found.images.misfit);
  return found;
}

}  // namespace lober::detail::table

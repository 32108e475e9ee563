// Operations on two manifolds that are given as curves: what their tangle is made with (private to operations/).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/operations/option_list.hpp"
#include "lober/tangle/tangle.hpp"

namespace lober::detail::table {
using namespace operations;

/// Some take the place of what TangleOptions has for them.
struct CurvesHow : TangleOptions {
  std::optional<std::int64_t> bip_number{}, period_given{};
  std::optional<std::vector<double>> closure_corners{};
};

/// The bip, the period and the closure.
template <typename How>
OptionList<How>& add_curves_options(OptionList<How>& list) {
  return list
      .option("bip", &How::bip_number,
              "number of the boundary intersection point, the pip at which the boundary passes from U to S, from 0",
              {.min = 0, .max = 4e9, .otherwise = "the pip nearest to bip_near, or the middle one", .value = "K"})
      .option("period", &How::period_given,
              "number of pips from one to its image, at most the number of lobes, and even where lobes alternate",
              {.min = 1, .max = 1'000'000, .otherwise = "inferred from the areas", .value = "P"})
      .option("bip_near", &How::bip_near, "point near it", {.otherwise = "none", .value = "X,Y"})
      .option("closure", &How::closure_corners,
              "corners of the path that closes the boundary, from the fixed point of S to that of U",
              {.otherwise = "the straight line", .value = "X1,Y1,X2,Y2,..."});
}

/// The two inputs of such an operation.
[[nodiscard]] std::vector<InputSpec> manifold_inputs();

/// The tangle of the inputs; completes `how`. Throws what `tangle` throws, and UsageError for a period that does not
/// fit.
[[nodiscard]] Tangle tangle_of_curves(const Operation& operation, std::span<const Input> inputs, CurvesHow& how,
                                      const Context& context);

}  // namespace lober::detail::table

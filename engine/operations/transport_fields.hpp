// Fields of results for transport, n by n (private to operations/).
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/operations/schema.hpp"
#include "lober/transport/transport.hpp"

namespace lober::detail::table {
using namespace operations;

/// Fields for n = 1, 2, ...
[[nodiscard]] Schema<TransportStep> step_schema();
/// Fields for R1, R2, ...
[[nodiscard]] Schema<Region> regions_schema();

/// Error bars of T21(n) and the checks that support them, for any result that has `steps`.
template <typename T>
[[nodiscard]] Schema<T> step_errors() {
  const auto worst = [](auto of) {
    return [of](const T& t) {
      double largest = 0;
      for (const TransportStep& step : t.steps) largest = std::max(largest, of(step));
      return largest;
    };
  };
  Schema<T> made;
  made.field("discretisation", "area",
             "estimate of |T - true T| by lobes, integration and rounding included; worst step",
             worst([](const TransportStep& s) { return s.total(1, 0).error; }))
      .field("boundaries", "area", "the same by boundaries",
             worst([](const TransportStep& s) { return s.by_boundaries(1, 0).error; }))
      .field("consistency", "area", "|T by lobes - T by boundaries|; worst step", worst([](const TransportStep& s) {
               return std::fabs(s.total(1, 0).value - s.by_boundaries(1, 0).value);
             }));
  return made;
}

}  // namespace lober::detail::table

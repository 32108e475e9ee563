// Segments of grown curves that do not meet the tolerance (private to operations/).
#pragma once

#include <string>

#include "engine/operations/schema.hpp"
#include "lober/dynamics/manifolds.hpp"

namespace lober::detail::table {

/// The diagnostics of a GrownManifold or a CurveImage.
template <typename Grown>
[[nodiscard]] Schema<Grown> diagnostics_schema() {
  struct One {
    const Grown* grown;
    const GrowthDiagnostic* diagnostic;
  };
  struct All {
    const Grown* grown;
    [[nodiscard]] std::size_t size() const { return grown->diagnostics.size(); }
    One operator[](std::size_t k) const { return {grown, &grown->diagnostics[k]}; }
  };
  Schema<Grown> counts;
  for (const GrowthDiagnosticCause cause : all_growth_causes) {
    counts.field(std::string(name(cause)), "", "number of segments", [cause](const Grown& g) {
      std::size_t sum = 0;
      for (const GrowthDiagnostic& one : g.diagnostics) sum += one.cause == cause ? one.count : 0;
      return sum > 0 ? std::optional(sum) : std::nullopt;
    });
  }
  Schema<One> one;
  one.field("segment", "", "number of the first segment, from 0", [](const One& o) { return o.diagnostic->first; })
      .field("count", "", "number of segments in a row", [](const One& o) { return o.diagnostic->count; })
      .field("cause", "", "failed, spacing, max_rounds or left-box",
             [](const One& o) { return std::string(name(o.diagnostic->cause)); })
      .field("at", "length", "point where the first segment begins",
             [](const One& o) { return o.grown->points[o.diagnostic->first]; });
  Schema<Grown> made;
  made.object("counts", "number of segments by cause, for each cause that occurs", counts,
              [](const Grown& g) { return &g; })
      .list("list", "places in order", one, [](const Grown& g) { return All{&g}; });
  return made;
}

}  // namespace lober::detail::table

// Fields of results for a tangle's crossings, pips, lobes and boundary (private to operations/).
#pragma once

#include "engine/operations/schema.hpp"

namespace lober::detail::table {
using namespace operations;

/// All of it, for others to go on with.
[[nodiscard]] Schema<CurveTangle> lobes_schema();

/// The shapes of the lobes, which their error bars are made of; what lobes have in common, where that is asked for. The
/// rest of a CurveTangle is there already.
void measure_lobes(CurveTangle& tangle, bool with_overlaps);

}  // namespace lober::detail::table

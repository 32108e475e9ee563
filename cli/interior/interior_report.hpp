// The findings of `lober interior`, for the table and the picture to show.
#pragma once

#include <string>

#include "cli/picture/figure.hpp"
#include "cli/program/curves_run.hpp"

namespace lober::cli {

/// The short aligned table for people.
[[nodiscard]] std::string interior_table(const CurvesReport& report);

/// The parts of both curves outside and inside of each other, the paths of Q1, Q2 and Q3.
[[nodiscard]] Figure interior_figure(const InteriorAreas& result, const std::array<NamedCurve, 2>& inputs);

}  // namespace lober::cli

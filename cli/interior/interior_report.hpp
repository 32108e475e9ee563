// The findings of `lober interior`, for the table and the picture to show.
#pragma once

#include <string>

#include "cli/program/curves_run.hpp"

namespace lober::cli {

/// The short aligned table for people.
[[nodiscard]] std::string interior_table(const CurvesReport& report);

/// The parts of both curves outside and inside of each other, the paths of Q1, Q2 and Q3, as an SVG picture.
void write_interior_picture(const std::string& path, const InteriorAreas& result);

}  // namespace lober::cli

// The report of `lober densify` on its inputs and its work.
#pragma once

#include <string>
#include <vector>

#include "cli/picture/picture_options.hpp"
#include "cli/report/json.hpp"
#include "lober/curve/files.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

/// A few lines for people.
[[nodiscard]] std::string densify_summary(const std::vector<NamedCurve>& curves, const operations::RefinedCurve& found);
/// The files, with their hashes and sizes.
[[nodiscard]] Json files_json(const std::vector<NamedCurve>& curves);
/// The curve with the points that were given, inserted or removed, and AGAINST; both arguments have to outlive it.
[[nodiscard]] Figure densify_figure(const std::vector<NamedCurve>& curves, const operations::RefinedCurve& found);

}  // namespace lober::cli

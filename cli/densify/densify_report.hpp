// Everything that `lober densify` did, for the lines on the terminal and the JSON to show.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lober/densify.hpp"
#include "lober/files.hpp"

namespace lober::cli {

/// What was asked for, with defaults filled in.
struct DensifySteps {
  std::optional<SimplifyOptions> simplify;
  std::optional<Criteria> criteria;
  int passes = 0, points = 0;
  bool crossings = false;
  Interpolation interpolation = Interpolation::linear;
  std::size_t max_points = 0;
};

struct DensifyReport {
  std::vector<NamedCurve> inputs;  ///< the curve, and the one it is densified against
  DensifySteps steps;
  DensifiedCurve result;
  std::optional<DensifiedCurve> against;  ///< with the crossings inserted
  struct Step {
    std::string name;
    std::size_t points;    ///< after it
    std::uint32_t rounds;  ///< it took
  };
  std::vector<Step> done;               ///< in order
  std::vector<Diagnostic> diagnostics;  ///< of the criteria; empty when a later step changed the numbers of segments
  std::vector<std::size_t> diagnostic_counts;  ///< by DiagnosticCause
  struct {
    double read = 0, densify = 0, write = 0;  ///< seconds
  } timing;
};

/// A few lines for people.
[[nodiscard]] std::string densify_summary(const DensifyReport& report);

/// Writes the JSON object (docs/conventions.md, section 13); `seconds_so_far` is asked when all but the timing is
/// written.
void write_densify_json(const std::string& path, const DensifyReport& report,
                        const std::function<double()>& seconds_so_far);

}  // namespace lober::cli

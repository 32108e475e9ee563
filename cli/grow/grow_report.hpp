// Everything that `lober grow` did, for the lines on the terminal and the JSON to show.
#pragma once

#include <functional>
#include <string>

#include "lober/manifolds.hpp"
#include "lober/systems.hpp"

namespace lober::cli {

struct GrowReport {
  System system;
  IntegrationOptions integration;
  LocalManifold local;
  Branch branch = Branch::plus;
  GrowthOptions options;
  GrownManifold manifold;
  struct {
    double local = 0, growth = 0, write = 0;  ///< seconds
  } timing;
};

/// Whether growing went as far as the options ask, and how it ended, in words.
[[nodiscard]] bool ends_as_asked(const GrowReport& report);
[[nodiscard]] std::string end_of_growth(const GrowReport& report);

/// A few lines for people.
[[nodiscard]] std::string grow_summary(const GrowReport& report);

/// Writes the JSON object; `seconds_so_far` is asked when all but the timing is written.
void write_grow_json(const std::string& path, const GrowReport& report, const std::function<double()>& seconds_so_far);

}  // namespace lober::cli

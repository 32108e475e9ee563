// The energy, saddles and section of an escape (private to operations/).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lober/operations.hpp"

namespace lober::detail::table {
using namespace operations;

struct EscapeChoice {
  std::optional<double> energy{};
  std::vector<std::string> saddles{};  ///< numbers from 1, "X,Y" or "X,Y,PX,PY"; none: all of the system
  std::optional<std::string> section{}, direction{}, bound{};  ///< "x=0.5"; "+", "-" or "both"; "x<-1"
  int crossings = 0;                                           ///< 0: orbits and tubes alone
};

/// The system with that energy: its own energy goes with its own section, which then is the one that the escape is
/// about.
[[nodiscard]] System system_with_energy(const SystemInput& input, const EscapeChoice& choice);

// These throw UsageError for options that are missing or cannot be read.
[[nodiscard]] double energy_of(const EscapeChoice& choice, const System& system);
[[nodiscard]] std::vector<FlowState> saddles_of(const EscapeChoice& choice, const System& system);
[[nodiscard]] Section section_of(const EscapeChoice& choice, const System& system);

/// "left" and "right" when there is one bottleneck on either side of the section, else "1", "2", ...
[[nodiscard]] std::vector<std::string> bottleneck_names(const Escape& result);

}  // namespace lober::detail::table

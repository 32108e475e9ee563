// The saddles and branches that a tangle is made of (private to operations/).
#pragma once

#include <optional>
#include <vector>

#include "engine/operations/option_list.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::detail::table {
using namespace operations;

struct ConnectionChoice {
  std::optional<Point> from{}, to{}, u_direction{}, s_direction{}, bip{};

  /// Whether nothing is given but, perhaps, the bip.
  [[nodiscard]] bool is_own() const { return !from && !to && !u_direction && !s_direction; }
};

/// Its members as options.
[[nodiscard]] const OptionList<ConnectionChoice>& connection_options();

/// The connection of the system, with the given values in place of its own. Throws UsageError with the missing ones.
[[nodiscard]] Connection chosen_connection(const ConnectionChoice& choice, const System& system);

/// The other boundaries of the system, where they are wanted or the first region is not bounded without them. Other
/// saddles than the system's have none.
[[nodiscard]] std::vector<Connection> further_of(const ConnectionChoice& choice, const System& system, bool wanted);

/// The connection that was chosen, as the values of its options.
[[nodiscard]] std::vector<OptionSetting> settings_of(const Connection& connection);

}  // namespace lober::detail::table

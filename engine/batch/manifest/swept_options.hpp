// The options that a grid varies.
#pragma once

#include <string>
#include <vector>

#include "engine/batch/manifest/plan.hpp"

namespace lober::detail {

/// An option in which jobs of one operation differ: a column of tables.
struct SweptOption {
  std::string key;
  std::string column;  ///< the key, or "options.KEY" where a column of results has that name
};

/// The options in the order of their keys.
[[nodiscard]] std::vector<SweptOption> swept_options(const Plan& plan, const Operation& operation);

/// "parameters.K=0.9", the values of a group.
[[nodiscard]] std::string swept_values(const std::vector<SweptOption>& swept, const JobGroup& group);

/// The first of the values that groups of the operation have; its type is that of all of them.
[[nodiscard]] const OptionValue& any_value(const SweptOption& swept, const Plan& plan, const Operation& operation);

}  // namespace lober::detail

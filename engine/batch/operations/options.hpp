// The options of a job: those of the operation's table.
#pragma once

#include "lober/operations.hpp"

namespace lober::detail {

using operations::numbers_of;
using operations::Options;
using operations::OptionSetting;
using operations::OptionSpec;
using operations::OptionValue;
using operations::to_string;

/// The options as JSON, where SQL can look into them: {"system": "henon", "parameters": {"k": 1.5}}, keys nested at
/// their dots.
[[nodiscard]] std::string encoded_settings(const Options& options);

}  // namespace lober::detail

// The options of the program in messages of the engine, which knows of none.
#pragma once

#include <string>
#include <string_view>

namespace lober::cli {

/// The message with the option that sets each quantity (engine/base/quantities.hpp) behind it: "a smaller tolerance
/// (--tolerance) goes farther".
[[nodiscard]] std::string with_option_names(std::string_view message);

}  // namespace lober::cli

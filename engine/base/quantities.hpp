// Names in messages for the quantities that a caller can set and whose names differ: members of options in C++ and
// Python, options of the program. So the engine names none of those, and the program puts its option behind each of
// these (cli/program/option_names.hpp).
#pragma once

#include <string_view>

namespace lober::detail::quantity {

inline constexpr std::string_view points = "limit on points";
inline constexpr std::string_view seconds = "limit of seconds";
inline constexpr std::string_view tolerance = "smaller tolerance";
inline constexpr std::string_view saddle = "another saddle";
inline constexpr std::string_view saddles = "each saddle that bounds the well";
inline constexpr std::string_view section = "a section within the well";
inline constexpr std::string_view store = "another store";
inline constexpr std::string_view search = "a search for fixed points";
inline constexpr std::string_view passes = "fewer or smaller passes";

}  // namespace lober::detail::quantity

// Which types are optional ones (private to operations/): fields and options of them may have no value.
#pragma once

#include <optional>
#include <type_traits>

namespace lober::detail::table {

template <typename T>
struct is_optional : std::false_type {};
template <typename T>
struct is_optional<std::optional<T>> : std::true_type {};

}  // namespace lober::detail::table

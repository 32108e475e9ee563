// Numbers and texts appended to a text, by the names that the program uses without more ado.
#pragma once

#include "engine/base/append_text.hpp"

namespace lober::cli {

using detail::append;
using detail::append_all;

}  // namespace lober::cli

// Comparisons of two routes to a quantity.
#pragma once

#include <pybind11/pybind11.h>

#include "lober/base/agreement.hpp"

namespace lober::python {

/// A list of (what, first_by, second_by, first, second, bar), all comparisons.
[[nodiscard]] inline pybind11::list comparisons_of(const Agreement& agreement) {
  pybind11::list list;
  for (const Comparison& c : agreement.comparisons) {
    list.append(pybind11::make_tuple(c.what, c.first_by, c.second_by, c.first, c.second, c.bar));
  }
  return list;
}

}  // namespace lober::python

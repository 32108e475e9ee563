// A tangle for Python, of two curves or grown from a map.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "lober/tangle/tangle.hpp"

namespace lober::python {

/// The tangle that lober/_tangle.py wraps; `keeper` keeps alive the grown manifolds that it may be a view of.
struct TangleHandle {
  Tangle tangle;
  bool smooth = false;
  std::shared_ptr<const void> keeper{};
};

}  // namespace lober::python

// A run of an operation of the table, for Python.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "lober/operations.hpp"

namespace lober::python {

/// A run of an operation. `inputs` keeps alive the arrays that it got, of which the result may hold views.
struct OperationRun {
  const operations::Operation* operation;
  operations::Outcome outcome;
  pybind11::list inputs;
  double seconds;  ///< wall time of the operation alone

  /// The result, for those who know its type. It lives as long as its last pointer, but needs the inputs too: functions
  /// that return it keep the run alive.
  template <typename T>
  [[nodiscard]] std::shared_ptr<const T> value() const {
    return {outcome.value, &outcome.as<T>()};
  }
};

}  // namespace lober::python

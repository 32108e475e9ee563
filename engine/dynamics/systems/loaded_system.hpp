// Systems whose functions are those of a loaded library (private to systems/).
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "lober/dynamics/systems.hpp"
#include "lober/lober_system.h"

namespace lober::detail {

/// The library stays loaded as long as anything made of it.
using Library = std::shared_ptr<void>;

/// Whether no number of a description is infinite or NaN.
inline bool all_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

/// The system for values of its parameters, in their order; the description has no fault. Throws DataError where
/// functions do not belong together (library_checks.hpp) and where connections are not given for these values,
/// UsageError where the period is not positive.
System make_loaded_system(const Library& library, const lober_system& system, std::span<const double> values,
                          const IntegrationOptions& options);

}  // namespace lober::detail

// Inputs of operations: curves, points and systems.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <variant>

#include "lober/base/export.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/point.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/overlay/index.hpp"
#include "lober/overlay/smooth.hpp"

namespace lober::operations {

/// Kind of an input.
enum class InputKind : std::uint8_t {
  closed_curve,
  open_curve,
  curve,  ///< closed or open, as an option says; its segments are not searched
  points,
  system,
};

/// An input of an operation.
struct InputSpec {
  std::string name;                    ///< its name in help texts
  InputKind kind = InputKind::system;  ///< its kind
  std::string meaning;                 ///< a phrase
  bool optional = false;               ///< only the last inputs can be
};

/// A system with its parameters, and a way to change them.
struct SystemInput {
  std::shared_ptr<const System> system;  ///< the system
  IntegrationOptions integration{};      ///< options with which it was made
  ParameterValues given{};               ///< parameters whose values were given; others have the system's own
  /// The same system with other values of some parameters; empty where the parameters cannot be changed.
  std::function<System(const ParameterValues& changed)> with{};
};
/// A built-in system or a library by its name.
[[nodiscard]] LOBER_API SystemInput system_input(const std::string& name, const ParameterValues& values,
                                                 const IntegrationOptions& integration = {});

/// A curve with the facts that are known about it already.
struct CurveInput {
  CurveView curve{};                         ///< the curve
  std::string name{};                        ///< name in messages; empty: that of the InputSpec
  const IndexedCurve* index = nullptr;       ///< index of a curve that is validated
  const DiscretisationSums* sums = nullptr;  ///< sums for the overlay's estimate
  bool simple = false;                       ///< known to be simple
};

/// The points stay the caller's for as long as the operation runs and its value is used. Where an operation takes a
/// curve, points count as a curve.
using Input = std::variant<SystemInput, CurveInput, std::span<const Point>>;

}  // namespace lober::operations

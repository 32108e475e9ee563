// A problem to integrate: a field, how long, and from where.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace lober::bench {

template <typename Field>
using StateOf = std::array<double, static_cast<std::size_t>(Field::dimension)>;

template <typename Field>
struct Problem {
  std::string name;  ///< as make_system takes it, with default parameters
  std::string description;
  Field field;
  double span;  ///< of time, from 0: a period unless the field is autonomous
  std::vector<StateOf<Field>> points;
};

/// Runs one integrator at a tolerance; each point is replaced by where it is after the span of time.
template <typename Field>
using Integration = std::function<void(double tolerance, std::span<StateOf<Field>> points)>;

}  // namespace lober::bench

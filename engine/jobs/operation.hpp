// What a job does. One table of operations; each is a file in operations/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/jobs/options.hpp"
#include "engine/jobs/prepared_curve.hpp"
#include "engine/jobs/record.hpp"

namespace lober {

/// How many curves a job of an operation has.
enum class Arity : std::uint8_t { one, two, one_or_two };

/// A program that feeds the queue may bring its own.
struct Operation {
  std::string name;
  int revision = 1;  ///< goes into the key of results: raise it when the numbers change
  Arity arity = Arity::two;
  std::vector<OptionSpec> options = {};
  std::vector<Column> columns = {};
  std::vector<std::string> lists = {};
  std::function<Needs(const Options&)> needs;
  /// Called from several threads at the same time. `second` is null for a job of one curve. May throw Error.
  std::function<Record(const PreparedCurve& first, const PreparedCurve* second, const Options& options)> run;
  /// Microseconds on one core for so many points, roughly: what comes first is what costs most.
  std::function<double(std::size_t points)> cost;
};

/// The operations that a manifest can name.
[[nodiscard]] std::span<const Operation> all_operations();
[[nodiscard]] const Operation* find_operation(std::string_view name);  ///< null if there is none

}  // namespace lober

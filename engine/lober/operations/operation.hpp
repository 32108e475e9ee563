// An operation: its description and how it is run.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lober/base/agreement.hpp"
#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/operations/fields.hpp"
#include "lober/operations/inputs.hpp"
#include "lober/operations/options.hpp"

namespace lober::operations {

/// Callbacks and limits of a run of an operation. All of them may be left out.
struct Context {
  Progress progress{};  ///< called with the fraction done
  /// Called with `progress`, where the work done can be counted, in a unit such as "points".
  std::function<void(double amount, std::string_view unit)> count{};
  /// Called from the calling thread with each element of a list that takes long as soon as it is ready, and with all
  /// comparisons so far.
  std::function<void(const Field& list, const void* element, const Agreement& agreement)> on_element{};
  /// Called likewise with all that is known so far: the value of the result, without the later parts. By a sweep with
  /// each row, from any thread, one call at a time.
  std::function<void(const void* so_far)> on_part{};
  /// Whether cancelled work returns the part that is known, where an operation can (escape).
  bool keeps_what_is_known = false;
  std::size_t memory = std::numeric_limits<std::size_t>::max();  ///< bytes that the work may hold, roughly
  /// Called with the bytes that the work does hold, where options decide how many; an exception from it ends the work.
  std::function<void(std::size_t bytes)> holds{};
};

/// A result: an object of a type that the operation knows.
struct Outcome {
  std::shared_ptr<const void> value;  ///< the result, of the operation's own type
  Agreement agreement;                ///< comparisons of all routes
  std::vector<std::string> remarks;   ///< remarks that a user should read
  std::string incomplete;             ///< why a part is missing that was asked for; empty if nothing is
  std::string failed;                 ///< which of many independent parts failed and why; empty if none did
  Options options;                    ///< options with which it was computed
  std::vector<OptionSetting> chosen;  ///< in place of some options: values that followed from options and inputs

  /// The options, each with the value that was used.
  [[nodiscard]] LOBER_API std::vector<OptionSetting> settings() const;

  /// For callers that know the type: SystemTransport of "transport".
  template <typename T>
  [[nodiscard]] const T& as() const {
    return *static_cast<const T*>(value.get());
  }
};

/// An example of a call. Each face writes it in its own way.
struct Example {
  std::vector<std::string> inputs;     ///< "standard K=1.2", "a.dat"
  std::vector<OptionSetting> options;  ///< options of the call
  std::string meaning;                 ///< a phrase that says what it shows
};

/// An operation: its description and its function.
struct Operation {
  std::string name;               ///< its name in every face
  std::string title;              ///< a phrase of one line
  std::string summary;            ///< a sentence: "Computes ..."
  int revision = 1;               ///< goes into the keys of stored results: raised when numbers change within a version
  bool compares = true;           ///< whether it computes something by two routes
  std::vector<InputSpec> inputs;  ///< in their order
  std::vector<OptionSpec> options;  ///< in their order
  std::vector<Field> result;        ///< fields of the result
  std::vector<Example> examples;    ///< calls that help texts show
  /// Approximate number of bytes of the data that it makes of its first input, where options decide that; else empty.
  std::function<double(const Input& first, const Options& options)> result_bytes{};
  /// Throws UsageError for options that do not go together, with this number of inputs; `run` asks it first. May be
  /// empty.
  std::function<void(const Options& options, std::size_t inputs)> check{};
  /// Throws UsageError for inputs that do not fit `inputs`, and whatever the functions throw that it calls.
  std::function<Outcome(std::span<const Input> inputs, const Options& options, const Context& context)> run;
};

/// All operations in the order of their names.
[[nodiscard]] LOBER_API std::span<const Operation> all();
/// The operation with this name. Throws UsageError that lists the existing ones.
[[nodiscard]] LOBER_API const Operation& named(std::string_view name);

}  // namespace lober::operations

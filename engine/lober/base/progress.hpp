// Progress of a computation, reported to its caller, who may end it.
#pragma once

#include <concepts>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace lober {

/// A function of the caller's, called several times a second and by one thread at a time with how far the work is: the
/// fraction done, NaN where it is not known, and a line about the step being done, empty where there is none. It
/// returns whether to go on; false ends the work with Cancelled. A Progress is made of any function of a fraction, of a
/// line, or of both:
///
///   options.progress = [](double fraction) { return show(fraction), true; };
class Progress {
 public:
  Progress() = default;
  /// Takes a function of a fraction, of a line, or of both, that returns whether to go on.
  template <typename Function>
  requires(!std::same_as<std::remove_cvref_t<Function>, Progress> &&
           (std::predicate<Function&, double, const std::string&> || std::predicate<Function&, double> ||
            std::predicate<Function&, const std::string&>))
      Progress(Function function) {  // NOLINT(google-explicit-constructor): options are set to lambdas
    if constexpr (requires { typename Function::result_type; }) {
      if (!function) return;  // an empty std::function
    }
    if constexpr (std::predicate<Function&, double, const std::string&>) {
      function_ = std::move(function);
    } else if constexpr (std::predicate<Function&, double>) {
      function_ = [call = std::move(function)](double fraction, const std::string&) mutable { return call(fraction); };
    } else {
      function_ = [call = std::move(function)](double, const std::string& line) mutable { return call(line); };
    }
  }

  /// Whether there is a function.
  explicit operator bool() const { return static_cast<bool>(function_); }
  /// Whether to go on: without a function, always.
  bool operator()(double fraction, const std::string& line = {}) const {
    return !function_ || function_(fraction, line);
  }
  /// Whether to go on: a line without a fraction.
  bool operator()(const std::string& line) const { return (*this)(std::numeric_limits<double>::quiet_NaN(), line); }

 private:
  std::function<bool(double fraction, const std::string& line)> function_;
};

}  // namespace lober

// How far a computation is: told to its caller, who may end it.
#pragma once

#include <concepts>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace lober {

/// A function of the caller's that is told how far the work is, several times a second and by one thread at a time: the
/// fraction done, NaN where it is not known, and a line of what is being done, empty where there is none. Whether to go
/// on is what it returns; false ends the work with Cancelled. Made of any function of a fraction, of a line, or of
/// both:
///
///   options.progress = [](double fraction) { return show(fraction), true; };
class Progress {
 public:
  Progress() = default;
  template <typename Told>
  requires(!std::same_as<std::remove_cvref_t<Told>, Progress> &&
           (std::predicate<Told&, double, const std::string&> || std::predicate<Told&, double> ||
            std::predicate<Told&, const std::string&>))
      Progress(Told told) {  // NOLINT(google-explicit-constructor): options are set to lambdas
    if constexpr (requires { typename Told::result_type; }) {
      if (!told) return;  // an empty std::function
    }
    if constexpr (std::predicate<Told&, double, const std::string&>) {
      told_ = std::move(told);
    } else if constexpr (std::predicate<Told&, double>) {
      told_ = [told = std::move(told)](double fraction, const std::string&) mutable { return told(fraction); };
    } else {
      told_ = [told = std::move(told)](double, const std::string& line) mutable { return told(line); };
    }
  }

  /// Whether there is anyone to tell.
  explicit operator bool() const { return static_cast<bool>(told_); }
  /// Whether to go on: where nobody is told, always.
  bool operator()(double fraction, const std::string& line = {}) const { return !told_ || told_(fraction, line); }
  bool operator()(const std::string& line) const { return (*this)(std::numeric_limits<double>::quiet_NaN(), line); }

 private:
  std::function<bool(double fraction, const std::string& line)> told_;
};

}  // namespace lober

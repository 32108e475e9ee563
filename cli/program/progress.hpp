// The progress of a command (running.hpp says to whom it is shown).
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "cli/program/progress_text.hpp"

namespace lober::cli {

class Progress {
 public:
  Progress();
  ~Progress();  ///< what comes after it is the phase "writing", unless by an exception
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A phase begins; it is the part from `begin` to `end`, fractions of the whole. In the phases "reading" and
  /// "writing" the file that is read or written is named. Throws Cancelled after an interrupt from the keyboard.
  void phase(std::string_view name, double begin, double end);

  /// How far the phase is, from 0 to 1. Returns false when the user has interrupted.
  bool advance(double fraction);

  /// File k, from 0, of `files` of about the same size is read next: the phase is as far as they are.
  void file(std::size_t k, std::size_t files);

  /// How much is done by now, for example of points; the line reports the rate too.
  void count(double amount, std::string_view unit);
  /// The same from now on by the fraction of the whole, which has that total.
  void of(double total, std::string_view unit);

  /// The name of the phase from now on, for example with the number of failures so far.
  void label(std::string_view what);

  /// A step has begun, one of a sequence whose length nobody knows but whose members grow about evenly; nothing new
  /// when it has no name. Returns as `advance`.
  bool step(std::string_view what);

 private:
  double begin_ = 0, end_ = 0, total_ = 0;
  std::string_view total_unit_;
  int exceptions_;
};

/// The progress of an operation: lines where nobody knows how much there is to do.
[[nodiscard]] std::function<bool(double fraction, const std::string& line)> told_to(Progress& progress);

}  // namespace lober::cli

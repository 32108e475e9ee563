// A progress bar on standard error, for people: only on a terminal, and only for work that takes more than a
// second.
#pragma once

#include <atomic>
#include <memory>
#include <string_view>

namespace lober::cli {

class Progress {
 public:
  Progress();
  ~Progress();  ///< wipes the bar away
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A phase begins; it takes the bar from `begin` to `end`, fractions of the whole. Throws Cancelled after
  /// an interrupt from the keyboard (the first one asks, a second one kills).
  void phase(std::string_view name, double begin, double end);

  /// How far the phase is, from 0 to 1. Returns false when the user has interrupted.
  bool advance(double fraction);

 private:
  class Ticker;
  double begin_ = 0, end_ = 0;
  std::unique_ptr<Ticker> ticker_;  ///< none unless standard error is a terminal
};

}  // namespace lober::cli

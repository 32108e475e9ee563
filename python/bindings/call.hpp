// Long calls: without the GIL, ended by Ctrl-C, with progress told to a Python callable.
#pragma once

#include <pybind11/pybind11.h>
#include <signal.h>

#include <atomic>
#include <optional>
#include <string>
#include <utility>

#include "lober/base/cancellation.hpp"
#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"

namespace lober::python {

/// While it lives, SIGINT sets a flag and then does what it did before. Python's own handler takes effect between
/// bytecodes of the main thread only, so that long work would never hear of it. Does nothing where signals do not reach
/// the main thread's Python: in other threads, and where SIGINT is ignored or not handled. Made and destroyed with the
/// GIL.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] const std::atomic<bool>& flag() const { return flag_; }
  /// Throws the KeyboardInterrupt, or what else the handler of the signal raises, if there was one.
  void raise() const;
  /// The same for work that the signal has cancelled: KeyboardInterrupt where the handler raises nothing.
  void raise_cancelled() const;

 private:
  std::atomic<bool> flag_{false};
  std::atomic<bool>* around_ = nullptr;  // the flag of the call that this one is a part of
  bool watching_ = false, installed_ = false;
};

/// The result of work(), which gets `threads` threads at most (0: one for each core). Work that was cancelled by a
/// signal throws what the signal raises.
template <typename Work>
auto long_call(int threads, Work&& work) {
  const Interrupt interrupt;
  const auto run = [&] {
    const pybind11::gil_scoped_release released;
    const CancellationScope scope(interrupt.flag());
    std::optional<decltype(work())> result;
    run_with_threads(threads, [&] { result.emplace(work()); });
    return std::move(*result);
  };
  try {
    auto result = run();
    interrupt.raise();  // for results that hold what was done before
    return result;
  } catch (const Cancelled&) {
    interrupt.raise_cancelled();
    throw;
  } catch (const pybind11::error_already_set& error) {
    // A Python function that asked, as long ones do (check_cancelled).
    if (error.matches(pybind11::module_::import("lober.errors").attr("Cancelled"))) interrupt.raise_cancelled();
    throw;
  }
}

/// A callable progress(fraction, text), either of which may be None, or None. It is called with the GIL; returning
/// False cancels, anything else goes on.
class ProgressCallback {
 public:
  explicit ProgressCallback(const pybind11::object& callable) : callable_(callable) {}
  [[nodiscard]] bool given() const { return !callable_.is_none(); }

  bool operator()(double fraction) const;
  bool operator()(const std::string& text) const;
  bool operator()(double fraction, const std::string& text) const;

 private:
  const pybind11::object& callable_;  // outlives the call, in which nobody else touches its count
};

}  // namespace lober::python

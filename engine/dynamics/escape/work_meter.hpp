// The work that trajectories take, counted in all threads, and its end (private to escape/).
#pragma once

#include <atomic>
#include <cstdint>

#include "engine/base/work_limit.hpp"

namespace lober::detail {

class WorkMeter {
 public:
  explicit WorkMeter(double most) : most_(most) {}

  void add(std::uint64_t tenths) { tenths_.fetch_add(tenths, std::memory_order_relaxed); }
  /// In units of PlanarMap::work.
  [[nodiscard]] double done() const { return static_cast<double>(tenths_.load(std::memory_order_relaxed)) / 10; }
  [[nodiscard]] bool spent() const { return done() > most_; }
  void limit_to(double most) { most_ = most; }

  /// Runs the function, whose progress is to say no once this is spent. False if it took too much: the same answer for
  /// any number of threads, whenever they happened to look. Throws what it throws, Cancelled for other reasons.
  template <typename Function>
  [[nodiscard]] bool within(const Function& function) {
    return completes(function, [this] { return spent(); }) && !spent();
  }

 private:
  std::atomic<std::uint64_t> tenths_{0};
  double most_;
};

}  // namespace lober::detail

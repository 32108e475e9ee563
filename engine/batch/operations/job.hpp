// A job: an operation with its options on no curve, on one, or on two.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/batch/operations/options.hpp"
#include "lober/curve/periods.hpp"

namespace lober::detail {

struct Operation;
class OutputFolder;

/// The number of a curve, in a plan or in a queue.
using CurveId = std::uint32_t;
inline constexpr CurveId no_curve = 0xffffffff;

/// The curves of a job: none, one or two.
class CurvePair {
 public:
  CurvePair(CurveId first, CurveId second)
      : ids_{first, second},
        count_(first == no_curve    ? 0U
               : second == no_curve ? 1U
                                    : 2U) {}
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] CurveId operator[](std::size_t k) const { return ids_[k]; }
  [[nodiscard]] const CurveId* begin() const { return ids_.data(); }
  [[nodiscard]] const CurveId* end() const { return ids_.data() + count_; }

 private:
  std::array<CurveId, 2> ids_;
  std::size_t count_;
};

/// The common part of many jobs.
struct JobGroup {
  std::string name;                      ///< in exports; may be empty
  const Operation* operation = nullptr;  ///< has to outlive the group
  Options options;
  const OutputFolder* outputs = nullptr;  ///< where its jobs may write files; null: anywhere
  Periods periods = {};                   ///< by which the second curve is moved to the first
};

/// A job of a group, which counts by its number in the plan or in the queue that the job belongs to.
struct Job {
  std::uint32_t group = 0;
  CurveId first = no_curve, second = no_curve;  ///< no_curve where the job has none
  [[nodiscard]] CurvePair curves() const { return {first, second}; }
};

}  // namespace lober::detail

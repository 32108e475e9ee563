// What a result is a result of.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "engine/batch/operation.hpp"
#include "engine/batch/plan.hpp"

namespace lober {

/// SHA-256 of the contents of the inputs, the operation with its revision, the options and the version of the engine.
/// Two jobs with the same key have the same result, so one of them is enough.
using JobKey = std::array<std::byte, 32>;

struct HashOfKey {
  std::size_t operator()(const JobKey& key) const {
    std::size_t word = 0;
    for (std::size_t k = 0; k < sizeof(word); ++k) word = word << 8 | std::to_integer<std::size_t>(key[k]);
    return word;
  }
};

/// Of the jobs of a plan, `digest(curve)` being the digest of a curve's contents, or empty if it cannot be read: then
/// the key is that of the failure, which goes by the name.
class JobKeys {
 public:
  explicit JobKeys(const Plan& plan);
  [[nodiscard]] JobKey operator()(const PlannedJob& job, std::string_view digest1, std::string_view digest2) const;

 private:
  const Plan& plan_;
  std::vector<std::string> beginnings_;  ///< by group: what is the same for all its jobs, as a digest
};

}  // namespace lober

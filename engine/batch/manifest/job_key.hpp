// What a result is a result of.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/operations/operation.hpp"

namespace lober::detail {

/// SHA-256 of the content of each input, by CurveSource::input_name.
using InputDigests = std::map<std::string, std::string>;
/// Those of the curves of the plan, null where none is known. They point into `inputs`.
[[nodiscard]] std::vector<const std::string*> digests_by_curve(const Plan& plan, const InputDigests& inputs);

/// SHA-256 of the contents of the inputs, the operation with its revision, the options and the version of the engine.
/// Two jobs with the same key have the same result, so one of them is enough. Digests are those of the contents, or
/// empty for what cannot be read: then the key is that of the failure, which goes by the name.
class JobKeys {
 public:
  explicit JobKeys(const Plan& plan);
  [[nodiscard]] JobKey operator()(const Job& job, std::string_view digest1, std::string_view digest2) const;
  /// With the digests of all curves of the plan; none if those of the job are not known (null).
  [[nodiscard]] std::optional<JobKey> find(const Job& job, std::span<const std::string* const> digests) const;

 private:
  const Plan& plan_;
  std::vector<std::string> beginnings_;  ///< by group: what is the same for all its jobs, as a digest
};

}  // namespace lober::detail

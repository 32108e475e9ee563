// Keys of results: the inputs and options that a result follows from.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
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
/// The digests of the curves of the plan, null where none is known. They point into `inputs`.
[[nodiscard]] std::vector<const std::string*> digests_by_curve(const Plan& plan, const InputDigests& inputs);

/// SHA-256 of the contents of the inputs, the operation with its revision, the options and the version of the engine.
/// Two jobs with the same key have the same result, so one of them is enough. Digests are those of the contents, or
/// empty for an input that cannot be read: then the key is that of the failure, which goes by the name.
class JobKeys {
 public:
  explicit JobKeys(const Plan& plan);
  [[nodiscard]] JobKey operator()(const Job& job, std::string_view digest1, std::string_view digest2) const;
  /// The key by the digests of all curves of the plan; none if those of the job are not known (null).
  [[nodiscard]] std::optional<JobKey> find(const Job& job, std::span<const std::string* const> digests) const;

 private:
  struct Beginning;
  const Plan& plan_;
  std::shared_ptr<const std::vector<Beginning>> beginnings_;  ///< by group
};

}  // namespace lober::detail

#include "engine/batch/manifest/job_key.hpp"

#include "engine/batch/operations/provenance.hpp"
#include "engine/files/sha256.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"

namespace lober::detail {

std::vector<const std::string*> digests_by_curve(const Plan& plan, const InputDigests& inputs) {
  std::vector<const std::string*> digests;
  for (const CurveSource& curve : plan.curves) {
    const auto at = inputs.find(curve.input_name());
    digests.push_back(at == inputs.end() ? nullptr : &at->second);
  }
  return digests;
}

JobKeys::JobKeys(const Plan& plan) : plan_(plan) {
  for (const JobGroup& group : plan.groups) {
    const std::string text = "lober " + std::string(engine_version()) + '\n' + group.operation->name + ' ' +
                             std::to_string(group.operation->revision) + '\n' + group.options.to_string() + '\n';
    beginnings_.push_back(sha256(std::as_bytes(std::span(text))));  // short, as it is hashed again for each job
  }
}

JobKey JobKeys::operator()(const Job& job, std::string_view digest1, std::string_view digest2) const {
  std::string text;
  text.reserve(256);
  text += beginnings_[job.group];
  const auto add = [&](CurveId curve, std::string_view digest) {
    if (curve == no_curve) return;
    if (digest.empty()) text += "unreadable " + plan_.curves[curve].name();
    text += digest;
    text += '\n';
  };
  add(job.first, digest1);
  add(job.second, digest2);
  return sha256_bytes(std::as_bytes(std::span(text)));
}

std::optional<JobKey> JobKeys::find(const Job& job, std::span<const std::string* const> digests) const {
  std::array<std::string_view, 2> of_job;
  for (std::size_t k = 0; k < job.curves().size(); ++k) {
    const std::string* const digest = digests[job.curves()[k]];
    if (digest == nullptr) return std::nullopt;
    of_job[k] = *digest;
  }
  return (*this)(job, of_job[0], of_job[1]);
}

}  // namespace lober::detail

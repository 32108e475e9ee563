#include "engine/batch/manifest/job_key.hpp"

#include <nettle/sha2.h>

#include <utility>

#include "engine/batch/operations/provenance.hpp"
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

namespace {

void hash_text(sha256_ctx& hash, std::string_view text) {
  sha256_update(&hash, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
}

}  // namespace

// The common part of the jobs of a group is hashed once. It goes in as a digest, which is as long as a block of the
// hash, so that it costs the jobs nothing.
struct JobKeys::Beginning {
  sha256_ctx hash;
};

JobKeys::JobKeys(const Plan& plan) : plan_(plan) {
  std::vector<Beginning> beginnings;
  for (const JobGroup& group : plan.groups) {
    const std::string text = "lober " + std::string(engine_version()) + '\n' + group.operation->name + ' ' +
                             std::to_string(group.operation->revision) + '\n' + group.options.to_string() + '\n';
    sha256_init(&beginnings.emplace_back().hash);
    hash_text(beginnings.back().hash, sha256(std::as_bytes(std::span(text))));
  }
  beginnings_ = std::make_shared<const std::vector<Beginning>>(std::move(beginnings));
}

JobKey JobKeys::operator()(const Job& job, std::string_view digest1, std::string_view digest2) const {
  sha256_ctx hash = (*beginnings_)[job.group].hash;
  const auto add_input = [&](CurveId curve, std::string_view digest) {
    if (curve == no_curve) return;
    if (digest.empty()) hash_text(hash, "unreadable " + plan_.curves[curve].name());
    hash_text(hash, digest);
    hash_text(hash, "\n");
  };
  add_input(job.first, digest1);
  add_input(job.second, digest2);
  JobKey key;
  sha256_digest(&hash, key.size(), reinterpret_cast<std::uint8_t*>(key.data()));
  return key;
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

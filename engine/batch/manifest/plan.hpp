// The jobs of a manifest, one by one: the manifest with its patterns, pairs and grids written out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/batch/manifest/curve_source.hpp"
#include "engine/batch/manifest/manifest.hpp"
#include "engine/batch/operations/job.hpp"
#include "lober/batch.hpp"

namespace lober::detail {

/// A pure function of the manifest and of the names of the files that its patterns match: every process that reads them
/// has the same plan. Jobs are numbered as they stand here.
struct Plan {
  std::vector<JobGroup> groups;
  std::vector<CurveSource> curves;
  std::vector<Job> jobs;

  [[nodiscard]] const JobGroup& group_of(const Job& job) const { return groups[job.group]; }
  /// The name of a curve; empty for no_curve.
  [[nodiscard]] std::string name(CurveId curve) const { return curve == no_curve ? "" : curves[curve].name(); }
  /// Whether some jobs may write files.
  [[nodiscard]] bool may_write() const;
  /// The name of the file that a job writes; empty for none.
  [[nodiscard]] std::string output_of(const Job& job) const;
  /// The plan as CBOR: the same bytes for the same plan.
  [[nodiscard]] std::string encoded() const;
  /// Throws DataError for bytes that are not a plan, among them those of one that names groups or curves which it does
  /// not have; UsageError for operations and options that this version does not have.
  [[nodiscard]] static Plan decoded(std::string_view bytes);
};

/// Throws UsageError for patterns that match nothing and for groups without a pair. Reads only files of which all zones
/// are wanted.
[[nodiscard]] Plan make_plan(const Manifest& manifest);

/// The jobs of a shard: of each group its share, a run of jobs that follow each other, so that a shard reads few
/// curves. Depends on nothing but the plan. Throws UsageError for a shard that does not exist.
[[nodiscard]] std::vector<std::uint32_t> jobs_of(const Plan& plan, Shard shard);

/// The curves of these jobs, those together that are read together; in the order of the plan.
[[nodiscard]] std::vector<std::vector<CurveId>> units_of(const Plan& plan, std::span<const std::uint32_t> jobs);
/// The sources of the curves of a unit.
[[nodiscard]] std::vector<CurveSource> sources_of(const Plan& plan, std::span<const CurveId> unit);

/// Points of each curve, from the sizes of the files; zones of a file are taken for equal, and what has to be computed
/// is a guess.
[[nodiscard]] std::vector<std::size_t> estimated_points(const Plan& plan, const std::string& manifest_path);

/// The amount of work, before anything was read or, but for pilots, computed.
struct Estimate {
  std::size_t jobs = 0, curves = 0, files = 0;
  std::size_t computed = 0;          ///< units that are no files: their points are a guess
  std::uint64_t points = 0;          ///< points of the curves, each once
  std::uint64_t points_in_jobs = 0;  ///< each as often as it is used
  std::size_t memory = 0;            ///< bytes of all curves with their indexes
  double core_seconds = 0;           ///< seconds of one core, reading included
  std::size_t pilots = 0;            ///< short jobs that were run to see how long jobs take
};
/// At once, but for some seconds at most that pilots take (pilots.hpp).
[[nodiscard]] Estimate estimate(const Plan& plan, const std::string& manifest_path);

}  // namespace lober::detail

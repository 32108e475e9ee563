// The jobs of a manifest, one by one: what is left of it when patterns, pairs and grids are written out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/jobs/curve_cache.hpp"
#include "engine/jobs/manifest.hpp"

namespace lober {

struct PlannedCurve {
  std::uint32_t file = 0;  ///< number of the file
  std::int64_t zone = -1;  ///< -1: the only one
  bool closed = true;
  std::string name;  ///< FILE or FILE#K, as the manifest's patterns spell the path
};

/// Jobs that share operation and options.
struct PlannedGroup {
  std::string name;
  std::string operation;
  std::vector<std::pair<std::string, std::string>> options;  ///< as spelled
  [[nodiscard]] std::string spelled() const;                 ///< "key=value key=value"
};

struct PlannedJob {
  std::uint32_t group = 0;
  CurveId first = 0, second = no_curve;
};

/// A pure function of the manifest and of the names of the files that its patterns match: every process that reads them
/// has the same plan. Jobs are numbered as they stand here.
struct Plan {
  std::vector<PlannedGroup> groups;
  std::vector<std::string> files;
  std::vector<PlannedCurve> curves;
  std::vector<PlannedJob> jobs;

  [[nodiscard]] std::string encoded() const;
  [[nodiscard]] static Plan decoded(std::string_view bytes);
};

/// Throws UsageError for patterns that match nothing and for groups without a pair. Reads only files of which all zones
/// are wanted.
[[nodiscard]] Plan make_plan(const Manifest& manifest);

/// The options of a planned group as its operation reads them. Throws UsageError when this version has no such
/// operation.
[[nodiscard]] const Operation& operation_of(const PlannedGroup& group);
[[nodiscard]] Options options_of(const PlannedGroup& group);

/// One of several processes or machines that share a plan.
struct Shard {
  std::size_t number = 0, of = 1;
};
/// The jobs of a shard: of each group its share, a run of jobs that follow each other, so that a shard reads few
/// curves. Depends on nothing but the plan.
[[nodiscard]] std::vector<std::uint32_t> jobs_of(const Plan& plan, Shard shard);

/// The files with the zones that are used, for a queue; `ids` are the CurveIds of the plan's curves in that queue, to
/// be filled by the order in which the units list them.
struct PlannedUnit {
  std::uint32_t file;
  std::vector<CurveId> curves;  ///< of the plan
};
[[nodiscard]] std::vector<PlannedUnit> units_of(const Plan& plan, std::span<const std::uint32_t> jobs);
[[nodiscard]] CurveUnit make_unit(const Plan& plan, const PlannedUnit& unit, const std::string& manifest_path);

/// Points of each curve, from the sizes of the files; zones of a file are taken for equal.
[[nodiscard]] std::vector<std::size_t> estimated_points(const Plan& plan, const std::string& manifest_path);

/// How much there is to do, before anything was read.
struct Estimate {
  std::size_t jobs = 0, curves = 0, files = 0;
  std::uint64_t points = 0;          ///< of the curves, each once
  std::uint64_t points_in_jobs = 0;  ///< each as often as it is used
  std::size_t memory = 0;            ///< bytes of all curves with their indexes
  double core_seconds = 0;           ///< of one core, reading included
};
[[nodiscard]] Estimate estimate(const Plan& plan, const std::string& manifest_path);

}  // namespace lober

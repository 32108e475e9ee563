// The jobs of a manifest, one by one: what is left of it when patterns, pairs and grids are written out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/batch/curve_cache.hpp"
#include "engine/batch/manifest.hpp"
#include "lober/batch.hpp"

namespace lober {

/// Where curves come from: a file, a recipe without a file, or images of the curves of a file.
struct PlannedSource {
  std::string file;  ///< as the manifest's patterns spell the path; empty for a manifold
  std::optional<CurveRecipe> recipe = {};
};

struct PlannedCurve {
  std::uint32_t source = 0;  ///< its number
  std::int64_t zone = -1;    ///< of the file; -1: the only one
  bool closed = true;
  std::string name;  ///< FILE or FILE#K, or how it is made
};

/// Jobs that share operation and options.
struct PlannedGroup {
  std::string name;
  std::string operation;
  std::vector<OptionSetting> options;           ///< all of them, with their types
  [[nodiscard]] std::string to_string() const;  ///< "key=value key=value"
};

struct PlannedJob {
  std::uint32_t group = 0;
  CurveId first = no_curve, second = no_curve;
  [[nodiscard]] CurvePair curves() const { return {first, second}; }
};

/// A pure function of the manifest and of the names of the files that its patterns match: every process that reads them
/// has the same plan. Jobs are numbered as they stand here.
struct Plan {
  std::vector<PlannedGroup> groups;
  std::vector<PlannedSource> sources;
  std::vector<PlannedCurve> curves;
  std::vector<PlannedJob> jobs;

  /// Of a curve; empty for no_curve.
  [[nodiscard]] std::string name(CurveId curve) const { return curve == no_curve ? "" : curves[curve].name; }
  [[nodiscard]] std::string encoded() const;
  /// Throws DataError for bytes that are no plan, among them those of one that names groups, sources or curves which it
  /// does not have.
  [[nodiscard]] static Plan decoded(std::string_view bytes);
};

/// Throws UsageError for patterns that match nothing and for groups without a pair. Reads only files of which all zones
/// are wanted.
[[nodiscard]] Plan make_plan(const Manifest& manifest);

/// The options of a planned group as its operation reads them. Throws UsageError when this version has no such
/// operation or option.
[[nodiscard]] const Operation& operation_of(const PlannedGroup& group);
[[nodiscard]] Options options_of(const PlannedGroup& group);

/// The jobs of a shard: of each group its share, a run of jobs that follow each other, so that a shard reads few
/// curves. Depends on nothing but the plan.
[[nodiscard]] std::vector<std::uint32_t> jobs_of(const Plan& plan, Shard shard);

/// The sources with those of their curves that are used, for a queue.
struct PlannedUnit {
  std::uint32_t source;
  std::vector<CurveId> curves;  ///< of the plan
};
[[nodiscard]] std::vector<PlannedUnit> units_of(const Plan& plan, std::span<const std::uint32_t> jobs);
[[nodiscard]] CurveUnit make_unit(const Plan& plan, const PlannedUnit& unit, const std::string& manifest_path);
/// The digests of its curves as they are now, as the CurveUnit would give them. Throws DataError when the file cannot
/// be read.
[[nodiscard]] std::vector<std::string> digests_of(const Plan& plan, const PlannedUnit& unit,
                                                  const std::string& manifest_path);

/// Points of each curve, from the sizes of the files; zones of a file are taken for equal, and what has to be computed
/// is a guess.
[[nodiscard]] std::vector<std::size_t> estimated_points(const Plan& plan, const std::string& manifest_path);

/// How much there is to do, before anything was read.
struct Estimate {
  std::size_t jobs = 0, curves = 0, files = 0;
  std::size_t computed = 0;          ///< sources that are no files: their points are a guess
  std::uint64_t points = 0;          ///< of the curves, each once
  std::uint64_t points_in_jobs = 0;  ///< each as often as it is used
  std::size_t memory = 0;            ///< bytes of all curves with their indexes
  double core_seconds = 0;           ///< of one core, reading included
};
[[nodiscard]] Estimate estimate(const Plan& plan, const std::string& manifest_path);

}  // namespace lober

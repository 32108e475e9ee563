// Results on disk: one SQLite file in WAL mode, safe against being killed at any moment and against other processes.
//
// People ask it with SQL, while a batch runs and afterwards:
//
//   sqlite3 pairs.results "SELECT curve1, curve2, area FROM overlaps WHERE crossings > 0"
//
//   overlaps, interiors, tangles, densified, transports
//             a row for each job of the newest plan that is done: job, group, options, settings (the options as JSON),
//             curve1, curve2, the values, named as in exports (and `area`, the intersection), lists (JSON, see
//             result.hpp), seconds
//   results   a row for each job of the newest plan that is done or has failed: status, message, ...
//   failures  those that failed
//   runs      who computed, when, with what (provenance) and from which manifest
//
// Behind these views:
//
//   plan               the newest plan: exports and views follow it
//   groups             its groups of jobs
//   curves             the digest of each input of that plan as it was last read; '' for one that could not be
//   results_OPERATION  a row for each key: the job that it is the result of, run, seconds, message of a failure, values
//   repeats            further jobs with the same key: of inputs with the same contents
//
// Committed results stay: a job whose key is there is never computed again. Rows of jobs that no plan names any more
// stay too; a plan that names them again finds them.
//
// Plan, digests and results carry checksums, which exports and runs verify whenever they read: what does not match its
// checksum counts as not there. A file in which not even the tables hold together can be read as far as that goes, and
// `merge` takes over the readable rows; nothing is written to it any more.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "engine/batch/manifest/job_key.hpp"
#include "engine/batch/operations/provenance.hpp"
#include "engine/batch/store/database.hpp"
#include "engine/batch/store/key_map.hpp"
#include "engine/batch/store/result_table.hpp"
#include "engine/batch/store/store_file.hpp"
#include "lober/base/progress.hpp"

namespace lober::detail {

class Store {
 public:
  /// Opens or creates. Throws DataError when the file is not a store, or is one of another format, UsageError for a
  /// name that is not that of a file.
  [[nodiscard]] static Store create(const std::string& path) { return {path, true}; }
  /// Throws DataError when there is none.
  [[nodiscard]] static Store open(const std::string& path) { return {path, false}; }

  /// Notes a new run and makes `plan` the one that exports and views follow. Throws DataError when the tables of the
  /// file do not hold together: O(size) when there are results already.
  void begin_run(const Provenance& who, int threads, const Manifest& manifest, const std::string& shard, Plan plan);
  /// For a plan whose inputs have these digests now, or else those that they had: makes the views show the results that
  /// hold, and no others.
  void show(const InputDigests& inputs);
  /// Throws DataError as `append` does.
  void end_run(const std::string& how);

  /// The plan; none if there never was one. Throws DataError for one that is damaged.
  [[nodiscard]] std::optional<Plan> plan() const;
  /// Without those that are damaged.
  [[nodiscard]] InputDigests digests() const;

  struct Known {
    std::int64_t row;
    std::uint32_t job;    ///< job of the newest plan; no_job for none
    std::uint32_t table;  ///< the operation, by its number
    bool failed;
    bool damaged = false;  ///< to be replaced by anything
    bool foreign = false;  ///< committed by another process since the run began
  };
  using StoredResults = KeyMap<Known>;
  /// All results that are committed, as of the last `refresh` or `append`. Their values were not looked at.
  [[nodiscard]] const StoredResults& stored() const { return known_; }
  void refresh();
  /// None when it is damaged.
  [[nodiscard]] std::optional<Result> result(const Known& known) const;
  /// From now on the result with this key counts as not there: `append` puts another one into its place.
  void discard(const JobKey& key);
  /// Whether parts of the file cannot be reached.
  [[nodiscard]] bool damaged() const { return damaged_; }
  [[nodiscard]] const std::string& path() const { return path_; }

  /// Results of the plan of `begin_run`, in one transaction. Results that are there already, from whatever process, are
  /// left out; a failure gives way to anything. Throws DataError when it cannot be written, and, as `require_in_place`,
  /// when the file is not in its place any more; its results have then been saved (store_file.hpp).
  void append(std::span<const Result> results, const InputDigests& digests);
  /// Number of results given to `append` that were left out because another process had stored them since `begin_run`.
  [[nodiscard]] std::size_t stored_meanwhile() const { return stored_meanwhile_; }
  void require_in_place() const { file_->require_in_place(*database_); }

  struct Run {
    std::int64_t id;
    std::string started, ended, how, version, commit, compiler, flags, host, shard, manifest;
    std::string folder;  ///< folder of the manifest: names of curves are relative to it
    int threads;
    /// Whether both are one run, of which one may have been noted before it had ended.
    [[nodiscard]] bool is_same(const Run& other) const {
      return std::tie(started, version, commit, host, shard, manifest, folder, threads) ==
             std::tie(other.started, other.version, other.commit, other.host, other.shard, other.manifest, other.folder,
                      other.threads);
    }
  };
  [[nodiscard]] std::vector<Run> runs() const;

  /// Takes over what other stores have, and returns the numbers of those in which results are damaged; these are left
  /// out. Throws DataError when the plans differ or the same input was read with different contents, Cancelled. One
  /// transaction: all of it, or nothing.
  std::vector<std::size_t> merge(std::span<const Store> others, const Progress& progress = {});

 private:
  class NewResults;
  Store(const std::string& path, bool create);
  bool check_format(bool create);
  void read_known(std::uint32_t table, bool backwards);
  void require_whole();
  void put_plan(const Plan& plan);
  [[nodiscard]] bool shows_plan() const;
  void put_digests(const InputDigests& digests);
  void put_run(const Run& run);
  [[nodiscard]] std::uint32_t table_of(const Plan& plan, std::uint32_t job) const;
  void put(std::uint32_t table, const Result& result, bool shown);
  void put(Known& known, bool absent, std::uint32_t table, const Result& result, bool shown);
  [[nodiscard]] bool take_over(const Store& other, const Progress& progress);
  void put_repeat(std::uint32_t job, const Known& known);
  void label_rows(const InputDigests& inputs);

  std::string path_;
  std::unique_ptr<StoreFile> file_;
  std::unique_ptr<Database> database_;
  std::vector<ResultTable> tables_;      ///< in the order of all_operations
  std::vector<std::int64_t> last_rows_;  ///< last row of each table that was read
  StoredResults known_;
  std::optional<Statement> version_;
  std::int64_t known_version_ = -1;  ///< version of the file that `known_` has
  std::optional<Plan> plan_;         ///< plan of this run
  bool plan_is_new_ = false;         ///< rows may still bear the names of another one
  std::int64_t run_ = 0, plan_sum_ = 0;
  std::size_t stored_meanwhile_ = 0;
  bool damaged_ = false;
};

}  // namespace lober::detail

// Results on disk: one SQLite file in WAL mode, safe against being killed at any moment and against other processes.
//
//   runs     who computed, when, with what (provenance) and from which manifest
//   plan     the newest plan: exports follow it
//   curves   the digest of each input of that plan as it was last read; '' for one that could not be
//   results  key, status (0 done, 1 failed), seconds, value (record.hpp) or message; one row a key
//
// What is committed stays: a job whose key is there is never computed again. Rows of jobs that no plan names any more
// stay too; a plan that names them again finds them.
//
// Plan, digests and results carry checksums, which are verified whenever they are read: what does not match its
// checksum counts as not there. A file in which not even the tables hold together can be read as far as that goes, and
// `merge` takes over what can be read; nothing is written to it any more.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/batch/database.hpp"
#include "engine/batch/job_key.hpp"
#include "engine/batch/provenance.hpp"
#include "engine/batch/store_file.hpp"

namespace lober {

struct StoredResult {
  JobKey key;
  bool failed = false;
  double seconds = 0;
  std::string value;  ///< an encoded Record, or the message of a failure
  std::int64_t run = 0;
};

/// Digests by input; see `input_name`.
using InputDigests = std::map<std::string, std::string>;
/// What the table `curves` calls a curve: open and closed are different inputs.
[[nodiscard]] std::string input_name(const PlannedCurve& curve);

class Store {
 public:
  /// Opens or creates. Throws DataError when the file is no store, or one of another format, UsageError for a name that
  /// is not that of a file.
  [[nodiscard]] static Store create(const std::string& path) { return {path, true}; }
  /// Throws DataError when there is none.
  [[nodiscard]] static Store open(const std::string& path) { return {path, false}; }

  /// Notes a new run and makes `plan` the one that exports follow. Throws DataError when the tables of the file do not
  /// hold together: O(size) when there are results already.
  void begin_run(const Provenance& who, int threads, const std::string& manifest, const std::string& shard,
                 const Plan& plan);
  /// Throws DataError as `append` does.
  void end_run(const std::string& how);

  /// None if there never was one. Throws DataError for one that is damaged.
  [[nodiscard]] std::optional<Plan> plan() const;
  /// Without those that are damaged.
  [[nodiscard]] InputDigests digests() const;

  struct Known {
    std::int64_t row;
    bool failed;
    bool damaged = false;  ///< to be replaced by anything
  };
  using StoredResults = std::unordered_map<JobKey, Known, HashOfKey>;
  /// All results that are committed, as of the last `refresh` or `append`. Their values were not looked at.
  [[nodiscard]] const StoredResults& stored() const { return known_; }
  void refresh();
  /// None when it is damaged.
  [[nodiscard]] std::optional<StoredResult> result(const Known& known) const;
  /// From now on the result with this key counts as not there: `append` puts another one into its place.
  void discard(const JobKey& key);
  /// Whether parts of the file cannot be reached.
  [[nodiscard]] bool damaged() const { return damaged_; }
  [[nodiscard]] const std::string& path() const { return path_; }

  /// One transaction. What is there already, from whatever process, is left out; a failure gives way to anything.
  /// Throws DataError when it cannot be written, and, as `require_in_place`, when the file is not in its place any
  /// more; what there is has then been saved (store_file.hpp).
  void append(std::span<const StoredResult> results, const InputDigests& digests);
  void require_in_place() const { file_->require_in_place(*database_); }

  struct Run {
    std::int64_t id;
    std::string started, ended, how, version, commit, compiler, flags, host, shard, manifest;
    int threads;
  };
  [[nodiscard]] std::vector<Run> runs() const;

  /// Takes over what another store has. Throws DataError when the plans differ or the same input was read with
  /// different contents. One transaction.
  void merge(const Store& other);

 private:
  Store(const std::string& path, bool create);
  void check_format(bool create);
  void read_known(Statement& statement);
  void require_whole();
  void put_plan(const std::string& body);
  void put_digests(const InputDigests& digests);
  void put_run(const Run& run);
  void put_results(std::span<const StoredResult> results);

  std::string path_;
  std::unique_ptr<StoreFile> file_;
  std::unique_ptr<Database> database_;
  StoredResults known_;
  std::int64_t last_row_ = 0, run_ = 0;
  bool damaged_ = false;
};

}  // namespace lober

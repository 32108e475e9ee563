// Results on disk: one SQLite file in WAL mode, safe against being killed at any moment and against other processes.
//
//   runs     who computed, when, with what (provenance) and from which manifest
//   plan     the newest plan: exports follow it
//   curves   the digest of each input of that plan as it was last read; '' for one that could not be
//   results  key, status (0 done, 1 failed), seconds, value (record.hpp) or message; one row a key
//
// What is committed stays: a job whose key is there is never computed again. Rows of jobs that no plan names any more
// stay too; a plan that names them again finds them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/jobs/database.hpp"
#include "engine/jobs/job_key.hpp"
#include "engine/jobs/provenance.hpp"

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
  /// Opens or creates. Throws DataError when the file is no store, or one of another format.
  [[nodiscard]] static Store create(const std::string& path) { return {path, true}; }
  /// Throws DataError when there is none.
  [[nodiscard]] static Store open(const std::string& path) { return {path, false}; }

  /// Notes a new run and makes `plan` the one that exports follow.
  void begin_run(const Provenance& who, int threads, const std::string& manifest, const std::string& shard,
                 const Plan& plan);
  void end_run(const std::string& how);

  [[nodiscard]] std::optional<Plan> plan() const;
  [[nodiscard]] InputDigests digests() const;

  struct Known {
    std::int64_t row;
    bool failed;
  };
  using KnownResults = std::unordered_map<JobKey, Known, HashOfKey>;
  /// All results that are committed, as of the last `refresh` or `append`.
  [[nodiscard]] const KnownResults& known() const { return known_; }
  void refresh();
  [[nodiscard]] StoredResult result(const Known& known) const;

  /// One transaction. What is there already, from whatever process, is left out; a failure gives way to anything.
  void append(std::span<const StoredResult> results, const InputDigests& digests);

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
  void put_run(const Run& run);
  void put_results(std::span<const StoredResult> results);

  std::string path_;
  std::unique_ptr<Database> database_;
  KnownResults known_;
  std::int64_t last_row_ = 0, run_ = 0;
};

}  // namespace lober

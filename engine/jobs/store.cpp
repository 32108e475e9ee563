#include "engine/jobs/store.hpp"

#include <cstring>

namespace lober {
namespace {

constexpr int application = 0x6c6f6265;  // "lobe"
constexpr int format = 2;

constexpr const char* tables = R"(
  CREATE TABLE IF NOT EXISTS runs (id INTEGER PRIMARY KEY, started TEXT, ended TEXT, how TEXT, version TEXT,
    "commit" TEXT, compiler TEXT, flags TEXT, host TEXT, threads INTEGER, shard TEXT, manifest TEXT);
  CREATE TABLE IF NOT EXISTS plan (id INTEGER PRIMARY KEY CHECK (id = 1), body BLOB);
  CREATE TABLE IF NOT EXISTS curves (name TEXT PRIMARY KEY, digest TEXT) WITHOUT ROWID;
  CREATE TABLE IF NOT EXISTS results (id INTEGER PRIMARY KEY, key BLOB, run INTEGER, status INTEGER, seconds REAL,
    value BLOB);
)";

std::string_view bytes_of(const JobKey& key) {
  return {reinterpret_cast<const char*>(key.data()), key.size()};
}

JobKey key_of(std::string_view bytes) {
  JobKey key{};
  if (bytes.size() != key.size()) throw DataError("a key in the store has the wrong length");
  std::memcpy(key.data(), bytes.data(), key.size());
  return key;
}

std::int64_t pragma(const Database& database, const char* sql) {
  Statement statement(database, sql);
  return statement.step() ? statement.whole(0) : 0;
}

}  // namespace

std::string input_name(const PlannedCurve& curve) {
  return curve.name + (curve.closed ? "" : " (open)");
}

Store::Store(const std::string& path, bool create) : path_(path), database_(std::make_unique<Database>(path, create)) {
  database_->execute("BEGIN");  // another process may create the tables right now: all of what follows, or nothing
  const std::int64_t id = pragma(*database_, "PRAGMA application_id"),
                     found = pragma(*database_, "PRAGMA user_version");
  const bool fresh = pragma(*database_, "SELECT count(*) FROM sqlite_master") == 0;
  database_->execute("COMMIT");
  if (id != application && !(fresh && create)) throw DataError(path + ": is no store of results");
  if (found != format && !fresh) {
    throw DataError(path + ": was written by a version with another format");
  }
  // An empty store need not survive a power cut; all that is in it is synchronised with the first results. Pages are
  // large because each that is written is a system call or two; the log comes into the file after 4 MiB, as by default.
  if (fresh) database_->execute("PRAGMA synchronous = OFF; PRAGMA page_size = 16384");
  database_->use_write_ahead_log();
  if (fresh) {
    Transaction transaction(*database_);  // a process killed in here leaves nothing or all
    database_->execute(tables);
    database_->execute(("PRAGMA application_id = " + std::to_string(application)).c_str());
    database_->execute(("PRAGMA user_version = " + std::to_string(format)).c_str());
    transaction.commit();
  }
  database_->execute("PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = 256");
  refresh();
}

void Store::begin_run(const Provenance& who, int threads, const std::string& manifest, const std::string& shard,
                      const Plan& plan) {
  Transaction transaction(*database_);
  Run run{0, "", "", "", who.version, who.commit, who.compiler, who.flags, who.host, shard, manifest, threads};
  put_run(run);
  run_ = sqlite3_last_insert_rowid(database_->handle());
  Statement(*database_, "UPDATE runs SET started = strftime('%Y-%m-%dT%H:%M:%fZ') WHERE id = ?1").bind(1, run_).run();
  Statement(*database_, "INSERT OR REPLACE INTO plan VALUES (1, ?1)").bind_blob(1, plan.encoded()).run();
  transaction.commit();
}

void Store::put_run(const Run& run) {
  Statement statement(
      *database_,
      "INSERT INTO runs (started, ended, how, version, \"commit\", compiler, flags, host, threads, shard,"
      " manifest) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11)");
  int place = 0;
  for (const std::string* const text :
       {&run.started, &run.ended, &run.how, &run.version, &run.commit, &run.compiler, &run.flags, &run.host}) {
    statement.bind(++place, std::string_view(*text));
  }
  statement.bind(9, std::int64_t{run.threads})
      .bind(10, std::string_view(run.shard))
      .bind(11, std::string_view(run.manifest))
      .run();
}

void Store::end_run(const std::string& how) {
  Statement(*database_, "UPDATE runs SET ended = strftime('%Y-%m-%dT%H:%M:%fZ'), how = ?2 WHERE id = ?1")
      .bind(1, run_)
      .bind(2, std::string_view(how))
      .run();
}

std::optional<Plan> Store::plan() const {
  Statement statement(*database_, "SELECT body FROM plan");
  if (!statement.step()) return std::nullopt;
  return Plan::decoded(statement.bytes(0));
}

InputDigests Store::digests() const {
  InputDigests all;
  Statement statement(*database_, "SELECT name, digest FROM curves");
  while (statement.step()) all.emplace(statement.bytes(0), statement.bytes(1));
  return all;
}

void Store::refresh() {
  Statement statement(*database_, "SELECT id, key, status FROM results WHERE id > ?1 ORDER BY id");
  statement.bind(1, last_row_);
  while (statement.step()) {
    last_row_ = statement.whole(0);
    known_[key_of(statement.bytes(1))] = {last_row_, statement.whole(2) != 0};
  }
}

StoredResult Store::result(const Known& known) const {
  Statement statement(*database_, "SELECT key, status, seconds, value, run FROM results WHERE id = ?1");
  if (!statement.bind(1, known.row).step()) throw DataError(path_ + ": a result is gone");
  return {key_of(statement.bytes(0)), statement.whole(1) != 0, statement.real(2), std::string(statement.bytes(3)),
          statement.whole(4)};
}

void Store::append(std::span<const StoredResult> results, const InputDigests& digests) {
  Transaction transaction(*database_);
  refresh();  // what others have committed meanwhile
  Statement curve(*database_, "INSERT OR REPLACE INTO curves VALUES (?1, ?2)");
  for (const auto& [name, digest] : digests) {
    curve.bind(1, std::string_view(name)).bind(2, std::string_view(digest)).run();
  }
  put_results(results);
  transaction.commit();
}

void Store::put_results(std::span<const StoredResult> results) {
  Statement insert(*database_, "INSERT INTO results (key, run, status, seconds, value) VALUES (?1, ?2, ?3, ?4, ?5)");
  Statement replace(*database_,
                    "UPDATE results SET run = ?2, status = ?3, seconds = ?4, value = ?5 "
                    "WHERE id = ?1 AND status <> 0");
  for (const StoredResult& result : results) {
    const auto [at, is_new] = known_.try_emplace(result.key, Known{0, true});
    Known& known = at->second;
    if (!known.failed) continue;
    Statement& statement = is_new ? insert : replace;
    if (is_new) {
      statement.bind_blob(1, bytes_of(result.key));
    } else {
      statement.bind(1, known.row);
    }
    statement.bind(2, result.run != 0 ? result.run : run_)
        .bind(3, std::int64_t{result.failed ? 1 : 0})
        .bind(4, result.seconds)
        .bind_blob(5, result.value)
        .run();
    if (is_new) known.row = last_row_ = sqlite3_last_insert_rowid(database_->handle());
    // Nothing changes where another process has put a result in place of the failure.
    const bool changed = is_new || sqlite3_changes(database_->handle()) > 0;
    known.failed = changed && result.failed;
  }
}

std::vector<Store::Run> Store::runs() const {
  Statement statement(
      *database_,
      "SELECT id, started, ended, how, version, \"commit\", compiler, flags, host, threads, shard, manifest"
      " FROM runs ORDER BY id");
  std::vector<Run> all;
  while (statement.step()) {
    const auto text = [&](int column) { return std::string(statement.bytes(column)); };
    all.push_back({statement.whole(0), text(1), text(2), text(3), text(4), text(5), text(6), text(7), text(8), text(10),
                   text(11), static_cast<int>(statement.whole(9))});
  }
  return all;
}

void Store::merge(const Store& other) {
  const std::optional<Plan> mine = plan(), theirs = other.plan();
  if (!theirs) throw DataError(other.path_ + ": holds no plan yet");
  if (mine && mine->encoded() != theirs->encoded()) {
    throw DataError(other.path_ + ": is for another manifest than " + path_ + ", or its files were others");
  }
  Transaction transaction(*database_);
  refresh();
  InputDigests inputs = digests();
  Statement curve(*database_, "INSERT OR REPLACE INTO curves VALUES (?1, ?2)");
  for (const auto& [name, digest] : other.digests()) {
    const auto known = inputs.find(name);
    if (known != inputs.end() && known->second != digest) {
      throw DataError(other.path_ + ": " + name + " had other contents there than in " + path_ +
                      "; run one of the two again");
    }
    curve.bind(1, std::string_view(name)).bind(2, std::string_view(digest)).run();
  }
  if (!mine) Statement(*database_, "INSERT INTO plan VALUES (1, ?1)").bind_blob(1, theirs->encoded()).run();
  std::map<std::int64_t, std::int64_t> renumbered;
  for (const Run& run : other.runs()) {
    put_run(run);
    renumbered[run.id] = sqlite3_last_insert_rowid(database_->handle());
  }
  std::vector<StoredResult> results;
  for (const auto& [key, known] : other.known()) {
    results.push_back(other.result(known));
    results.back().run = renumbered[results.back().run];
  }
  put_results(results);
  transaction.commit();
}

}  // namespace lober

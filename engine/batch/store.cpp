#include "engine/batch/store.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "engine/batch/bytes.hpp"

namespace lober {
namespace {

constexpr int application = 0x6c6f6265;  // "lobe"
constexpr int format = 3;

constexpr const char* tables = R"(
  CREATE TABLE IF NOT EXISTS runs (id INTEGER PRIMARY KEY, started TEXT, ended TEXT, how TEXT, version TEXT,
    "commit" TEXT, compiler TEXT, flags TEXT, host TEXT, threads INTEGER, shard TEXT, manifest TEXT);
  CREATE TABLE IF NOT EXISTS plan (id INTEGER PRIMARY KEY CHECK (id = 1), body BLOB, sum INTEGER);
  CREATE TABLE IF NOT EXISTS curves (name TEXT PRIMARY KEY, digest TEXT, sum INTEGER) WITHOUT ROWID;
  CREATE TABLE IF NOT EXISTS results (id INTEGER PRIMARY KEY, key BLOB, run INTEGER, status INTEGER, seconds REAL,
    value BLOB, sum INTEGER);
)";

std::string_view bytes_of(const JobKey& key) {
  return {reinterpret_cast<const char*>(key.data()), key.size()};
}

std::optional<JobKey> key_of(std::string_view bytes) {
  JobKey key{};
  if (bytes.size() != key.size()) return std::nullopt;
  std::memcpy(key.data(), bytes.data(), key.size());
  return key;
}

// Against damage, not against forgery. Every step is a one-to-one function of the state and of the word, so that no
// change within one word goes unseen.
std::int64_t checksum(std::string_view bytes) {
  std::uint64_t sum = 0x9e3779b97f4a7c15 ^ bytes.size();
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::size_t size = std::min(bytes.size(), sizeof(word));
    std::memcpy(&word, bytes.data(), size);
    bytes.remove_prefix(size);
    sum = (sum ^ word) * 0xd6e8feb86659fd93;
    sum ^= sum >> 32;
  }
  return std::bit_cast<std::int64_t>(sum);
}
std::int64_t checksum(std::string_view name, std::string_view digest) {
  ByteWriter writer;
  writer.put_text(name);
  writer.put_text(digest);
  return checksum(writer.take());
}
std::int64_t checksum(const StoredResult& result) {
  ByteWriter writer;
  writer.put(result.key);
  writer.put_flag(result.failed);
  writer.put(result.seconds);
  writer.put(result.run);
  writer.put_text(result.value);
  return checksum(writer.take());
}

std::int64_t pragma(const Database& database, const char* sql) {
  Statement statement(database, sql);
  return statement.step() ? statement.whole(0) : 0;
}

}  // namespace

std::string input_name(const PlannedCurve& curve) {
  return curve.name + (curve.closed ? "" : " (open)");
}

Store::Store(const std::string& path, bool create)
    : path_(path), file_(std::make_unique<StoreFile>(path)), database_(std::make_unique<Database>(path, create)) {
  check_format(create);
  file_->opened();
  refresh();
}

// Makes a store of a file that is empty.
void Store::check_format(bool create) {
  database_->execute("BEGIN");  // another process may create the tables right now: all of what follows, or nothing
  const std::int64_t id = pragma(*database_, "PRAGMA application_id"),
                     found = pragma(*database_, "PRAGMA user_version");
  const bool fresh = pragma(*database_, "SELECT count(*) FROM sqlite_master") == 0;
  database_->execute("COMMIT");
  if (id != application && !(fresh && create)) throw DataError(path_ + ": is no store of results");
  if (found != format && !fresh) {
    throw DataError(path_ + ": is a store of format " + std::to_string(found) + ", as " +
                    (found < format ? "older" : "newer") + " versions of lober have it; this one has format " +
                    std::to_string(format) + ": run the manifest with another --store");
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
}

// SQLite would go on writing into tables that do not hold together, and lose more.
void Store::require_whole() {
  if (!known_.empty() && !damaged_) {
    Statement check(*database_, "PRAGMA quick_check(1)");
    damaged_ = !check.step() || check.bytes(0) != "ok";
  }
  if (!damaged_) return;
  throw DataError(path_ + ": is damaged, its tables do not hold together; lober batch merge NEW " + path_ +
                  " takes over into NEW what can be read, then run with --store NEW");
}

void Store::begin_run(const Provenance& who, int threads, const std::string& manifest, const std::string& shard,
                      const Plan& plan) {
  require_whole();
  Transaction transaction(*database_);
  Run run{0, "", "", "", who.version, who.commit, who.compiler, who.flags, who.host, shard, manifest, threads};
  put_run(run);
  run_ = sqlite3_last_insert_rowid(database_->handle());
  Statement(*database_, "UPDATE runs SET started = strftime('%Y-%m-%dT%H:%M:%fZ') WHERE id = ?1").bind(1, run_).run();
  put_plan(plan.encoded());
  transaction.commit();
}

void Store::put_plan(const std::string& body) {
  Statement(*database_, "INSERT OR REPLACE INTO plan VALUES (1, ?1, ?2)")
      .bind_blob(1, body)
      .bind(2, checksum(body))
      .run();
}

void Store::put_digests(const InputDigests& digests) {
  Statement curve(*database_, "INSERT OR REPLACE INTO curves VALUES (?1, ?2, ?3)");
  for (const auto& [name, digest] : digests) {
    curve.bind(1, std::string_view(name)).bind(2, std::string_view(digest)).bind(3, checksum(name, digest)).run();
  }
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
  file_->require_in_place(*database_);
}

std::optional<Plan> Store::plan() const {
  try {
    Statement statement(*database_, "SELECT body, sum FROM plan");
    if (!statement.step()) return std::nullopt;
    const std::string body(statement.bytes(0));
    if (statement.whole(1) == checksum(body)) return Plan::decoded(body);
  } catch (const DataError&) {
  }
  throw DataError(path_ + ": its plan is damaged; lober batch run MANIFEST --store " + path_ + " writes it again");
}

InputDigests Store::digests() const {
  InputDigests all;
  try {
    Statement statement(*database_, "SELECT name, digest, sum FROM curves");
    while (statement.step()) {
      if (statement.whole(2) != checksum(statement.bytes(0), statement.bytes(1))) continue;
      all.emplace(statement.bytes(0), statement.bytes(1));
    }
  } catch (const DamagedError&) {  // the others count as damaged too
  }
  return all;
}

void Store::refresh() {
  try {
    Statement statement(*database_, "SELECT id, key, status FROM results WHERE id > ?1 ORDER BY id");
    statement.bind(1, last_row_);
    read_known(statement);
  } catch (const DamagedError&) {
    damaged_ = true;
    try {  // up to the damage from the other end
      Statement statement(*database_, "SELECT id, key, status FROM results ORDER BY id DESC");
      read_known(statement);
    } catch (const DamagedError&) {
    }
  }
}

// Where a key occurs twice, because the first of the two was damaged, the last row counts.
void Store::read_known(Statement& statement) {
  while (statement.step()) {
    const std::int64_t row = statement.whole(0);
    last_row_ = std::max(last_row_, row);
    const std::optional<JobKey> key = key_of(statement.bytes(1));
    if (!key) continue;
    const auto [at, is_new] = known_.try_emplace(*key, Known{row, statement.whole(2) != 0});
    if (!is_new && at->second.row < row) at->second = {row, statement.whole(2) != 0};
  }
}

std::optional<StoredResult> Store::result(const Known& known) const {
  if (known.damaged) return std::nullopt;
  try {
    Statement statement(*database_, "SELECT key, status, seconds, value, run, sum FROM results WHERE id = ?1");
    if (!statement.bind(1, known.row).step()) return std::nullopt;
    const std::optional<JobKey> key = key_of(statement.bytes(0));
    if (!key) return std::nullopt;
    StoredResult result{*key, statement.whole(1) != 0, statement.real(2), std::string(statement.bytes(3)),
                        statement.whole(4)};
    const bool sound = statement.whole(5) == checksum(result);
    return sound ? std::optional(std::move(result)) : std::nullopt;
  } catch (const DamagedError&) {
    return std::nullopt;
  }
}

void Store::discard(const JobKey& key) {
  if (const auto at = known_.find(key); at != known_.end()) at->second.damaged = true;
}

void Store::append(std::span<const StoredResult> results, const InputDigests& digests) {
  {
    Transaction transaction(*database_);
    refresh();  // what others have committed meanwhile
    put_digests(digests);
    put_results(results);
    transaction.commit();
  }
  file_->require_in_place(*database_);
}

void Store::put_results(std::span<const StoredResult> results) {
  Statement insert(*database_,
                   "INSERT INTO results (key, run, status, seconds, value, sum) VALUES (?1, ?2, ?3, ?4, ?5, ?6)");
  Statement replace(*database_,
                    "UPDATE results SET run = ?2, status = ?3, seconds = ?4, value = ?5, sum = ?6 "
                    "WHERE id = ?1 AND status <> 0");
  for (const StoredResult& given : results) {
    const auto [at, absent] = known_.try_emplace(given.key, Known{0, true});
    Known& known = at->second;
    if (known.damaged) Statement(*database_, "DELETE FROM results WHERE id = ?1").bind(1, known.row).run();
    const bool is_new = absent || known.damaged;
    if (!known.failed && !is_new) continue;
    StoredResult result = given;
    if (result.run == 0) result.run = run_;
    Statement& statement = is_new ? insert : replace;
    if (is_new) {
      statement.bind_blob(1, bytes_of(result.key));
    } else {
      statement.bind(1, known.row);
    }
    statement.bind(2, result.run)
        .bind(3, std::int64_t{result.failed ? 1 : 0})
        .bind(4, result.seconds)
        .bind_blob(5, result.value)
        .bind(6, checksum(result))
        .run();
    if (is_new) known = {sqlite3_last_insert_rowid(database_->handle()), true};
    if (is_new) last_row_ = known.row;
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
  const auto text = [&](int column) { return std::string(statement.bytes(column)); };
  try {
    while (statement.step()) {
      all.push_back({statement.whole(0), text(1), text(2), text(3), text(4), text(5), text(6), text(7), text(8),
                     text(10), text(11), static_cast<int>(statement.whole(9))});
    }
  } catch (const DamagedError&) {  // those that can be read
  }
  return all;
}

void Store::merge(const Store& other) {
  const std::optional<Plan> planned = plan(), theirs = other.plan();
  if (!theirs) throw DataError(other.path_ + ": holds no plan yet");
  if (planned && planned->encoded() != theirs->encoded()) {
    throw DataError(other.path_ + ": is for another manifest than " + path_ + ", or its files were others");
  }
  require_whole();
  Transaction transaction(*database_);
  refresh();
  const InputDigests inputs = digests(), others = other.digests();
  for (const auto& [name, digest] : others) {
    const auto known = inputs.find(name);
    if (known != inputs.end() && known->second != digest) {
      throw DataError(other.path_ + ": " + name + " had other contents there than in " + path_ +
                      "; run one of the two again");
    }
  }
  put_digests(others);
  if (!planned) put_plan(theirs->encoded());
  std::map<std::int64_t, std::int64_t> renumbered;
  for (const Run& run : other.runs()) {
    put_run(run);
    renumbered[run.id] = sqlite3_last_insert_rowid(database_->handle());
  }
  std::vector<StoredResult> results;
  for (const auto& [key, known] : other.stored()) {
    std::optional<StoredResult> result = other.result(known);
    if (!result) continue;
    if (const auto mine = known_.find(key); mine != known_.end() && !this->result(mine->second)) discard(key);
    const auto run = renumbered.find(result->run);
    result->run = run != renumbered.end() ? run->second : 0;
    results.push_back(std::move(*result));
  }
  put_results(results);
  transaction.commit();
}

}  // namespace lober

// One class, and a little longer than other files for that: what it writes in one transaction stands together.
#include "engine/batch/store/store.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <unordered_set>
#include <utility>

#include "engine/base/quantities.hpp"
#include "engine/batch/store/checksum.hpp"
#include "engine/batch/store/store_schema.hpp"
#include "lober/base/cancellation.hpp"

namespace lober::detail {
namespace {

constexpr int application = 0x6c6f6265;  // "lobe"

std::int64_t checksum(std::string_view bytes) {
  return Checksum().add(bytes).sum();
}
std::int64_t checksum(std::string_view name, std::string_view digest) {
  return Checksum().add(name).add(digest).sum();
}

std::int64_t pragma(const Database& database, const char* sql) {
  Statement statement(database, sql);
  return statement.step() ? statement.whole(0) : 0;
}

}  // namespace

Store::Store(const std::string& path, bool create)
    : path_(path),
      file_(std::make_unique<StoreFile>(path, create)),
      database_(std::make_unique<Database>(path, create)) {
  file_->opened();  // before anything is written: whoever removes the file once it has a log finds it watched
  const bool made = check_format(create);
  for (const Operation& operation : all_operations()) tables_.emplace_back(*database_, operation);
  last_rows_.resize(tables_.size(), 0);
  damaged_ = !made && !has_store_schema(*database_);
  refresh();
}

// Makes a store of a file that is empty, and returns whether it has.
bool Store::check_format(bool create) {
  database_->execute("BEGIN");  // another process may create the tables right now: all that follows, or nothing
  const std::int64_t id = pragma(*database_, "PRAGMA application_id"),
                     found = pragma(*database_, "PRAGMA user_version");
  const bool fresh = pragma(*database_, "SELECT count(*) FROM sqlite_master") == 0;
  database_->execute("COMMIT");
  if (id != application && !(fresh && create)) throw DataError(path_ + ": is not a store of results");
  if (found != store_format && !fresh) {
    throw DataError(path_ + ": is a store of format " + std::to_string(found) + ", as " +
                    (found < store_format ? "older" : "newer") + " versions of lober have it; this one has format " +
                    std::to_string(store_format) + ": run the manifest with " + std::string(quantity::store));
  }
  // An empty store need not survive a power cut; all that is in it is synchronised with the first results. Pages are
  // large because each that is written is a system call or two; the log comes into the file after 4 MiB, as by default.
  if (fresh) database_->execute("PRAGMA synchronous = OFF; PRAGMA page_size = 16384");
  database_->use_write_ahead_log();
  bool made = false;
  if (fresh) {
    Transaction transaction(*database_);  // a process killed in here leaves nothing or all
    made = pragma(*database_, "SELECT count(*) FROM sqlite_master") == 0;  // no other process was faster
    if (made) database_->execute(store_schema().c_str());
    database_->execute(("PRAGMA application_id = " + std::to_string(application)).c_str());
    database_->execute(("PRAGMA user_version = " + std::to_string(store_format)).c_str());
    transaction.commit();
  }
  database_->execute("PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = 256");
  return made;
}

// SQLite would go on writing into tables that do not hold together, and lose more.
void Store::require_whole() {
  if (!known_.empty() && !damaged_) {
    Statement check(*database_, "PRAGMA quick_check(1)");
    damaged_ = !check.step() || check.bytes(0) != "ok";
  }
  if (!damaged_) return;
  throw DataError(path_ + ": is damaged, its tables do not hold together; run lober batch merge NEW " + path_ +
                  ", which copies the readable results into NEW, and then the manifest with " +
                  std::string(quantity::store) + ", NEW");
}

void Store::begin_run(const Provenance& who, int threads, const Manifest& manifest, const std::string& shard,
                      Plan plan) {
  require_whole();
  Transaction transaction(*database_);
  std::error_code ignored;
  const std::string folder = std::filesystem::absolute(manifest.path, ignored).parent_path().string();
  Run run{0,      "",     "", "", who.version, who.commit, who.compiler, who.flags, who.host, shard, manifest.text,
          folder, threads};
  put_run(run);
  run_ = sqlite3_last_insert_rowid(database_->handle());
  Statement(*database_, "UPDATE runs SET started = strftime('%Y-%m-%dT%H:%M:%fZ') WHERE id = ?1").bind(1, run_).run();
  plan_ = std::move(plan);
  put_plan(*plan_);
  known_.reserve(plan_->jobs.size() - std::min(plan_->jobs.size(), known_.size()));
  transaction.commit();
}

void Store::put_plan(const Plan& plan) {
  const std::string body = plan.encoded();
  plan_sum_ = checksum(body);
  plan_is_new_ = !shows_plan();
  Statement(*database_, "INSERT OR REPLACE INTO plan VALUES (1, ?1, ?2)").bind_blob(1, body).bind(2, plan_sum_).run();
  if (!plan_is_new_) return;
  database_->execute("DELETE FROM groups");
  Statement insert(*database_, "INSERT INTO groups VALUES (?1, ?2, ?3, ?4, ?5)");
  for (std::size_t k = 0; k < plan.groups.size(); ++k) {
    const JobGroup& group = plan.groups[k];
    const std::string options = group.options.to_string(), settings = encoded_settings(group.options);
    insert.bind(1, static_cast<std::int64_t>(k)).bind(2, std::string_view(group.name));
    insert.bind(3, std::string_view(group.operation->name)).bind(4, std::string_view(options));
    insert.bind(5, std::string_view(settings)).run();
  }
}

// Another process may have made another plan the newest one meanwhile.
bool Store::shows_plan() const {
  Statement statement(*database_, "SELECT sum FROM plan WHERE id = 1");
  return statement.step() && statement.whole(0) == plan_sum_;
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
      " manifest, folder) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12)");
  int index = 0;
  for (const std::string* const text :
       {&run.started, &run.ended, &run.how, &run.version, &run.commit, &run.compiler, &run.flags, &run.host}) {
    statement.bind(++index, std::string_view(*text));
  }
  statement.bind(9, std::int64_t{run.threads})
      .bind(10, std::string_view(run.shard))
      .bind(11, std::string_view(run.manifest))
      .bind(12, std::string_view(run.folder))
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
    Statement statement(*database_, "SELECT body, sum FROM plan WHERE id = 1");
    if (!statement.step()) return std::nullopt;
    const std::string body(statement.bytes(0));
    if (statement.whole(1) == checksum(body)) return Plan::decoded(body);
  } catch (const DataError&) {
  }
  if (file_->has_several_names()) {
    throw DataError(path_ + ": cannot be read by this name, one of several (hard links); give the name that wrote it");
  }
  throw DataError(path_ +
                  ": its plan is damaged; use lober batch run with its manifest and this store to write it again");
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
  // Changes when another connection has committed; asked for first, so that whatever comes meanwhile is read next time.
  if (!version_) version_.emplace(*database_, "PRAGMA data_version");
  const std::int64_t version = version_->step() ? version_->whole(0) : 0;
  version_->reset();
  if (version == known_version_) return;
  known_version_ = version;
  for (std::uint32_t table = 0; table < tables_.size(); ++table) {
    try {
      read_known(table, false);
    } catch (const DamagedError&) {
      damaged_ = true;
      try {  // up to the damage from the other end
        read_known(table, true);
      } catch (const DamagedError&) {
      }
    }
  }
}

// Where a key occurs twice, because the first of the two was damaged, the last row counts.
void Store::read_known(std::uint32_t table, bool backwards) {
  tables_[table].each_row(backwards ? 0 : last_rows_[table], backwards, [&](const ResultTable::Row& row) {
    last_rows_[table] = std::max(last_rows_[table], row.id);
    const Known known{row.id, row.job, table, row.failed, false, run_ != 0};
    const auto [present, is_new] = known_.try_emplace(row.key, known);
    if (!is_new && present.row < row.id) present = known;
  });
}

std::optional<Result> Store::result(const Known& known) const {
  if (known.damaged) return std::nullopt;
  return tables_[known.table].get(known.row);
}

void Store::discard(const JobKey& key) {
  if (Known* const known = known_.find(key)) known->damaged = true;
}

// Results of one table that are new there, written all at a time. `known_` has them, but not yet their rows.
class Store::NewResults {
 public:
  NewResults(Store& store, bool shown) : store_(store), plan_(shown ? &*store.plan_ : nullptr) {}
  void add(std::uint32_t table, const Result& result) {
    if (table != table_) write();
    table_ = table;
    results_.push_back(&result);
  }
  void write() {
    if (results_.empty()) return;
    const std::int64_t last_row = store_.tables_[table_].put(results_, store_.run_, plan_);
    std::int64_t row = last_row - static_cast<std::int64_t>(results_.size());
    for (const Result* const result : results_) store_.known_.find(result->key)->row = ++row;
    store_.last_rows_[table_] = std::max(store_.last_rows_[table_], last_row);
    results_.clear();
  }

 private:
  Store& store_;
  const Plan* plan_;
  std::uint32_t table_ = 0;
  std::vector<const Result*> results_;
};

void Store::append(std::span<const Result> results, const InputDigests& digests) {
  {
    Transaction transaction(*database_);
    refresh();  // what others have committed meanwhile
    put_digests(digests);
    const bool shown = shows_plan();
    NewResults fresh(*this, shown);
    for (std::size_t k = 0; k < results.size(); ++k) {
      if (k + 4 < results.size()) known_.prefetch(results[k + 4].key);
      const std::uint32_t table = table_of(*plan_, results[k].job);
      const auto [known, absent] = known_.try_emplace(results[k].key, Known{0, no_job, table, true});
      if (absent) {
        known = {0, shown ? results[k].job : no_job, table, results[k].failed()};
        fresh.add(table, results[k]);
      } else {
        fresh.write();
        if (known.foreign && !known.failed && !known.damaged) ++stored_meanwhile_;
        put(known, absent, table, results[k], shown);
      }
    }
    fresh.write();
    transaction.commit();
  }
  file_->require_in_place(*database_);
}

std::uint32_t Store::table_of(const Plan& plan, std::uint32_t job) const {
  return static_cast<std::uint32_t>(plan.group_of(plan.jobs[job]).operation - all_operations().data());
}

void Store::put(std::uint32_t table, const Result& result, bool shown) {
  const auto [known, absent] = known_.try_emplace(result.key, Known{0, no_job, table, true});
  put(known, absent, table, result, shown);
}

void Store::put(Known& known, bool absent, std::uint32_t table, const Result& result, bool shown) {
  const Plan* const plan = shown && result.job != no_job ? &*plan_ : nullptr;
  if (known.damaged) tables_[known.table].remove(known.row);
  const bool is_new = absent || known.damaged;
  // A failure gives way, unless another process has put a result into its place.
  if (is_new || (known.failed && tables_[known.table].remove_failure(known.row))) {
    const Result* const one = &result;
    const std::optional<std::int64_t> row = is_new ? std::nullopt : std::optional(known.row);
    const std::uint32_t before = known.job;
    known = {tables_[table].put({&one, 1}, run_, plan, row), plan != nullptr ? result.job : no_job, table,
             result.failed()};
    last_rows_[table] = std::max(last_rows_[table], known.row);
    if (plan != nullptr && before != no_job && before != result.job) put_repeat(before, known);
  } else {
    known.failed = false;
    if (plan != nullptr && known.job != result.job) put_repeat(result.job, known);
  }
}

void Store::put_repeat(std::uint32_t job, const Known& known) {
  const std::string name = plan_->name(plan_->jobs[job].first), other = plan_->name(plan_->jobs[job].second);
  const ResultTable& table = tables_[known.table];
  Statement statement(*database_,
                      ("INSERT OR REPLACE INTO repeats SELECT ?1, ?2, nullif(?3, ''), nullif(?4, ''), ?5, ?6 WHERE NOT "
                       "EXISTS (SELECT 1 FROM " +
                       detail::table_of(table.operation()) + " WHERE id = ?6 AND job = ?1)")
                          .c_str());
  statement.bind(1, std::int64_t{job}).bind(2, std::int64_t{plan_->jobs[job].group}).bind(3, std::string_view(name));
  statement.bind(4, std::string_view(other)).bind(5, std::string_view(table.operation().name)).bind(6, known.row).run();
}

void Store::show(const InputDigests& inputs) {
  Transaction transaction(*database_);
  refresh();
  InputDigests all = inputs;
  all.merge(digests());
  label_rows(all);
  transaction.commit();
}

void Store::label_rows(const InputDigests& inputs) {
  const std::vector<const std::string*> digests = digests_by_curve(*plan_, inputs);
  database_->execute("DELETE FROM repeats");
  const JobKeys keys(*plan_);
  std::unordered_set<const Known*> labelled;
  for (std::uint32_t job = 0; job < plan_->jobs.size(); ++job) {
    const std::optional<JobKey> key = keys.find(plan_->jobs[job], digests);
    Known* const known = key ? known_.find(*key) : nullptr;
    if (known == nullptr || known->damaged) continue;
    if (!labelled.insert(known).second) {
      put_repeat(job, *known);
    } else if (plan_is_new_ || known->job != job) {
      tables_[known->table].label(known->row, &*plan_, job);
      known->job = job;
    }
  }
  for (auto& [key, known] : known_) {
    if (known.job == no_job || labelled.contains(&known)) continue;
    tables_[known.table].label(known.row, nullptr, no_job);
    known.job = no_job;
  }
  plan_is_new_ = false;
}

std::vector<Store::Run> Store::runs() const {
  Statement statement(
      *database_,
      "SELECT id, started, ended, how, version, \"commit\", compiler, flags, host, threads, shard, manifest,"
      " folder FROM runs ORDER BY id");
  std::vector<Run> all;
  const auto text = [&](int column) { return std::string(statement.bytes(column)); };
  try {
    while (statement.step()) {
      all.push_back({statement.whole(0), text(1), text(2), text(3), text(4), text(5), text(6), text(7), text(8),
                     text(10), text(11), text(12), static_cast<int>(statement.whole(9))});
    }
  } catch (const DamagedError&) {  // those that can be read
  }
  return all;
}

std::vector<std::size_t> Store::merge(std::span<const Store> others, const Progress& progress) {
  std::vector<std::size_t> damaged;
  std::size_t all = 0, before = 0;
  for (const Store& other : others) all += other.stored().size();
  require_whole();
  Transaction transaction(*database_);
  refresh();
  for (std::size_t k = 0; k < others.size(); ++k) {
    const std::size_t own = others[k].stored().size();
    const bool whole = take_over(others[k], [&](double part) {
      return progress((static_cast<double>(before) + part * static_cast<double>(own)) /
                      static_cast<double>(std::max<std::size_t>(all, 1)));
    });
    if (!whole) damaged.push_back(k);
    before += own;
  }
  transaction.commit();
  return damaged;
}

// False if results are damaged.
bool Store::take_over(const Store& other, const Progress& progress) {
  constexpr std::size_t results_between_reports = 64;
  const std::optional<Plan> planned = plan();
  std::optional<Plan> theirs = other.plan();
  if (!theirs) throw DataError(other.path_ + ": holds no plan yet");
  if (planned && planned->encoded() != theirs->encoded()) {
    throw DataError(other.path_ + ": is for another manifest than " + path_ + ", or for other files");
  }
  InputDigests inputs = digests(), digests_there = other.digests();
  for (const auto& [name, digest] : digests_there) {
    const auto known = inputs.find(name);
    if (known != inputs.end() && known->second != digest) {
      throw DataError(other.path_ + ": " + name + " had other contents there than in " + path_ +
                      "; run one of the two again");
    }
  }
  put_digests(digests_there);
  inputs.merge(digests_there);
  plan_ = std::move(theirs);
  put_plan(*plan_);
  plan_is_new_ = false;  // rows bear its names if there are any
  std::map<std::int64_t, std::int64_t> renumbered;
  const std::vector<Run> present = runs();
  for (const Run& run : other.runs()) {  // a store may be merged again, when it has more
    const auto same = std::find_if(present.begin(), present.end(), [&](const Run& any) { return any.is_same(run); });
    if (same == present.end()) put_run(run);
    renumbered[run.id] = same == present.end() ? sqlite3_last_insert_rowid(database_->handle()) : same->id;
  }
  std::size_t number = 0;
  bool whole = true;
  for (const auto& [key, known] : other.stored()) {
    if (number % results_between_reports == 0 &&
        !progress(static_cast<double>(number) / static_cast<double>(other.stored().size()))) {
      throw Cancelled();
    }
    ++number;
    std::optional<Result> result = other.result(known);
    if (!result) {
      whole = false;
      continue;
    }
    if (const Known* const mine = known_.find(key); mine != nullptr && !this->result(*mine)) discard(key);
    const auto run = renumbered.find(result->run);
    result->run = run != renumbered.end() ? run->second : 0;
    result->job = known.job < plan_->jobs.size() ? known.job : no_job;
    put(known.table, *result, true);
  }
  label_rows(inputs);
  return whole;
}

}  // namespace lober::detail

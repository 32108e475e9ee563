#include "engine/batch/store/new_rows.hpp"

#include <cmath>
#include <new>
#include <string_view>

#include "engine/batch/store/checksum.hpp"
#include "engine/batch/store/store_schema.hpp"

namespace lober::detail {
namespace {

std::string_view bytes_of(const JobKey& key) {
  return {reinterpret_cast<const char*>(key.data()), key.size()};
}

// In the order of the table.
enum class Fixed : std::uint8_t { id, key, run, job, group, curve1, curve2, seconds, message, lists, sum };
constexpr std::size_t fixed_columns = static_cast<std::size_t>(Fixed::sum) + 1;

// Texts and blobs live until the row has been inserted.
void give(sqlite3_context* to, std::string_view text) {
  sqlite3_result_text64(to, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8);
}

void give_number(sqlite3_context* to, const Column& column, double value) {
  constexpr double exact = 9007199254740992;  // 2^53
  if (column.kind == Column::Kind::count && std::fabs(value) < exact) {
    const auto whole = static_cast<std::int64_t>(value);
    if (static_cast<double>(whole) == value && !(whole == 0 && std::signbit(value))) {
      sqlite3_result_int64(to, whole);
      return;
    }
  }
  sqlite3_result_double(to, value);  // NaN becomes NULL
}

}  // namespace

std::int64_t checksum(const Result& result, std::int64_t run, std::string_view lists) {
  Checksum sum;
  sum.add(bytes_of(result.key)).add(std::uint64_t{result.failed()}).add(result.seconds);
  sum.add(static_cast<std::uint64_t>(run)).add(result.error).add(lists);
  return sum.add(std::span<const double>(result.values)).sum();
}

// The results, row by row, and how SQLite calls them.
class NewRows::Source {
 public:
  explicit Source(const Operation& operation) : operation_(operation) {}

  void set(std::span<const Result* const> results, std::int64_t run, const Plan* plan,
           std::optional<std::int64_t> row) {
    results_ = results;
    run_ = run;
    row_ = row;
    first_.plan = second_.plan = plan;
    first_.curve = second_.curve = no_curve;
  }

  static const sqlite3_module* module() {
    static constexpr sqlite3_module made = [] {
      sqlite3_module calls{};
      calls.xConnect = connect;
      calls.xDisconnect = [](sqlite3_vtab* table) {
        delete static_cast<Table*>(table);
        return SQLITE_OK;
      };
      calls.xBestIndex = [](sqlite3_vtab*, sqlite3_index_info*) { return SQLITE_OK; };
      calls.xOpen = [](sqlite3_vtab*, sqlite3_vtab_cursor** cursor) {
        *cursor = new (std::nothrow) sqlite3_vtab_cursor{};
        return *cursor != nullptr ? SQLITE_OK : SQLITE_NOMEM;
      };
      calls.xClose = [](sqlite3_vtab_cursor* cursor) {
        delete cursor;
        return SQLITE_OK;
      };
      calls.xFilter = [](sqlite3_vtab_cursor* cursor, int, const char*, int, sqlite3_value**) {
        return of(cursor).go_to(0);
      };
      calls.xNext = [](sqlite3_vtab_cursor* cursor) { return of(cursor).go_to(of(cursor).at_ + 1); };
      calls.xEof = [](sqlite3_vtab_cursor* cursor) { return of(cursor).at_ >= of(cursor).results_.size() ? 1 : 0; };
      calls.xColumn = [](sqlite3_vtab_cursor* cursor, sqlite3_context* to, int column) {
        return of(cursor).give_column(to, static_cast<std::size_t>(column));
      };
      calls.xRowid = [](sqlite3_vtab_cursor* cursor, sqlite3_int64* number) {
        *number = static_cast<sqlite3_int64>(of(cursor).at_);
        return SQLITE_OK;
      };
      return calls;
    }();
    return &made;
  }

 private:
  struct Table : sqlite3_vtab {
    Source* source;
  };
  static Source& of(const sqlite3_vtab_cursor* cursor) { return *static_cast<const Table*>(cursor->pVtab)->source; }

  static int connect(sqlite3* database, void* source, int, const char* const*, sqlite3_vtab** table, char**) {
    const std::size_t columns = fixed_columns + static_cast<Source*>(source)->operation_.columns.size();
    try {
      std::string sql = "CREATE TABLE new(";
      for (std::size_t k = 0; k < columns; ++k) sql += (k == 0 ? "c" : ", c") + std::to_string(k);
      if (const int code = sqlite3_declare_vtab(database, (sql + ")").c_str()); code != SQLITE_OK) return code;
      *table = new Table{{}, static_cast<Source*>(source)};
    } catch (const std::bad_alloc&) {
      return SQLITE_NOMEM;
    }
    return SQLITE_OK;
  }

  int go_to(std::size_t number) {
    at_ = number;
    if (at_ >= results_.size()) return SQLITE_OK;
    try {
      const Result& result = *results_[at_];
      if (!result.lists.empty() || !lists_.empty()) lists_ = encoded_lists(result.lists, operation_.lists);
      job_ = first_.plan != nullptr && result.job != no_job ? &first_.plan->jobs[result.job] : nullptr;
      if (job_ == nullptr) return SQLITE_OK;
      first_.set(job_->first);
      second_.set(job_->second);
    } catch (const std::bad_alloc&) {
      return SQLITE_NOMEM;
    }
    return SQLITE_OK;
  }

  // A column without a value is NULL.
  int give_column(sqlite3_context* to, std::size_t column) const {
    const Result& result = *results_[at_];
    if (column >= fixed_columns) {
      const std::size_t k = column - fixed_columns;
      if (!result.failed()) give_number(to, operation_.columns[k], result.values[k]);
      return SQLITE_OK;
    }
    using enum Fixed;
    switch (static_cast<Fixed>(column)) {
      case id:
        if (row_) sqlite3_result_int64(to, *row_);
        break;
      case key:
        sqlite3_result_blob64(to, result.key.data(), result.key.size(), SQLITE_STATIC);
        break;
      case run:
        sqlite3_result_int64(to, run_of(result));
        break;
      case job:
        if (job_ != nullptr) sqlite3_result_int64(to, result.job);
        break;
      case group:
        if (job_ != nullptr) sqlite3_result_int64(to, job_->group);
        break;
      case curve1:
        if (job_ != nullptr && job_->first != no_curve) give(to, first_.name);
        break;
      case curve2:
        if (job_ != nullptr && job_->second != no_curve) give(to, second_.name);
        break;
      case seconds:
        sqlite3_result_double(to, result.seconds);
        break;
      case message:
        if (result.failed()) give(to, result.error);
        break;
      case lists:
        if (!lists_.empty()) give(to, lists_);
        break;
      case sum:
        sqlite3_result_int64(to, checksum(result, run_of(result), lists_));
        break;
    }
    return SQLITE_OK;
  }

  [[nodiscard]] std::int64_t run_of(const Result& result) const { return result.run != 0 ? result.run : run_; }

  // The name of a curve, which is that of many jobs one after the other.
  struct CurveName {
    const Plan* plan = nullptr;
    CurveId curve = no_curve;
    std::string name = {};
    void set(CurveId wanted) {
      if (wanted == curve) return;
      curve = no_curve;  // unless what follows returns
      name = plan->name(wanted);
      curve = wanted;
    }
  };

  const Operation& operation_;
  std::span<const Result* const> results_;
  std::int64_t run_ = 0;
  std::optional<std::int64_t> row_;
  std::size_t at_ = 0;
  const Job* job_ = nullptr;
  CurveName first_, second_;
  std::string lists_;
};

NewRows::NewRows(const Database& database, const Operation& operation)
    : database_(database), source_(std::make_unique<Source>(operation)) {
  const std::string name = "new_" + table_of(operation);
  if (sqlite3_create_module(database.handle(), name.c_str(), Source::module(), source_.get()) != SQLITE_OK) {
    database.fail();
  }
  insert_.emplace(database, ("INSERT INTO " + table_of(operation) + " SELECT * FROM " + name).c_str());
}

NewRows::~NewRows() = default;

std::int64_t NewRows::insert(std::span<const Result* const> results, std::int64_t run, const Plan* plan,
                             std::optional<std::int64_t> row) {
  source_->set(results, run, plan, row);
  insert_->run();
  return sqlite3_last_insert_rowid(database_.handle());
}

}  // namespace lober::detail

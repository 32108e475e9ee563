#include "engine/batch/store/result_table.hpp"

#include <cmath>
#include <cstring>

#include "engine/batch/store/checksum.hpp"
#include "engine/batch/store/store_schema.hpp"

namespace lober::detail {
namespace {

std::string_view bytes_of(const JobKey& key) {
  return {reinterpret_cast<const char*>(key.data()), key.size()};
}

std::optional<JobKey> key_of(std::string_view bytes) {
  JobKey key{};
  if (bytes.size() != key.size()) return std::nullopt;
  std::memcpy(key.data(), bytes.data(), key.size());
  return key;
}

constexpr std::size_t first_value = 12;  // its index among the columns, from 1

// A statement that is at a row keeps what it read from being written over.
class Reading {
 public:
  explicit Reading(Statement& statement) : statement_(statement) {}
  ~Reading() { statement_.reset(); }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

 private:
  Statement& statement_;
};

// The columns of a row that describe its job.
class Labels {
 public:
  /// `plan` may be null: the labels of no job.
  Labels(const Plan* plan, std::uint32_t job) : job_(job) {
    if (plan == nullptr) return;
    planned_ = &plan->jobs[job];
    first_ = plan->name(planned_->first);
    second_ = plan->name(planned_->second);
  }
  /// Binds four parameters. The statement has to run before the labels go.
  void bind(Statement& statement, int index) const {
    if (planned_ == nullptr) {
      for (int k = 0; k < 4; ++k) statement.bind_null(index + k);
      return;
    }
    statement.bind(index, std::int64_t{job_}).bind(index + 1, std::int64_t{planned_->group});
    bind_name(statement, index + 2, planned_->first, first_);
    bind_name(statement, index + 3, planned_->second, second_);
  }

 private:
  static void bind_name(Statement& statement, int index, CurveId curve, const std::string& name) {
    curve != no_curve ? statement.bind(index, std::string_view(name)) : statement.bind_null(index);
  }

  std::uint32_t job_;
  const Job* planned_ = nullptr;
  std::string first_, second_;
};

void bind_number(Statement& statement, int index, const Column& column, double value) {
  constexpr double exact = 9007199254740992;  // 2^53
  if (column.kind == Column::Kind::count && std::fabs(value) < exact) {
    const auto whole = static_cast<std::int64_t>(value);
    if (static_cast<double>(whole) == value && !(whole == 0 && std::signbit(value))) {
      statement.bind(index, whole);
      return;
    }
  }
  statement.bind(index, value);  // NaN becomes NULL
}

}  // namespace

Statement ResultTable::statement(const std::string& before, const std::string& behind) const {
  return {database_, (before + table_of(operation_) + behind).c_str()};
}

Statement& ResultTable::select() const {
  if (select_) return *select_;
  std::string columns = "SELECT key, run, seconds, message, lists, sum";
  for (const Column& column : operation_.columns) columns += ", " + quoted_name(column.name);
  return select_.emplace(statement(columns + " FROM ", " WHERE id = ?1"));
}

Statement& ResultTable::insert() const {
  if (insert_) return *insert_;
  std::string parameters = "?1";
  for (std::size_t k = 2; k <= first_value + operation_.columns.size() - 1; ++k)
    parameters += ", ?" + std::to_string(k);
  return insert_.emplace(statement("INSERT INTO ", " VALUES (" + parameters + ")"));
}

// The parameters of a row of a block: what stands before the seconds, they and the sum, and the values. Before all
// rows comes the run.
constexpr int fixed_parameters = 7;

Statement& ResultTable::insert_block() const {
  if (insert_block_) return *insert_block_;
  const std::size_t parameters = fixed_parameters + operation_.columns.size();
  std::string rows;
  for (std::size_t row = 0; row < block_rows; ++row) {
    std::size_t number = 1 + row * parameters;
    const auto next = [&number] { return "?" + std::to_string(++number); };
    rows += std::string(row == 0 ? "" : ", ") + "(NULL, " + next() + ", ?1";
    for (int k = 0; k < 5; ++k) rows += ", " + next();
    rows += ", NULL, NULL, " + next();
    for (std::size_t k = 0; k < operation_.columns.size(); ++k) rows += ", " + next();
    rows += ")";
  }
  return insert_block_.emplace(statement("INSERT INTO ", " VALUES " + rows));
}

std::int64_t ResultTable::checksum(const Result& result, std::int64_t run, std::string_view lists) const {
  Checksum sum;
  sum.add(bytes_of(result.key)).add(std::uint64_t{result.failed()}).add(result.seconds);
  sum.add(static_cast<std::uint64_t>(run)).add(result.error).add(lists);
  return sum.add(std::span<const double>(result.values)).sum();
}

void ResultTable::each_row(std::int64_t last, bool backwards, const std::function<void(const Row&)>& take) const {
  Statement rows = statement("SELECT id, key, job, message IS NOT NULL FROM ",
                             std::string(" WHERE id > ?1 ORDER BY id") + (backwards ? " DESC" : ""));
  rows.bind(1, last);
  while (rows.step()) {
    const std::optional<JobKey> key = key_of(rows.bytes(1));
    const auto job = rows.is_null(2) ? no_job : static_cast<std::uint32_t>(rows.whole(2));
    if (key) take({rows.whole(0), *key, job, rows.whole(3) != 0});
  }
}

std::optional<Result> ResultTable::get(std::int64_t row) const {
  try {
    Statement& found = select();
    const Reading reading(found);
    if (!found.bind(1, row).step()) return std::nullopt;
    const std::optional<JobKey> key = key_of(found.bytes(0));
    if (!key) return std::nullopt;
    Result result;
    result.key = *key;
    result.run = found.whole(1);
    result.seconds = found.number(2);
    result.error = found.bytes(3);
    const std::string_view lists = found.bytes(4);
    if (!result.failed()) {
      for (std::size_t k = 0; k < operation_.columns.size(); ++k) {
        result.values.push_back(found.number(6 + static_cast<int>(k)));
      }
    }
    if (found.whole(5) != checksum(result, result.run, lists)) return std::nullopt;
    if (!result.failed()) result.lists = decoded_lists(lists, operation_.lists);
    return result;
  } catch (const DataError&) {
    return std::nullopt;
  }
}

std::int64_t ResultTable::put(std::optional<std::int64_t> row, const Result& result, std::int64_t run,
                              const Plan* plan) const {
  Statement& whole = insert();  // all parameters are bound anew, those that are NULL too
  const std::string lists = encoded_lists(result.lists, operation_.lists);
  row ? whole.bind(1, *row) : whole.bind_null(1);
  whole.bind_blob(2, bytes_of(result.key)).bind(3, run);
  const Labels labels(plan, result.job);
  labels.bind(whole, 4);
  whole.bind(8, result.seconds);
  result.failed() ? whole.bind(9, std::string_view(result.error)) : whole.bind_null(9);
  lists.empty() ? whole.bind_null(10) : whole.bind(10, std::string_view(lists));
  whole.bind(11, checksum(result, run, lists));
  for (std::size_t k = 0; k < operation_.columns.size(); ++k) {
    const int index = static_cast<int>(first_value + k);
    if (result.failed()) {
      whole.bind_null(index);
    } else {
      bind_number(whole, index, operation_.columns[k], result.values[k]);
    }
  }
  whole.run();
  return sqlite3_last_insert_rowid(database_.handle());
}

std::int64_t ResultTable::put_block(std::span<const Result* const, block_rows> results, std::int64_t run,
                                    const Plan* plan) const {
  Statement& whole = insert_block();
  std::vector<Labels> labels;
  labels.reserve(block_rows);
  whole.bind(1, run);
  int index = 2;
  for (const Result* const result : results) {
    const Labels& label = labels.emplace_back(result->job == no_job ? nullptr : plan, result->job);
    whole.bind_blob(index, bytes_of(result->key));
    label.bind(whole, index + 1);
    whole.bind(index + 5, result->seconds).bind(index + 6, checksum(*result, run, {}));
    index += fixed_parameters;
    for (std::size_t k = 0; k < operation_.columns.size(); ++k) {
      bind_number(whole, index++, operation_.columns[k], result->values[k]);
    }
  }
  whole.run();
  return sqlite3_last_insert_rowid(database_.handle());
}

void ResultTable::remove(std::int64_t row) const {
  statement("DELETE FROM ", " WHERE id = ?1").bind(1, row).run();
}

bool ResultTable::remove_failure(std::int64_t row) const {
  statement("DELETE FROM ", " WHERE id = ?1 AND message IS NOT NULL").bind(1, row).run();
  return sqlite3_changes(database_.handle()) > 0;
}

void ResultTable::label(std::int64_t row, const Plan* plan, std::uint32_t job) const {
  Statement change = statement("UPDATE ", " SET job = ?2, \"group\" = ?3, curve1 = ?4, curve2 = ?5 WHERE id = ?1");
  const Labels labels(plan, job);
  labels.bind(change.bind(1, row), 2);
  change.run();
}

}  // namespace lober::detail

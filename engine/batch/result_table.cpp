#include "engine/batch/result_table.hpp"

#include <cmath>
#include <cstring>

#include "engine/batch/checksum.hpp"
#include "engine/batch/store_schema.hpp"

namespace lober {
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

constexpr std::size_t first_value = 12;  // its place among the columns, from 1

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

void bind_number(Statement& statement, int place, const Column& column, double value) {
  constexpr double exact = 9007199254740992;  // 2^53
  if (column.kind == Column::Kind::count && std::fabs(value) < exact && std::trunc(value) == value) {
    statement.bind(place, static_cast<std::int64_t>(value));
  } else {
    statement.bind(place, value);  // NaN becomes NULL
  }
}

}  // namespace

Statement ResultTable::statement(const std::string& before, const std::string& behind) const {
  return {database_, (before + table_of(operation_) + behind).c_str()};
}

Statement& ResultTable::select() const {
  if (select_) return *select_;
  std::string columns = "SELECT key, run, seconds, message, lists, sum";
  for (const Column& column : operation_.columns) columns += ", " + quoted(column.name);
  return select_.emplace(statement(columns + " FROM ", " WHERE id = ?1"));
}

Statement& ResultTable::insert() const {
  if (insert_) return *insert_;
  std::string places = "?1";
  for (std::size_t k = 2; k <= first_value + operation_.columns.size() - 1; ++k) places += ", ?" + std::to_string(k);
  return insert_.emplace(statement("INSERT INTO ", " VALUES (" + places + ")"));
}

std::int64_t ResultTable::checksum(const Result& result, std::int64_t run, std::string_view lists) const {
  Checksum sum;
  sum.add(bytes_of(result.key)).add(std::uint64_t{result.failed()}).add(result.seconds);
  sum.add(static_cast<std::uint64_t>(run)).add(result.error).add(lists);
  if (result.failed()) return sum.sum();
  for (const double value : result.values) sum.add(value);
  return sum.sum();
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
  Statement& row_of = insert();
  const std::string lists = encoded_lists(result.lists, operation_.lists);
  row_of.clear();
  if (row) row_of.bind(1, *row);
  row_of.bind_blob(2, bytes_of(result.key)).bind(3, run).bind(8, result.seconds);
  std::string first, second;
  if (plan != nullptr) {
    const Job& job = plan->jobs[result.job];
    row_of.bind(4, std::int64_t{result.job}).bind(5, std::int64_t{job.group});
    first = plan->name(job.first);
    second = plan->name(job.second);
    if (job.first != no_curve) row_of.bind(6, std::string_view(first));
    if (job.second != no_curve) row_of.bind(7, std::string_view(second));
  }
  if (result.failed()) row_of.bind(9, std::string_view(result.error));
  if (!lists.empty()) row_of.bind_blob(10, lists);
  row_of.bind(11, checksum(result, run, lists));
  if (!result.failed()) {
    for (std::size_t k = 0; k < operation_.columns.size(); ++k) {
      bind_number(row_of, static_cast<int>(first_value + k), operation_.columns[k], result.values[k]);
    }
  }
  row_of.run();
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
  change.bind(1, row);
  std::string first, second;
  if (plan != nullptr) {
    const Job& planned = plan->jobs[job];
    change.bind(2, std::int64_t{job}).bind(3, std::int64_t{planned.group});
    first = plan->name(planned.first);
    second = plan->name(planned.second);
    if (planned.first != no_curve) change.bind(4, std::string_view(first));
    if (planned.second != no_curve) change.bind(5, std::string_view(second));
  }
  change.run();
}

}  // namespace lober

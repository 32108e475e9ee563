#include "engine/batch/store/result_table.hpp"

#include <cstring>

#include "engine/batch/store/store_schema.hpp"

namespace lober::detail {
namespace {

std::optional<JobKey> key_of(std::string_view bytes) {
  JobKey key{};
  if (bytes.size() != key.size()) return std::nullopt;
  std::memcpy(key.data(), bytes.data(), key.size());
  return key;
}

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

std::int64_t ResultTable::put(std::span<const Result* const> results, std::int64_t run, const Plan* plan,
                              std::optional<std::int64_t> row) const {
  if (!new_rows_) new_rows_ = std::make_unique<NewRows>(database_, operation_);
  return new_rows_->insert(results, run, plan, row);
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
  change.bind(1, row);  // the others are NULL unless bound
  std::string first, second;
  if (plan != nullptr) {
    const Job& planned = plan->jobs[job];
    first = plan->name(planned.first);
    second = plan->name(planned.second);
    change.bind(2, std::int64_t{job}).bind(3, std::int64_t{planned.group});
    if (planned.first != no_curve) change.bind(4, std::string_view(first));
    if (planned.second != no_curve) change.bind(5, std::string_view(second));
  }
  change.run();
}

}  // namespace lober::detail

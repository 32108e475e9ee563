// The results of one operation in a store, a row a key (private to the store).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/operations/operation.hpp"
#include "engine/batch/operations/result.hpp"
#include "engine/batch/store/database.hpp"

namespace lober::detail {

class ResultTable {
 public:
  ResultTable(const Database& database, const Operation& operation) : database_(database), operation_(operation) {}

  [[nodiscard]] const Operation& operation() const { return operation_; }

  /// Number of results that are written by one statement; and whether a result can be one of them.
  static constexpr std::size_t block_rows = 16;
  [[nodiscard]] static bool fits_block(const Result& result) {
    return !result.failed() && result.lists.empty() && result.run == 0;
  }

  struct Row {
    std::int64_t id;
    JobKey key;
    std::uint32_t job;
    bool failed;
  };
  /// Calls take(row) for the rows behind `last`, or for all from the end, as far as they can be read; rows whose key is
  /// none are left out. Throws DamagedError.
  void each_row(std::int64_t last, bool backwards, const std::function<void(const Row&)>& take) const;

  /// The result; none when it is not there or is damaged.
  [[nodiscard]] std::optional<Result> get(std::int64_t row) const;
  /// Into that row, which has to be free, or into a new one. `plan` has the job of the result, or is null. Returns the
  /// row.
  std::int64_t put(std::optional<std::int64_t> row, const Result& result, std::int64_t run, const Plan* plan) const;
  /// Results that fit into a block, by one statement, into new rows whose numbers follow each other. Returns the last.
  std::int64_t put_block(std::span<const Result* const, block_rows> results, std::int64_t run, const Plan* plan) const;
  void remove(std::int64_t row) const;
  /// False when it holds no failure.
  [[nodiscard]] bool remove_failure(std::int64_t row) const;
  /// Says which job of the plan the row is the result of; null: none.
  void label(std::int64_t row, const Plan* plan, std::uint32_t job) const;

 private:
  [[nodiscard]] Statement statement(const std::string& before, const std::string& behind) const;
  // Prepared once: their columns are many.
  [[nodiscard]] Statement& select() const;
  [[nodiscard]] Statement& insert() const;
  [[nodiscard]] Statement& insert_block() const;
  [[nodiscard]] std::int64_t checksum(const Result& result, std::int64_t run, std::string_view lists) const;

  const Database& database_;
  const Operation& operation_;
  mutable std::optional<Statement> select_, insert_, insert_block_;
};

}  // namespace lober::detail

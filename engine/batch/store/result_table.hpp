// The results of one operation in a store, a row a key (private to the store).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/operations/operation.hpp"
#include "engine/batch/operations/result.hpp"
#include "engine/batch/store/database.hpp"
#include "engine/batch/store/new_rows.hpp"

namespace lober::detail {

class ResultTable {
 public:
  ResultTable(const Database& database, const Operation& operation) : database_(database), operation_(operation) {}

  [[nodiscard]] const Operation& operation() const { return operation_; }

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
  /// See NewRows::insert.
  std::int64_t put(std::span<const Result* const> results, std::int64_t run, const Plan* plan,
                   std::optional<std::int64_t> row = {}) const;
  void remove(std::int64_t row) const;
  /// False when it holds no failure.
  [[nodiscard]] bool remove_failure(std::int64_t row) const;
  /// Says which job of the plan the row is the result of; null: none.
  void label(std::int64_t row, const Plan* plan, std::uint32_t job) const;

 private:
  [[nodiscard]] Statement statement(const std::string& before, const std::string& behind) const;
  // Prepared once: its columns are many.
  [[nodiscard]] Statement& select() const;

  const Database& database_;
  const Operation& operation_;
  mutable std::optional<Statement> select_;
  mutable std::unique_ptr<NewRows> new_rows_;
};

}  // namespace lober::detail

// A plan whose results are made up, and what SQL says about a store.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <string>
#include <vector>

#include "engine/batch/store/store.hpp"

namespace lober::detail {

/// All pairs of the curves c.0, c.1, ...
inline Plan plan_of_pairs(std::uint32_t curves, const std::string& operation = "overlay") {
  const Operation* const found = find_operation(operation);
  Plan plan;
  plan.groups.push_back({"made up", found, {found->options, {}}});
  for (std::uint32_t k = 0; k < curves; ++k) {
    plan.curves.push_back(CurveSource{"c." + std::to_string(k)});
    for (std::uint32_t i = 0; i < k; ++i) plan.jobs.push_back({0, i, k});
  }
  return plan;
}

inline JobKey key_of(int number) {
  JobKey key{};
  key[0] = static_cast<std::byte>(number);
  key[31] = std::byte{1};
  return key;
}

/// A result of a job whose key has its number too, unless another one is given; the first value is `value`.
inline Result done(std::uint32_t job, double value, int key = -1) {
  Result result;
  result.values.assign(find_operation("overlay")->columns.size(), 7);
  result.values[0] = value;
  result.seconds = 0.5;
  result.job = job;
  result.key = key_of(key < 0 ? static_cast<int>(job) : key);
  return result;
}
inline Result failure(std::uint32_t job, const std::string& message) {
  Result result;
  result.error = message;
  result.job = job;
  result.key = key_of(static_cast<int>(job));
  return result;
}

/// Rows with a blank between the columns.
inline std::vector<std::string> asked(const std::string& path, const std::string& sql) {
  std::vector<std::string> rows;
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  const auto take = [](void* into, int count, char** texts, char**) {
    std::string row;
    for (int k = 0; k < count; ++k) row += (k == 0 ? "" : " ") + std::string(texts[k] != nullptr ? texts[k] : "NULL");
    static_cast<std::vector<std::string>*>(into)->push_back(row);
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), take, &rows, nullptr), SQLITE_OK) << sqlite3_errmsg(database);
  sqlite3_close(database);
  return rows;
}

}  // namespace lober::detail

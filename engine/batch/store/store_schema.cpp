#include "engine/batch/store/store_schema.hpp"

#include <algorithm>

namespace lober::detail {
namespace {

constexpr const char* common_tables = R"(
  CREATE TABLE runs (id INTEGER PRIMARY KEY, started TEXT, ended TEXT, how TEXT, version TEXT,
    "commit" TEXT, compiler TEXT, flags TEXT, host TEXT, threads INTEGER, shard TEXT, manifest TEXT, folder TEXT);
  CREATE TABLE plan (id INTEGER PRIMARY KEY CHECK (id = 1), body BLOB, sum INTEGER);
  CREATE TABLE curves (name TEXT PRIMARY KEY, digest TEXT, sum INTEGER) WITHOUT ROWID;
  CREATE TABLE groups (id INTEGER PRIMARY KEY, name TEXT, operation TEXT, options TEXT, settings TEXT);
  CREATE TABLE repeats (job INTEGER PRIMARY KEY, "group" INTEGER, curve1 TEXT, curve2 TEXT, operation TEXT,
    result INTEGER);
)";

std::string create_table(const Operation& operation) {
  std::string sql = "CREATE TABLE " + table_of(operation) +
                    " (id INTEGER PRIMARY KEY, key BLOB, run INTEGER, job INTEGER, \"group\" INTEGER, curve1 TEXT, "
                    "curve2 TEXT, seconds, message TEXT, lists TEXT, sum INTEGER";
  for (const Column& column : operation.columns) sql += ", " + quoted_name(column.name);
  return sql + ");\n";
}

// The jobs of the present plan that have a row in the table of the operation, with the number of that row.
std::string jobs_with_rows(const Operation& operation) {
  return "(SELECT job, \"group\", curve1, curve2, id AS result FROM " + table_of(operation) +
         " WHERE job IS NOT NULL UNION ALL SELECT job, \"group\", curve1, curve2, result FROM repeats WHERE operation "
         "= '" +
         operation.name + "') AS j JOIN " + table_of(operation) +
         " AS r ON r.id = j.result LEFT JOIN groups AS g ON g.id = j.\"group\"";
}

// "intersection" is also the `area` of an overlap.
std::string create_view(const Operation& operation) {
  std::string sql = "CREATE VIEW " + quoted_name(operation.view) +
                    " AS SELECT j.job, g.name AS \"group\", g.options, g.settings, j.curve1, j.curve2";
  for (const Column& column : operation.columns) {
    if (column.name == "intersection") sql += ", r.intersection AS area";
  }
  for (const Column& column : operation.columns) sql += ", r." + quoted_name(column.name);
  return sql + ", r.lists, r.seconds FROM " + jobs_with_rows(operation) + " WHERE r.message IS NULL;\n";
}

std::string select_results(const Operation& operation) {
  return "SELECT j.job, g.name AS \"group\", '" + operation.name +
         "' AS operation, g.options, g.settings, j.curve1, j.curve2, CASE WHEN r.message IS NULL THEN 'done' ELSE "
         "'failed' END AS "
         "status, r.message,"
         " r.seconds, r.run, hex(r.key) AS key FROM " +
         jobs_with_rows(operation);
}

}  // namespace

std::string table_of(const Operation& operation) {
  return "results_" + operation.name;
}

std::string quoted_name(const std::string& name) {
  return '"' + name + '"';
}

std::string store_schema() {
  std::string sql = common_tables, all;
  for (const Operation& operation : all_operations()) {
    sql += create_table(operation) + create_view(operation);
    all += (all.empty() ? "" : " UNION ALL ") + select_results(operation);
  }
  return sql + "CREATE VIEW results AS " + all +
         ";\nCREATE VIEW failures AS SELECT job, \"group\", operation, options, settings, "
         "curve1, curve2, message FROM results WHERE status = 'failed';\n";
}

bool has_store_schema(const Database& database) {
  Database sound(":memory:", true);
  sound.execute(store_schema().c_str());
  Statement all(sound, "SELECT name, sql FROM sqlite_master WHERE sql IS NOT NULL"),
      same(database, "SELECT 1 FROM sqlite_master WHERE name = ?1 AND sql = ?2");
  while (all.step()) {
    same.bind(1, all.bytes(0)).bind(2, all.bytes(1));
    if (!same.step()) return false;
    same.reset();
  }
  return true;
}

}  // namespace lober::detail

// A thin cover of SQLite (private to engine/batch): what fails throws DataError "path: reason".
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include "lober/base/error.hpp"

namespace lober::detail {

/// The bytes of the file are not what SQLite has written.
class DamagedError : public DataError {
 public:
  using DataError::DataError;
};

class Database {
 public:
  /// Opens a file; creates it only if asked to. Waits up to a minute for other processes.
  Database(const std::string& path, bool create);

  void execute(const char* sql);
  /// Makes WAL the journal. Two processes that do so at the same time get in each other's way, and SQLite does not wait
  /// then as it does elsewhere.
  void use_write_ahead_log();
  [[nodiscard]] sqlite3* handle() const { return handle_.get(); }
  /// Throws what went wrong last: DamagedError or another DataError.
  [[noreturn]] void fail() const;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
  };
  std::string path_;
  std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement. Parameters count from 1, columns from 0. Texts and blobs must live until the next step.
class Statement {
 public:
  Statement(const Database& database, const char* sql);

  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, double value);
  Statement& bind(int parameter, std::string_view text);
  Statement& bind_blob(int parameter, std::string_view bytes);
  Statement& bind_null(int parameter) {
    sqlite3_bind_null(handle_.get(), parameter);
    return *this;
  }
  /// True when there is a row.
  bool step();
  /// Runs to the end and is ready for the next parameters.
  void run();
  void reset() { sqlite3_reset(handle_.get()); }

  [[nodiscard]] std::int64_t whole(int column) const { return sqlite3_column_int64(handle_.get(), column); }
  [[nodiscard]] bool is_null(int column) const { return sqlite3_column_type(handle_.get(), column) == SQLITE_NULL; }
  /// NULL is NaN, and the other way round.
  [[nodiscard]] double number(int column) const {
    return is_null(column) ? std::numeric_limits<double>::quiet_NaN() : sqlite3_column_double(handle_.get(), column);
  }
  [[nodiscard]] std::string_view bytes(int column) const;

 private:
  void check(int code) const {
    if (code != SQLITE_OK) database_.fail();
  }
  struct Finalize {
    void operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }
  };
  const Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

/// Rolled back unless committed. Takes the right to write at once.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) { database_.execute("BEGIN IMMEDIATE"); }
  ~Transaction() {
    if (!committed_) sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit() {
    database_.execute("COMMIT");
    committed_ = true;
  }

 private:
  Database& database_;
  bool committed_ = false;
};

}  // namespace lober::detail

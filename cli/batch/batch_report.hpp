// The texts of `lober batch run` while it works and when it is done.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "engine/batch/batch.hpp"

namespace lober::cli {

/// One line on standard error: redrawn on a terminal, else once in ten seconds.
class BatchProgress {
 public:
  BatchProgress();
  ~BatchProgress();  ///< wipes a redrawn line away
  BatchProgress(const BatchProgress&) = delete;
  BatchProgress& operator=(const BatchProgress&) = delete;
  void show(const QueueProgress& progress);

 private:
  bool terminal_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_, last_;
};

[[nodiscard]] std::string batch_summary(const BatchReport& report, const std::string& store);
void write_batch_json(const std::string& path, const BatchReport& report, const std::string& manifest,
                      const std::string& store);

/// One line each on standard error, of very many the first.
void warn_of(const std::vector<std::string>& lines);

/// Throws what the exit status asks for: DataError when jobs failed, Cancelled when it was stopped.
void judge(const BatchReport& report, const std::string& store);

}  // namespace lober::cli

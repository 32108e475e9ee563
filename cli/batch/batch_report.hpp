// The texts of `lober batch run` while it works and when it is done.
#pragma once

#include <string>
#include <vector>

#include "cli/program/progress.hpp"
#include "engine/batch/batch.hpp"

namespace lober::cli {

/// How far the queue is: jobs that are done, jobs that failed, and the part of the work by its estimated cost. Returns
/// false when the user has interrupted.
[[nodiscard]] bool report_queue(const QueueProgress& queue, Progress& progress);

[[nodiscard]] std::string batch_summary(const BatchReport& report, const std::string& store);
void write_batch_json(const std::string& path, const BatchReport& report, const std::string& manifest,
                      const std::string& store);

/// One line each on standard error, of very many the first.
void warn_of(const std::vector<std::string>& lines);

/// Throws what the exit status asks for: DataError when jobs failed, Cancelled when it was stopped.
void judge(const BatchReport& report, const std::string& store);

}  // namespace lober::cli

#include "cli/batch/batch_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "cli/program/log.hpp"
#include "cli/report/json.hpp"
#include "cli/report/report.hpp"

namespace lober::cli {
namespace {

// Shares of the time that the threads had.
struct Shares {
  double reading, preparing, operations, storing;
};
Shares shares_of(const BatchReport& report) {
  const double available = std::max(report.wall_seconds, 1e-9);
  const double threads = available * std::max(report.queue.threads, 1);
  return {report.queue.cache.read_seconds / threads, report.queue.cache.prepare_seconds / threads,
          report.queue.operation_seconds / threads, report.store_seconds / threads};
}

}  // namespace

bool report_queue(const QueueProgress& queue, Progress& progress) {
  if (queue.failed != 0) progress.label(fmt::format("jobs ({} of {} failed)", queue.failed, queue.done));
  progress.count(static_cast<double>(queue.done), "jobs");
  return progress.advance(queue.cost > 0 ? std::min(queue.cost_done / queue.cost, 1.0) : 0);
}

std::string batch_summary(const BatchReport& report, const std::string& store) {
  const QueueReport& queue = report.queue;
  const Shares shares = shares_of(report);
  const double seconds = std::max(report.wall_seconds, 1e-9);
  std::string text = fmt::format("{}: {} done before, {} run, {} failed\n", counted(report.jobs, "job", "jobs"),
                                 report.finished_before, queue.jobs, queue.failed);
  text += fmt::format("{:.3f} s on {}: {:.0f} jobs a second, {:.3g} points a second\n", report.wall_seconds,
                      counted(static_cast<std::size_t>(queue.threads), "thread", "threads"),
                      static_cast<double>(queue.jobs) / seconds, static_cast<double>(queue.points) / seconds);
  text += fmt::format("read {}, at most {} each, indexed {}, dropped {}; at most {:.1f} MB booked\n",
                      counted(queue.cache.units_read, "file", "files"), counted(queue.cache.max_reads, "time", "times"),
                      counted(queue.cache.curves_indexed, "curve", "curves"), queue.cache.evictions,
                      static_cast<double>(queue.cache.peak_bytes) / 1e6);
  text += fmt::format("time of the threads: reading {:.1f} %, indexing {:.1f} %, jobs {:.1f} %, storing {:.1f} %\n",
                      100 * shares.reading, 100 * shares.preparing, 100 * shares.operations, 100 * shares.storing);
  text += "results in " + store + "\n";
  if (report.hidden != 0) {
    text += fmt::format(
        "it has {} of another manifest or of earlier inputs too: status, exports and views show this manifest alone; "
        "give "
        "each manifest a --store of its own\n",
        counted(report.hidden, "result", "results"));
  }
  if (report.stored_meanwhile != 0) {
    text += fmt::format("{} had been stored by another process meanwhile; give parallel processes --shard\n",
                        counted(report.stored_meanwhile, "result", "results"));
  }
  return text;
}

void write_batch_json(const std::string& path, const BatchReport& report, const std::string& manifest,
                      const std::string& store) {
  const QueueReport& queue = report.queue;
  const CacheCounts& cache = queue.cache;
  const Json object{{"program", program_json()},
                    {"command", "batch run"},
                    {"manifest", manifest},
                    {"store", store},
                    {"jobs", report.jobs},
                    {"finished_before", report.finished_before},
                    {"run", queue.jobs},
                    {"failed", queue.failed},
                    {"stopped", queue.stopped},
                    {"hidden", report.hidden},
                    {"stored_meanwhile", report.stored_meanwhile},
                    {"damaged", report.damaged.size()},
                    {"warnings", queue.warnings},
                    {"points", queue.points},
                    {"files_read", cache.units_read},
                    {"max_reads_of_a_file", cache.max_reads},
                    {"curves_indexed", cache.curves_indexed},
                    {"files_dropped", cache.evictions},
                    {"peak_bytes_booked", cache.peak_bytes},
                    {"timing",
                     {{"threads", queue.threads},
                      {"reading", cache.read_seconds},
                      {"indexing", cache.prepare_seconds},
                      {"operations", queue.operation_seconds},
                      {"handing_over", queue.callback_seconds},
                      {"storing", report.store_seconds},
                      {"queue", queue.wall_seconds},
                      {"total", report.wall_seconds}}}};
  write_file(path, dumped(object) + "\n");
}

void warn_of(const std::vector<std::string>& lines) {
  constexpr std::size_t most = 20;
  for (std::size_t k = 0; k < std::min(most, lines.size()); ++k) log_warning(lines[k]);
  if (lines.size() > most) log_warning(fmt::format("and {} more such lines", lines.size() - most));
}

void judge(const BatchReport& report, const std::string& store) {
  if (report.queue.stopped) throw Cancelled();
  if (report.queue.failed != 0) {
    throw DataError(counted(report.queue.failed, "job", "jobs") + " failed, see lober batch status " + store);
  }
}

}  // namespace lober::cli

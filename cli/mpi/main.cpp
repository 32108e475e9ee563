// `lober_mpi`: `lober batch run` over several machines.
//
//   mpirun -n 8 lober_mpi job.toml --threads 4
//
// The plan is made on rank 0 and sent to all; files are read by the ranks that need them, from where rank 0 found them.
// If a rank fails or dies, all of them are ended; what was committed stays, and the next run goes on from there.

#include <mpi.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <thread>

#include "cli/batch/batch_options.hpp"
#include "cli/batch/batch_report.hpp"
#include "cli/mpi/messages.hpp"
#include "cli/mpi/ranks.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/interrupt.hpp"
#include "cli/program/log.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/batch/plan_outputs.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

// Cores of this machine for each of its ranks.
int fair_threads() {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int here = 1;
  MPI_Comm_size(machine, &here);
  MPI_Comm_free(&machine);
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / here);
}

void run_coordinator(const BatchRequest& request, SharedWork& work, int ranks) {
  const detail::Stopwatch watch;
  detail::Manifest manifest;
  std::string plan;
  try {
    manifest = detail::read_manifest(request.manifest);
    work.plan = detail::make_plan(manifest);
    accept_outputs(detail::output_folder_of(request.output_root, request.manifest, work.plan, request.store),
                   request.manifest, work.plan);
    plan = work.plan.encoded();
  } catch (...) {
    broadcast(plan);  // nothing: the others leave
    throw;
  }
  std::atomic<bool> broken = false;
  std::optional<detail::StoreSession> opened;
  try {
    opened.emplace(request.store, work.plan, manifest, request.shard, work.queue.threads * ranks,
                   [&] { broken = true; });
  } catch (...) {
    broadcast(plan = "");
    throw;
  }
  detail::StoreSession& session = *opened;
  broadcast(plan);
  watch_for_interrupt();
  BatchReport report;
  {
    Progress progress;
    progress.phase("jobs", 0, 1);
    report = coordinate(
        work, session, ranks, [&](const QueueProgress& queue) { return report_queue(queue, progress); }, broken);
  }
  report.jobs = session.pending().size() + session.finished_before();
  report.finished_before = session.finished_before();
  report.damaged = session.damaged();
  warn_of(report.damaged);
  report.store_seconds = session.finish(report.queue.stopped ? "stopped" : "complete");
  report.wall_seconds = watch.seconds();
  report.queue.threads = work.queue.threads * ranks;
  if (!request.json.empty()) write_batch_json(request.json, report, request.manifest, request.store);
  if (request.json != "-") print(batch_summary(report, request.store));
  judge(report, request.store);
}

// The request, or none when there is nothing to do; then `status` is the exit status of all ranks, also when the
// command line of only one of them cannot be understood. Says why on the first rank that knows.
std::optional<BatchRequest> agreed_request(const std::vector<std::string>& arguments, int rank, int ranks,
                                           int& status) {
  std::optional<BatchRequest> request;
  Failure failure{{}, 0};
  try {
    request = parse_batch(arguments, "lober_mpi");
  } catch (...) {
    failure = failure_of(std::current_exception());
  }
  const int speaks = failure.status != 0 ? rank : ranks, wants = request ? 1 : 0;
  int speaker = ranks, all_want = 0;
  MPI_Allreduce(&failure.status, &status, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Allreduce(&speaks, &speaker, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  MPI_Allreduce(&wants, &all_want, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (rank == speaker) log_error(failure.message);
  return all_want != 0 ? request : std::nullopt;
}

int run_rank(const std::vector<std::string>& arguments) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  int status = 0;
  const std::optional<BatchRequest> request = agreed_request(arguments, rank, ranks, status);
  if (!request) return status;
  SharedWork work;
  work.manifest_path = request->manifest;
  work.store = request->store;
  work.output_root = request->output_root;
  const int fair = fair_threads();  // by all ranks together, also by those that are given one
  work.queue.threads = request->threads > 0 ? request->threads : fair;
  work.queue.memory = request->memory;
  run_with_threads(work.queue.threads, [&] {
    if (rank == 0) return run_coordinator(*request, work, ranks);
    std::string plan;
    broadcast(plan);
    if (!plan.empty()) work_for_coordinator(work, plan);
  });
  return 0;
}

}  // namespace
}  // namespace lober::cli

int main(int count, char** arguments) {
  int provided = 0;
  MPI_Init_thread(&count, &arguments, MPI_THREAD_SERIALIZED, &provided);
  lober::cli::begin_log("lober_mpi");
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of the write, with a message
  int status = 0;
  try {
    if (provided < MPI_THREAD_SERIALIZED)
      throw lober::UsageError("this MPI library does not support MPI_THREAD_SERIALIZED, which lober_mpi needs");
    status = lober::cli::run_rank({arguments + 1, arguments + count});
  } catch (...) {  // where no other rank waits for this one
    const lober::cli::Failure failure = lober::cli::failure_of(std::current_exception());
    lober::cli::log_error(failure.message);
    status = failure.status;
  }
  MPI_Finalize();
  return status;
}

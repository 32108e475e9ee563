#include "cli/batch/batch_page.hpp"

#include <spdlog/fmt/fmt.h>

#include <chrono>
#include <thread>

#include "cli/batch/batch_report.hpp"
#include "cli/batch/page_columns.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/interrupt.hpp"
#include "cli/program/option_parser.hpp"
#include "cli/program/output_names.hpp"
#include "lober/base/cancellation.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/files.hpp"
#include "viewer/page.hpp"

namespace lober::cli {
namespace {

struct PageRequest {
  std::string store, output;
  double every = 0;
};

ExportCounts write_batch_page(const PageRequest& request) {
  ExportCounts counts;
  const std::string json = jobs_json(request.store, counts);
  write_file(request.output, viewer::batch_page_of("Batch " + request.store, json));
  return counts;
}

// Sleeps in short steps; throws Cancelled at an interrupt.
void wait(double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (Clock::now() < end) {
    if (interrupted()) throw Cancelled();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

}  // namespace

void run_batch_page(const std::vector<std::string>& arguments) {
  PageRequest request;
  OptionParser parser(
      "Writes a page of the jobs of a store: a table to filter and sort, and heat maps of their numbers over curves, "
      "parameters or lobes. It opens in any browser, without a network.",
      "lober batch page");
  parser.add_example("lober batch page job.results -o job.html", "the results that are there now");
  parser.add_example("lober batch page job.results -o job.html --every 10",
                     "written again every ten seconds until all jobs are done: reload it");
  parser.add("STORE", request.store, "The store, a file that lober batch run has written.").required();
  parser.add("-o,--output", request.output, "Write the page to FILE.").value("FILE").required();
  parser
      .add("--every", request.every,
           "The time in seconds after which the page is written again, until no job is left (default: it is written "
           "once).")
      .positive()
      .value("SECONDS");
  if (!parser.parse(arguments)) return;
  require_fitting_name("--html", request.output);
  check_outputs(std::vector<Output>{{"-o", request.output}}, std::vector{request.store});
  ExportCounts counts = write_batch_page(request);
  while (request.every > 0 && counts.missing > 0) {
    wait(request.every);
    counts = write_batch_page(request);
  }
  if (request.output != "-") {
    print(
        fmt::format("{} done, {} failed, {} to do: {}\n", counts.done, counts.failed, counts.missing, request.output));
  }
  warn_of(counts.damaged);
}

}  // namespace lober::cli

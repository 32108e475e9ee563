// `lober batch`: the subcommands.

#include "cli/batch/batch_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "cli/batch/batch_options.hpp"
#include "cli/batch/batch_page.hpp"
#include "cli/batch/batch_picture.hpp"
#include "cli/batch/batch_report.hpp"
#include "cli/batch/operations_list.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/help_text.hpp"
#include "cli/program/interrupt.hpp"
#include "cli/program/wrapped_text.hpp"
#include "cli/program/written_files.hpp"
#include "cli/report/report.hpp"
#include "engine/base/machine_memory.hpp"
#include "engine/base/nearest_word.hpp"
#include "engine/batch/export/export.hpp"
#include "engine/batch/forecast.hpp"
#include "engine/batch/plan_outputs.hpp"
#include "lober/base/cancellation.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

using Arguments = std::vector<std::string>;

std::string how_far(const ExportCounts& counts) {
  return fmt::format("{} done, {} failed, {} to do\n", counts.done, counts.failed, counts.missing);
}

double jobs_of(const detail::Store& store) {
  const std::optional<detail::Plan> plan = store.plan();
  return plan ? static_cast<double>(plan->jobs.size()) : 0;
}

// Each message once, and where to find the others of a long list.
std::string failures_text(const detail::StoreSurvey& found, const std::string& store) {
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, found.failures.size()); ++k) {
    const detail::StoreSurvey::Failure& failure = found.failures[k];
    text += failure.jobs == 1 ? "" : fmt::format("{} jobs failed, first ", failure.jobs);
    text += failure.first + ": " + failure.message + "\n";
  }
  if (found.failures.size() > most) {
    text += fmt::format("and {}\n", counted(found.failures.size() - most, "other message", "other messages"));
  }
  if (!found.failures.empty()) {
    text += "lober batch export " + store +
            " --format jsonl lists every job that failed; the next lober batch run runs them again\n";
  }
  return text;
}

// Advice for a word that is not a subcommand, if it is a file.
std::string advice_for_file(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  if (path.ends_with(".toml")) return ", but a file; give lober batch run " + path;
  const std::filesystem::path file(path);
  const std::string pattern = (file.parent_path() / ("*" + file.extension().string())).string();
  return ", but a file; write a manifest of three lines, operation = \"overlay\", curves = \"" + pattern +
         "\" and pairs = \"all\", and give it to lober batch run";
}

void run_manifest(const Arguments& arguments) {
  const std::optional<BatchRequest> request = parse_batch(arguments);
  if (!request) return;
  if (!request->json.empty()) {
    const std::vector<Output> outputs{{"--json", request->json}};
    check_outputs(outputs, std::vector{request->manifest, request->store});
  }
  const detail::Manifest manifest = detail::read_manifest(request->manifest);
  expect_written("--store", request->store);
  BatchReport report;
  run_with_threads(request->threads, [&] {
    Progress progress;
    progress.phase("jobs", 0, 1);
    BatchOptions options;
    options.store = request->store;
    options.output_root = request->output_root;
    options.shard = request->shard;
    options.queue.threads = request->threads;
    options.queue.memory = request->memory;
    options.progress = [&](const QueueProgress& queue) { return report_queue(queue, progress); };
    report = run_batch(manifest, options);
    progress.count(static_cast<double>(report.queue.jobs), "jobs");
  });
  const CancellationScope shield(CancellationScope::Shield{});  // what was done is reported in any case
  warn_of(report.damaged);
  warn_of(report.queue.warnings);
  if (!request->json.empty()) write_batch_json(request->json, report, request->manifest, request->store);
  if (request->json != "-") print(batch_summary(report, request->store));
  judge(report, request->store);
}

void check_manifest(const Arguments& arguments) {
  std::string path, output_root;
  std::uint64_t memory = 0;
  OptionParser parser(
      "Reads a manifest and reports the number of its jobs, curves and points, and the work that the memory is too "
      "small for. Nothing is computed but what shows in a few seconds how long it takes.",
      "lober batch check");
  parser.add_example("lober batch check job.toml", "the work that the manifest asks for");
  parser.add_example("lober batch check job.toml --memory 4G", "and whether 4 GB are enough for it");
  parser.add("MANIFEST", path, "The manifest, a TOML file that names the operation and the curves.").required();
  add_output_root_option(parser, output_root);
  const Option memory_given = add_memory_budget(parser, memory);
  if (!parser.parse(arguments)) return;
  const std::size_t budget = memory_given.given() ? memory : detail::machine_memory() / 2;
  const detail::Plan plan = detail::make_plan(detail::read_manifest(path));
  accept_outputs(detail::output_folder_of(output_root, path, plan, default_store(path)), path, plan);
  const detail::Estimate sum = estimate(plan, path);
  std::string text = fmt::format("{} on {} of {}\n", counted(sum.jobs, "job", "jobs"),
                                 counted(sum.curves, "curve", "curves"), counted(sum.files, "file", "files"));
  if (sum.computed > 0)
    text += fmt::format("{} by computation, whose points are a guess\n",
                        counted(sum.computed, "curve or family", "curves or families"));
  std::vector<std::size_t> jobs(plan.groups.size());
  for (const detail::Job& job : plan.jobs) ++jobs[job.group];
  constexpr std::size_t max_listed = 10;
  const std::size_t listed = plan.groups.size() > max_listed + 1 ? max_listed : plan.groups.size();
  for (std::size_t k = 0; k < listed; ++k) {
    const detail::JobGroup& group = plan.groups[k];
    text += fmt::format("  {:>9}  {}{}  {}\n", jobs[k], group.name.empty() ? "" : group.name + ": ",
                        group.operation->name, group.options.to_string());
  }
  if (listed < plan.groups.size()) {
    text += fmt::format("  and {} more settings of options, which a grid makes\n", plan.groups.size() - listed);
  }
  text += fmt::format("about {:.3g} points, {:.3g} over all jobs\n", static_cast<double>(sum.points),
                      static_cast<double>(sum.points_in_jobs));
  text += fmt::format("about {:.1f} MB for all curves at once\n", static_cast<double>(sum.memory) / 1e6);
  text += fmt::format("about {:.2g} s on one core if curves cross a few times; dense tangles take longer\n",
                      sum.core_seconds);
  if (sum.pilots > 0) {
    text += "the time of escapes is judged by " + counted(sum.pilots, "coarse one", "coarse ones") +
            " that this check has run\n";
  }
  const bool usual = std::any_of(plan.jobs.begin(), plan.jobs.end(), [&](const detail::Job& job) {
    return job.curves().size() == 0 && !plan.group_of(job).operation->pilot;
  });
  if (usual) {
    text += "jobs without curves are counted with the time of a usual one; options make them far shorter or longer\n";
  }
  print(text);
  warn_of(detail::forecast_shortage(plan, path, budget));
}

void show_status(const Arguments& arguments) {
  std::string path;
  OptionParser parser(
      "Reports how many jobs of a store are done, the runs that computed them, and the jobs that failed.",
      "lober batch status");
  parser.add_example("lober batch status job.results", "how far the runs of job.toml are");
  parser.add_example("lober batch status job1.results", "and of one shard");
  parser.add("STORE", path, "The store, a file that lober batch run has written.").required();
  if (!parser.parse(arguments)) return;
  const detail::Store store = detail::Store::open(path);
  Progress progress;
  progress.of(jobs_of(store), "jobs");
  progress.phase("checking", 0, 1);
  const detail::StoreSurvey found = survey(store, told_to(progress));
  std::string text = how_far(found.counts);
  for (const detail::Store::Run& run : store.runs()) {
    text += fmt::format("run {}: {} to {} {}, lober {} ({}), {}, {} ({}), shard {}\n", run.id, run.started,
                        run.ended.empty() ? "?" : run.ended, run.how.empty() ? "broken off" : run.how, run.version,
                        run.commit, run.host, run.compiler, run.flags, run.shard);
  }
  text += failures_text(found, path);
  print(text);
  warn_of(found.counts.damaged);
}

void export_store(const Arguments& arguments) {
  std::string path, output = "-", format, operation;
  OptionParser parser("Writes the results of a store as a table.", "lober batch export");
  parser.add_example("lober batch export job.results", "all results as CSV on standard output");
  parser.add_example("lober batch export job.results -o all.jsonl",
                     "with lists and messages, an object of JSON a line");
  parser.add("STORE", path, "The store, a file that lober batch run has written.").required();
  parser
      .add("-o,--output", output,
           "Write the table to FILE, whose ending .csv, .jsonl, .npy, .nc (NetCDF) or .h5 (HDF5) is its format "
           "(default: standard "
           "output).")
      .value("FILE");
  parser
      .add("--format", format,
           "The format of the table: csv, jsonl, npy, nc or h5 (default: by the ending of FILE, or csv).")
      .value("KIND")
      .one_of({"csv", "jsonl", "npy", "nc", "h5"});
  parser
      .add(
          "--operation", operation,
          "The operation whose results are exported (default: all operations; a table in csv, npy, nc or h5 holds one, "
          "which has to be named if the store has several).")
      .value("NAME");
  if (!parser.parse(arguments)) return;
  const std::string by_name = !format.empty() ? "." + format : output == "-" ? ".csv" : output;
  const std::optional<std::string> only = operation.empty() ? std::nullopt : std::optional(operation);
  const ExportFormat kind = export_format(by_name);
  const detail::Store store = detail::Store::open(path);
  if (output != "-") expect_written("-o", output);
  ExportCounts counts;
  {
    Progress progress;
    progress.phase("exporting", 0, 1);
    progress.of(jobs_of(store), "jobs");
    counts = export_results(store, output, kind, only, told_to(progress));
  }
  if (output != "-") {
    print(fmt::format("{} done, {} failed, {} not there yet\n", counts.done, counts.failed, counts.missing));
  }
  warn_of(counts.damaged);
}

void run_merge(const Arguments& arguments) {
  std::string target;
  std::vector<std::string> sources;
  OptionParser parser("Joins stores of the same plan, as shards write them, into one.", "lober batch merge");
  parser.add_example("lober batch merge all.results job1.results job2.results", "the results of two shards");
  parser.add_example("lober batch merge job.results more.results", "adds results to a store");
  parser.add("TARGET", target, "The store that takes the results, which is created if it does not exist.").required();
  parser.add("STORES", sources, "The stores whose results are copied.").required();
  if (!parser.parse(arguments)) return;
  expect_written("TARGET", target);
  Progress progress;
  progress.phase("merging", 0, 0.6);
  warn_of(merge_stores(target, sources, told_to(progress)));
  progress.phase("checking", 0.6, 1);
  const ExportCounts counts = survey(detail::Store::open(target), told_to(progress)).counts;
  print(how_far(counts));
  warn_of(counts.damaged);
}

struct Subcommand {
  std::string_view verb;
  void (*run)(const Arguments& arguments);
  std::string_view call, title;
};

constexpr Subcommand subcommands[]{
    {"run", run_manifest, "MANIFEST [options]",
     "computes the results that are not in the store yet; the first interrupt lets running jobs finish within a "
     "second, "
     "a second one stops at once; nothing that was stored is lost"},
    {"check", check_manifest, "MANIFEST", "reads the manifest and reports how much work it is"},
    {"status", show_status, "STORE", "reports the jobs that are done, the runs and the failures"},
    {"export", export_store, "STORE [-o FILE]", "writes the results as CSV, JSON lines, NPY, NetCDF or HDF5"},
    {"page", run_batch_page, "STORE -o FILE", "writes a page with a table of the jobs and heat maps"},
    {"picture", run_batch_picture, "STORE --picture FILE",
     "draws a number of the jobs over two options, or overlaps of lobes, as a heat map"},
    {"merge", run_merge, "TARGET STORE...", "joins the stores of shards"},
    {"manifest", show_manifest_keys, "", "lists the keys of a manifest"},
    {"operations", show_operations, "[NAME]", "lists the operations, or the options and results of one"},
};

constexpr const char* manifest_example = R"(A manifest for all pairs of a family of files, relative to its folder:
  operation = "overlay"
  curves = "separ.*"
  pairs = "all"
)";

std::string batch_help() {
  const std::size_t width = text_width();
  std::string text =
      wrapped("Computes many curves and pairs, as a manifest says, and keeps the results in a store.", width);
  text += "\n\n" + examples_text({{"lober batch run job.toml", "all jobs of the manifest that have no result yet"},
                                  {"lober batch export job.results -o areas.csv", "a table of the results"}});
  text += "\n" +
          wrapped("Usage: lober batch SUBCOMMAND ... (lober batch SUBCOMMAND --help lists its options)", width, 9) +
          "\n\nSubcommands:\n";
  for (const Subcommand& one : subcommands) {
    const std::string call = "lober batch " + std::string(one.verb) + (one.call.empty() ? "" : " ");
    text += list_entry(call + std::string(one.call), one.title, 40, width);
  }
  return text + "\n" + manifest_example + "\n" + reference_line(anchor_of("lober batch run"), width);
}

}  // namespace

std::vector<std::string> batch_verbs() {
  std::vector<std::string> verbs;
  for (const Subcommand& one : subcommands) verbs.emplace_back(one.verb);
  return verbs;
}

void run_batch_command(const Arguments& arguments) {
  const std::vector<std::string> verbs = batch_verbs();
  if (arguments.empty()) {
    throw UsageError("a subcommand is missing; give " + detail::joined(verbs) + " (see lober batch --help)");
  }
  const std::string& verb = arguments[0];
  if (verb == "--help" || verb == "-h") return print(batch_help());
  for (const Subcommand& one : subcommands) {
    if (verb == one.verb) return one.run({arguments.begin() + 1, arguments.end()});
  }
  const std::string advice = advice_for_file(verb);
  throw UsageError(
      "\"" + verb + "\" is not a subcommand of lober batch" +
      (advice.empty() ? "; there are " + detail::joined(verbs) + detail::did_you_mean(verb, verbs) : advice));
}

}  // namespace lober::cli

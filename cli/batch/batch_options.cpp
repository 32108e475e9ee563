#include "cli/batch/batch_options.hpp"

#include <charconv>
#include <filesystem>

#include "cli/program/command_line.hpp"

namespace lober::cli {
namespace {

Shard parse_shard(const std::string& text) {
  constexpr std::size_t max_shards = 0xffffffff;
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, shard.number);
  if (first == std::errc{} && slash != end && *slash == '/') {
    const auto [stop, second] = std::from_chars(slash + 1, end, shard.of);
    if (second == std::errc{} && stop == end && shard.number >= 1 && shard.number <= shard.of &&
        shard.of <= max_shards) {
      --shard.number;
      return shard;
    }
  }
  throw UsageError("--shard: \"" + text +
                   "\" is not of the form I/N with 1 <= I <= N <= " + std::to_string(max_shards));
}

}  // namespace

Option add_memory_budget(OptionParser& parser, std::uint64_t& bytes) {
  return add_memory_option(parser, bytes,
                           "The memory budget for curves and the work on them, in bytes or with a unit, as 4G or 500M "
                           "(default: half of the machine's memory).");
}

void add_output_root_option(OptionParser& parser, std::string& folder) {
  parser
      .add("--output-root", folder,
           "The folder below which jobs write their files, and which names of outputs are relative to (default: the "
           "folder of the manifest).")
      .value("DIR");
}

std::string default_store(const std::string& manifest) {
  return std::filesystem::path(manifest).replace_extension(".results");
}

std::optional<BatchRequest> parse_batch(const std::vector<std::string>& arguments) {
  BatchRequest request;
  std::string shard;
  std::uint64_t memory = 0;
  OptionParser parser(
      "Runs the jobs of a manifest that have no result in the store yet. lober batch manifest lists the keys of a "
      "manifest.",
      "lober batch run");
  parser.add_example("lober batch run job.toml", "all jobs that have no result yet; results go to job.results");
  parser.add_example("lober batch run job.toml --shard 1/2 --store job1.results", "the first half of the jobs");
  parser.add("MANIFEST", request.manifest, "The manifest, a TOML file that names the operation and the curves.")
      .required();
  parser
      .add("--store", request.store,
           "The store of results, a SQLite file, which is created if it does not exist (default: MANIFEST with the "
           "ending .results).")
      .value("FILE");
  add_output_root_option(parser, request.output_root);
  add_threads_option(parser, request.threads);
  const Option memory_given = add_memory_budget(parser, memory);
  const Option shard_given =
      parser
          .add("--shard", shard,
               "The part of the jobs to run, I of N with 1 <= I <= N (default: 1/1, all jobs). lober batch merge joins "
               "the stores of all parts.")
          .value("I/N");
  add_json_option(parser, request.json, "a report of the run");
  if (!parser.parse(arguments)) return std::nullopt;
  if (memory_given.given()) request.memory = memory;
  if (shard_given.given()) request.shard = parse_shard(shard);
  if (request.store.empty()) request.store = default_store(request.manifest);
  return request;
}

}  // namespace lober::cli

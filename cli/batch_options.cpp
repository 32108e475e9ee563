#include "cli/batch_options.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>

#include "cli/command_line.hpp"

namespace lober::cli {
namespace {

Shard parse_shard(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, shard.number);
  if (first == std::errc{} && slash != end && *slash == '/') {
    const auto [stop, second] = std::from_chars(slash + 1, end, shard.of);
    if (second == std::errc{} && stop == end && shard.number >= 1 && shard.number <= shard.of) {
      --shard.number;
      return shard;
    }
  }
  throw UsageError("--shard: \"" + text + "\" is not I/N with 1 <= I <= N");
}

}  // namespace

std::size_t parse_memory(const std::string& text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const std::string unit(stop, end);
  const double factor = unit.empty()                                 ? 1
                        : unit == "k" || unit == "K" || unit == "kB" ? 0x1p10
                        : unit == "M" || unit == "MB"                ? 0x1p20
                        : unit == "G" || unit == "GB"                ? 0x1p30
                        : unit == "T" || unit == "TB"                ? 0x1p40
                                                                     : 0;
  if (error != std::errc{} || !(number > 0) || factor == 0 || number * factor > 0x1p60) {
    throw UsageError("--memory: \"" + text + "\" is not a size like 4G or 500M");
  }
  return static_cast<std::size_t>(number * factor);
}

std::string default_store(const std::string& manifest) {
  return std::filesystem::path(manifest).replace_extension(".results");
}

std::optional<BatchRequest> parse_batch(const std::vector<std::string>& arguments, const char* program) {
  BatchRequest request;
  std::string memory, shard;
  CLI::App app("Runs what a manifest asks for and the store does not have yet. The manifest: engine/jobs/manifest.hpp.",
               program);
  app.add_option("MANIFEST", request.manifest, "what to compute (TOML)")->required();
  app.add_option("--store", request.store, "where results go (default: MANIFEST with .results for .toml)")
      ->type_name("FILE");
  add_threads_option(app, request.threads);
  app.add_option("--memory", memory, "for curves and the work on them, like 4G (default: half of the machine's)")
      ->type_name("SIZE");
  app.add_option("--shard", shard, "only part I of N; join the stores with lober batch merge")->type_name("I/N");
  app.add_option("--json", request.json, "write a report as one JSON object (- for standard output)")
      ->type_name("FILE");
  app.add_flag("-q,--quiet", request.quiet, "no progress on standard error");
  if (!parse_arguments(app, arguments)) return std::nullopt;
  if (app.count("--memory") != 0) request.memory = parse_memory(memory);
  if (app.count("--shard") != 0) request.shard = parse_shard(shard);
  for (const char* const name : {"--store", "--json"}) {
    if (app.count(name) != 0 && app[name]->as<std::string>().empty()) {
      throw UsageError(std::string(name) + ": the name of the file is empty");
    }
  }
  if (request.store.empty()) request.store = default_store(request.manifest);
  return request;
}

}  // namespace lober::cli

#include "cli/batch/batch_options.hpp"

#include <charconv>
#include <filesystem>

#include "cli/program/command_line.hpp"

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

Option add_memory_option(OptionParser& parser, std::uint64_t& bytes) {
  return parser
      .add("--memory", bytes, "for curves and the work on them, like 4G or 500M (default: half of the machine's)")
      .bytes()
      .range(std::uint64_t{1}, std::uint64_t{1} << 60)
      .value("SIZE");
}

std::string default_store(const std::string& manifest) {
  return std::filesystem::path(manifest).replace_extension(".results");
}

std::optional<BatchRequest> parse_batch(const std::vector<std::string>& arguments, const char* program) {
  BatchRequest request;
  std::string shard;
  std::uint64_t memory = 0;
  OptionParser parser(
      "Runs what a manifest asks for and the store does not have yet. The manifest: engine/batch/manifest.hpp.",
      program);
  parser.add("MANIFEST", request.manifest, "what to compute (TOML)").required();
  parser.add("--store", request.store, "where results go (default: MANIFEST with .results for .toml)").value("FILE");
  add_threads_option(parser, request.threads);
  const Option memory_given = add_memory_option(parser, memory);
  const Option shard_given =
      parser.add("--shard", shard, "only part I of N; join the stores with lober batch merge").value("I/N");
  parser.add("--json", request.json, "write a report as one JSON object (- for standard output)").value("FILE");
  parser.add_flag("-q,--quiet", request.quiet, "no progress on standard error");
  if (!parser.parse(arguments)) return std::nullopt;
  if (memory_given.given()) request.memory = memory;
  if (shard_given.given()) request.shard = parse_shard(shard);
  if (request.store.empty()) request.store = default_store(request.manifest);
  return request;
}

}  // namespace lober::cli

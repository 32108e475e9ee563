// The options of `lober batch run`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/program/option_parser.hpp"
#include "engine/batch/batch.hpp"

namespace lober::cli {

struct BatchRequest {
  std::string manifest, store, output_root, json;
  Shard shard;
  std::size_t memory = 0;
  int threads = 0;
};

/// Nothing when the arguments asked for help, which is printed. Throws UsageError.
[[nodiscard]] std::optional<BatchRequest> parse_batch(const std::vector<std::string>& arguments);

/// --memory SIZE, for curves and the work on them.
Option add_memory_budget(OptionParser& parser, std::uint64_t& bytes);

/// --output-root DIR, below which jobs write their files.
void add_output_root_option(OptionParser& parser, std::string& folder);

/// The store of a manifest unless another one is named: beside it, .results instead of .toml.
[[nodiscard]] std::string default_store(const std::string& manifest);

}  // namespace lober::cli

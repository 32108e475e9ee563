// The JSON object of an operation of the table.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/report/json_file.hpp"
#include "engine/base/output_file.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

/// `inputs`: members that say what it was run with. Options that were not given and have no default are null. `timing`
/// is asked for when all but that is written. `more` writes further members before it, each up to and with ",\n".
void write_outcome_json(const std::string& path, std::string_view command,
                        const std::vector<std::pair<std::string, Json>>& inputs, const operations::Operation& operation,
                        const operations::Outcome& outcome, const std::function<Json()>& timing,
                        const std::function<void(detail::OutputFile&)>& more = {});

}  // namespace lober::cli

// The files that the jobs of a plan write.
#pragma once

#include <string>

#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/operations/output_folder.hpp"

namespace lober::detail {

/// The folder below which they stay, with the inputs of the plan taken down.
[[nodiscard]] OutputFolder output_folder_of(const std::string& root, const std::string& manifest_path, const Plan& plan,
                                            const std::string& store);

/// Accepts the outputs of all jobs. Throws UsageError "MANIFEST: options.output: ...", also where two jobs share one.
void accept_outputs(const OutputFolder& folder, const std::string& manifest_path, const Plan& plan);

}  // namespace lober::detail

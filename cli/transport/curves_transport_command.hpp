#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// Whether `lober transport` is asked about curves of files: --manifolds among its arguments.
[[nodiscard]] bool names_manifolds(const std::vector<std::string>& arguments);

/// `lober transport --manifolds FILE ...`. Throws UsageError, DataError, Cancelled, DisagreementError.
void run_curves_transport(const std::vector<std::string>& arguments);

}  // namespace lober::cli

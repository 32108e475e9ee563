// `lober doctor`: the program, the machine and a self-test, for a report of a bug.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// Prints the report, or writes it with --json. Throws UsageError; DataError, after the report, where the self-test
/// fails or the folder for temporary files cannot be written.
void run_doctor(const std::vector<std::string>& arguments);

}  // namespace lober::cli

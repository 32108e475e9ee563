// Texts of every command where two independent routes lead to one quantity (engine/lober/base/agreement.hpp).
#pragma once

#include <string>

#include "cli/report/json.hpp"
#include "cli/report/json_file.hpp"
#include "lober/base/agreement.hpp"

namespace lober::cli {

/// The first line of a command's output when routes disagree; empty when all agree:
/// "DISAGREEMENT: T12(3) is 0.9269 by lobes and 0.7850 by boundaries; they differ by 1.4e-01, their error bars allow
/// 4.0e-09 (and 2 more)".
[[nodiscard]] std::string agreement_text(const Agreement& agreement);

/// Adds the members `agreement` (true or false) and `disagreements` (an array, empty when all agree): of each the
/// quantity, both routes with their values, the difference and the bar.
void add_agreement(Json& json, const Agreement& agreement);
void add_agreement(JsonFile& json, const Agreement& agreement);

/// Throws DisagreementError (exit status 3) unless all agree. To be called when everything is printed and written.
void require_agreement(const Agreement& agreement);

}  // namespace lober::cli

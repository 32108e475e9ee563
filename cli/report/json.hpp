// Parts of the JSON objects that several commands write. Their members are a contract; more may be added, none renamed.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/report/report.hpp"

namespace lober::cli {

using Json = nlohmann::ordered_json;

/// The JSON in one line; a file name need not be UTF-8.
[[nodiscard]] std::string dumped(const Json& value);

/// Null for a number that is not finite, as one that is not known and a limit that is off, which JSON cannot say.
[[nodiscard]] Json number_json(double value);
[[nodiscard]] Json input_json(const NamedCurve& input, double area, Orientation orientation);
/// Adds the member `spec` to an input, its name on a command line, where file and zone do not say all of it: where
/// columns were chosen, or titles name the zones.
void add_spec(Json& input, const NamedCurve& curve, const std::string& spec);
/// {"x": 360} of --periodic x=360.
[[nodiscard]] Json periods_json(const Periods& periods);
[[nodiscard]] Json program_json();
/// The head of the member `crossings`.
[[nodiscard]] Json meetings_json(const Crossings& nodes);

}  // namespace lober::cli

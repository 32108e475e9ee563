// The curves that patterns name (private to engine/batch).
#pragma once

#include <string>
#include <vector>

#include "engine/batch/manifest/curve_source.hpp"
#include "engine/batch/manifest/manifest.hpp"

namespace lober::detail {

/// The curves that a list of patterns names, each once: pattern by pattern, within each in natural order. Reads the
/// files of which all zones, or one by its title, are wanted. The sources are closed. Throws UsageError when a pattern
/// names nothing.
[[nodiscard]] std::vector<CurveSource> resolve(const Manifest& manifest, const std::vector<LocatedText>& patterns);

/// "separ.2" comes before "separ.10": runs of digits compare as numbers (strverscmp). Runs that begin with a zero come
/// first and compare as decimal places, "01" < "010" < "09" < "1": numbers of a fixed width are in order, also where
/// the width no longer holds them ("08", "99", "100").
[[nodiscard]] bool natural_less(const std::string& a, const std::string& b);

}  // namespace lober::detail

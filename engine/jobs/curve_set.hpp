// From patterns to curves (private to jobs/).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/jobs/manifest.hpp"

namespace lober {

/// A curve of a file, as the manifest means it.
struct CurvePlace {
  std::string file;                 ///< as named, relative to the manifest
  std::optional<std::size_t> zone;  ///< none: the only one
  [[nodiscard]] std::string name() const { return zone ? file + "#" + std::to_string(*zone) : file; }
};

/// The curves that a list of patterns names, each once: pattern by pattern, within each in natural order. Reads the
/// files of which all zones, or one by its title, are wanted. Throws UsageError when a pattern names nothing.
[[nodiscard]] std::vector<CurvePlace> resolve(const Manifest& manifest, const std::vector<Placed>& patterns);

/// "separ.2" comes before "separ.10": runs of digits compare as numbers.
[[nodiscard]] bool natural_less(std::string_view a, std::string_view b);

/// The path of a file that a manifest names.
[[nodiscard]] std::string located(const std::string& manifest_path, const std::string& file);

}  // namespace lober

// From patterns to curves (private to jobs/).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/batch/manifest.hpp"

namespace lober {

/// A curve as the manifest means it.
struct CurvePlace {
  std::string file;                     ///< as named, relative to the manifest; empty for a manifold
  std::optional<std::size_t> zone;      ///< none: the only one
  const CurveRecipe* recipe = nullptr;  ///< of a manifold, or of the image that is meant; of the manifest
  [[nodiscard]] std::string name() const {
    const std::string place = zone ? file + "#" + std::to_string(*zone) : file;
    return recipe != nullptr ? recipe->name(place) : place;
  }
};

/// The curves that a list of patterns names, each once: pattern by pattern, within each in natural order. Reads the
/// files of which all zones, or one by its title, are wanted. Throws UsageError when a pattern names nothing.
[[nodiscard]] std::vector<CurvePlace> resolve(const Manifest& manifest, const std::vector<Placed>& patterns);

/// "separ.2" comes before "separ.10": runs of digits compare as numbers (strverscmp). Runs that begin with a zero come
/// first and compare as decimal places, "01" < "010" < "09" < "1": numbers of a fixed width are in order, also where
/// the width no longer holds them ("08", "99", "100").
[[nodiscard]] bool natural_less(const std::string& a, const std::string& b);

/// The path of a file that a manifest names.
[[nodiscard]] std::string located(const std::string& manifest_path, const std::string& file);

}  // namespace lober

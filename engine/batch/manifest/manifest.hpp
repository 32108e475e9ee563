// A manifest: the computations of a batch as a person writes them down (TOML).
//
//   operation = "overlay"          # the whole manifest for all pairs of a family of files
//   curves = "separ.*"
//   pairs = "all"
//
// `lober batch manifest` prints all keys.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/batch/manifest/recipe.hpp"
#include "engine/batch/operations/operation.hpp"

namespace lober::detail {

enum class PairKind : std::uint8_t { none, all, lag, product, single, list };

/// A text of the manifest and where it stands.
struct LocatedText {
  std::string text;
  std::size_t line = 0;
  std::string key;
  std::vector<CurveRecipe> recipes = {};  ///< manifolds, without a text, or images of the curves that the text names
};

struct ManifestGroup {
  std::string name;
  const Operation* operation = nullptr;
  std::vector<Options> options;  ///< one for each combination of the grid; without one, a single one
  std::vector<LocatedText> curves, with;
  PairKind pairs = PairKind::all;
  std::size_t lag = 1;
  std::vector<std::array<LocatedText, 2>> list;
  bool closed = true;
  Periods periods = {};  ///< those of the curves of files
};

struct Manifest {
  std::string path;
  std::string text;
  std::vector<ManifestGroup> groups;

  /// Throws UsageError "path:line: key: message".
  [[noreturn]] void fail(std::size_t line, const std::string& key, const std::string& message) const;
};

/// Throws DataError when the file cannot be read, UsageError "path:line: key: what is wrong" for everything in it that
/// is not understood.
[[nodiscard]] Manifest read_manifest(const std::string& path);
/// The same for a text; names of files are relative to the folder of `path`, which stands in messages.
[[nodiscard]] Manifest parse_manifest(std::string text, const std::string& path);

}  // namespace lober::detail

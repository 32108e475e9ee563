// What is to be computed, as a person writes it down (TOML).
//
//   operation = "overlay"          # the whole manifest for all pairs of a family of files
//   curves = "separ.*"
//   pairs = "all"
//
// Keys, at the top for all groups or in a [[group]] for itself:
//
//   name       of the group, in exports
//   operation  overlay, interior, tangle, densify, transport
//   curves     a pattern or a list of them: * ? [abc] in file names; FILE#K a zone by number or title, FILE#* all;
//              or curves to be computed (below)
//   with       the same, the second set of pairs = "product"
//   closed     false for open curves (default true, but for tangle)
//   pairs      "all"          each unordered pair of two of the curves
//              "consecutive"  each with the next one
//              { lag = k }    each with the k-th after it
//              "product"      each of `curves` with each of `with`, but none with itself
//              "single"       no pairs: each curve alone
//              [["a", "b"], ...]  these, by name; `curves` is not needed
//   options    a table for the operation; a group's count before those at the top
//   grid       a table of lists: one round of jobs for each combination
//
// A curve of a system (engine/dynamics) is a table instead of a pattern:
//
//   { system = "standard", parameters = { K = 1.2 }, manifold = "unstable", iterates = 5, tolerance = 1e-5 }
//       a branch of a manifold, open: that of the system's own tangle, or the `branch` "+" or "-" of the saddle near
//       `from = [x, y]`; `length` instead of or beside iterates
//   { system = "standard", parameters = { K = 1.2 }, image_of = "separ.npy", iterates = "0:9", tolerance = 1e-5 }
//       images of the curves of a pattern; iterates may be negative; "a:b" is a family, one curve for each of a, ..., b
//
// Both take `integration_tolerance` for flows. They are computed when a job needs them, again after they had to leave
// memory. The operation transport has no curves but a system by its options, whose parameters a grid can vary:
//
//   operation = "transport"
//   options = { system = "duffing", iterates = 7 }
//   grid = { parameters.eps = [0.1, 0.2, 0.3] }
//
// Curves come in natural order of their names (separ.2 before separ.10); paths are relative to the manifest.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/batch/operation.hpp"
#include "engine/batch/recipe.hpp"

namespace lober::detail {

enum class PairKind : std::uint8_t { none, all, lag, product, single, list };

/// A text of the manifest and where it stands.
struct Placed {
  std::string text;
  std::size_t line = 0;
  std::string key;
  std::vector<CurveRecipe> recipes = {};  ///< manifolds, without a text, or images of the curves that the text names
};

struct ManifestGroup {
  std::string name;
  const Operation* operation = nullptr;
  std::vector<Options> options;  ///< one for each combination of the grid; without one, a single one
  std::vector<Placed> curves, with;
  PairKind pairs = PairKind::all;
  std::size_t lag = 1;
  std::vector<std::array<Placed, 2>> list;
  bool closed = true;
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

}  // namespace lober::detail

// The source of a curve of a plan.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/batch/manifest/recipe.hpp"
#include "lober/curve/periods.hpp"

namespace lober::detail {

/// A curve in a file, a manifold of a system, or the image of a curve in a file.
struct CurveSource {
  std::string file;                        ///< as the manifest spells its path; empty for a manifold
  std::optional<std::size_t> zone = {};    ///< zone of the file; none: the only one
  std::optional<CurveRecipe> recipe = {};  ///< recipe of a manifold or an image
  bool closed = true;
  std::string columns = {};  ///< columns of a table, as ReadOptions::columns
  Periods periods = {};      ///< as ReadOptions::periods
  /// The name of the zone behind '#'; empty: its number. A name of the same curve everywhere, whatever reads it.
  std::string zone_name = {};

  /// FILE, FILE:COLUMNS and with #K or #GROUP, as `read_curve` takes it; empty for a manifold.
  [[nodiscard]] std::string location() const {
    return file + (columns.empty() ? "" : ":" + columns) +
           (zone ? "#" + (zone_name.empty() ? std::to_string(*zone) : zone_name) : "");
  }
  /// The name in messages and tables: the location, or how the curve is made.
  [[nodiscard]] std::string name() const { return recipe ? recipe->name(location()) : location(); }
  /// Name of the curve in the store: open and closed are different inputs, and so are curves with periods.
  [[nodiscard]] std::string input_name() const { return name() + periodic() + (closed ? "" : " (open)"); }
  /// " x=1 y=360": what the periods add to names; empty without them.
  [[nodiscard]] std::string periodic() const;
  /// Equal for curves that are read together: from one file, and all made in the same way or not at all.
  [[nodiscard]] std::string unit() const {
    return file + '\n' + columns + '\n' + periodic() + '\n' + (recipe ? recipe->name() : "");
  }
};

/// Curves with the same `unit` as a unit of the queue. Files that `kept` knows are not looked at.
[[nodiscard]] CurveUnit unit_of(const std::vector<CurveSource>& sources, const std::string& manifest_path,
                                const KeptCurves* kept = nullptr);

/// The digests of the curves as they are now, as the CurveUnit would give them. Throws DataError when the file cannot
/// be read.
[[nodiscard]] std::vector<std::string> digests_of(const std::vector<CurveSource>& sources,
                                                  const std::string& manifest_path);

/// The path of a file that a manifest names.
[[nodiscard]] std::string located(const std::string& manifest_path, const std::string& file);

}  // namespace lober::detail

// Curves that are computed instead of read: branches of manifolds, images of curves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/batch/queue/curve_cache.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::detail {

/// How to make a curve. Equal recipes make the same curve, bit for bit, with the same version.
struct CurveRecipe {
  enum class Kind : std::uint8_t { unstable, stable, image };
  Kind kind = Kind::unstable;
  std::string system;
  ParameterValues parameters;  ///< by name
  int iterates = -1;           ///< GrowthOptions::iterates, or of the image
  double tolerance = 0;
  double integration_tolerance = 1e-12;
  // For a manifold:
  double length = 0;              ///< 0: by iterates alone
  std::optional<Point> saddle{};  ///< default: that of the system's Connection
  int branch = 0;                 ///< -1, +1; 0: that of the Connection, or +1 with a saddle given

  /// "unstable(henon, a=1.4, iterates=6, tolerance=1e-05)"; an image begins with the name of its curve. Everything that
  /// counts is in it.
  [[nodiscard]] std::string name(std::string_view of = {}) const;
};

/// Memory for a point of a curve while it is computed, with all its working data.
inline constexpr std::size_t computed_bytes_per_point = 120;

/// Throws UsageError for faults that can be seen before anything is computed.
void check(const CurveRecipe& recipe);

/// Digest of the curve that the recipe makes of a curve with the digest `of`; empty for an image without a curve.
[[nodiscard]] std::string recipe_digest(const CurveRecipe& recipe, std::string_view of = {});

/// A manifold: one curve.
[[nodiscard]] CurveUnit manifold_unit(const CurveRecipe& recipe);
/// The images of the curves of a unit.
[[nodiscard]] CurveUnit image_unit(const CurveRecipe& recipe, CurveUnit of);

}  // namespace lober::detail

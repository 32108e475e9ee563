// The scenes of the benchmark: pairs of simple closed curves with any number of points.
//
// Each scene is one difficulty that occurs in transport problems, made larger by asking for more points. They
// are deterministic on one machine (sin and cos of the C library may differ in the last bit between
// machines), built in seconds at 10^7 points, counter-clockwise, and simple as polygons
// (bench/scenes/check.cpp decides that exactly).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "kernels/point.hpp"

namespace lober::bench {
using namespace lober::detail;

using Polygon = std::vector<Point>;

struct Scene {
  Polygon first, second;  ///< each has exactly the number of points that was asked for
  /// Areas of C1 \ C2, C2 \ C1, intersection and union of the *smooth* curves that the polygons are inscribed
  /// in, where a formula or a quadrature gives them. The polygons differ from that by O(1 / points^2), not at
  /// all if straight.
  std::optional<std::array<double, 4>> smooth_areas;
  /// Proper crossings, where the construction fixes their number.
  std::optional<std::size_t> crossings;
};

struct SceneKind {
  std::string_view name;
  std::string_view description;  ///< one line, for the table
  Scene (*make)(std::size_t points);
};

/// All scenes, in the order of the table. `points` may be anything from 1000 to 10^7.
[[nodiscard]] std::span<const SceneKind> scenes();

/// The scene of that name, or nullptr.
[[nodiscard]] const SceneKind* find_scene(std::string_view name);

// The members of scenes().
Scene make_lens(std::size_t points);
Scene make_wavy16(std::size_t points);
Scene make_wavy_many(std::size_t points);
Scene make_tangle(std::size_t points);
Scene make_dense_tangle(std::size_t points);
Scene make_near_tangent(std::size_t points);
Scene make_hairs(std::size_t points);
Scene make_long_hairs(std::size_t points);
Scene make_shared_exact(std::size_t points);
Scene make_shared_ulp(std::size_t points);
Scene make_geometric(std::size_t points);
Scene make_comb(std::size_t points);
Scene make_nested(std::size_t points);
Scene make_identical(std::size_t points);
Scene make_disjoint(std::size_t points);
Scene make_images12(std::size_t points);
Scene make_images14(std::size_t points);
Scene make_graze(std::size_t points);
Scene make_spirals(std::size_t points);
Scene make_rings(std::size_t points);
Scene make_net(std::size_t points);
Scene make_clusters(std::size_t points);

}  // namespace lober::bench

#include "bench/scenes/scenes.hpp"

namespace lober::bench {
namespace {

constexpr SceneKind all_scenes[] = {
    {"lens", "two unit circles", make_lens},
    {"wavy16", "circle and r = 1 + 0.1 sin 8 theta", make_wavy16},
    {"wavyN10", "circle and a fine wave along it, N/10 crossings", make_wavy_many},
    {"tangle", "circle under an area-preserving map and under its inverse, both folded", make_tangle},
    {"dense-tangle", "the same, longer, folds about one segment apart", make_dense_tangle},
    {"near-tangent", "one smooth curve sampled twice, staggered: gaps of 1e-9, about 2N crossings", make_near_tangent},
    {"hairs", "sqrt(N) thin nested hairs, 340 times as long as wide at 1e6, and an ellipse across", make_hairs},
    {"long-hairs", "the same bent to half-circles, ten thousand times as long as wide, and a circle", make_long_hairs},
    {"shared-exact", "half of the boundary is the same vertices", make_shared_exact},
    {"shared-ulp", "half of the boundary is the same vertices to one ulp", make_shared_ulp},
    {"geometric", "circles whose spacing grows from 1e-12, crossing where they are densest", make_geometric},
    {"comb", "rectilinear comb and the same turned by a right angle", make_comb},
    {"nested", "wavy curve inside a circle", make_nested},
    {"identical", "the same vertices, started elsewhere", make_identical},
    {"disjoint", "two circles apart", make_disjoint},
    {"images12", "a circle's images under 12 iterates of the standard map and of its inverse", make_images12},
    {"images14", "the same, 14 iterates", make_images14},
    {"graze", "circle and r = 1 + 1e-9 sin 500 theta", make_graze},
    {"spirals", "sqrt(N)/10 turns of a spiral band, and the same about another centre", make_spirals},
    {"rings", "sqrt(N)/4 thin rings, each open on one side, across others", make_rings},
    {"net", "the combs, turned by 0.6", make_net},
    {"clusters", "wavy circles, points a million times closer in N/1000 places", make_clusters},
};

}  // namespace

std::span<const SceneKind> scenes() {
  return all_scenes;
}

const SceneKind* find_scene(std::string_view name) {
  for (const SceneKind& scene : all_scenes) {
    if (scene.name == name) return &scene;
  }
  return nullptr;
}

}  // namespace lober::bench

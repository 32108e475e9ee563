// Decides by brute force with exact predicates that the curves of every scene are simple, and counts their
// crossings.
//
//   bench_check [points [scene ...]]      default 2000 points, all scenes; O(points^2), a minute a scene at
//   10^5
#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>

#include "bench/scenes/scenes.hpp"
#include "kernels/box.hpp"
#include "kernels/predicates.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

struct Edge {
  Point a, b;
  Box box;
};

std::vector<Edge> edges_of(const Polygon& polygon) {
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point a = polygon[k];
    const Point b = polygon[(k + 1) % polygon.size()];
    edges.push_back({a, b, Box::of(a, b)});
  }
  return edges;
}

struct Meeting {
  bool any = false;     ///< the closed segments have a point in common
  bool proper = false;  ///< exactly one, inside both
};

Meeting meeting(const Edge& first, const Edge& second, PredicateCounts& counts) {
  if (!meet(first.box, second.box)) return {};
  const int c = orient2d(first.a, first.b, second.a, counts);
  const int d = orient2d(first.a, first.b, second.b, counts);
  if (c * d > 0) return {};
  const int a = orient2d(second.a, second.b, first.a, counts);
  const int b = orient2d(second.a, second.b, first.b, counts);
  if (a * b > 0) return {};
  return {true, c * d < 0 && a * b < 0};
}

// Segments that are neighbours may meet in their common vertex, hence only if the far end of one is not on
// the other.
bool simple(const std::vector<Edge>& edges, PredicateCounts& counts) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].a == edges[i].b) return false;
    const std::size_t next = (i + 1) % edges.size();
    if (on_segment(edges[i].a, edges[i].b, edges[next].b, counts)) return false;
    if (on_segment(edges[next].a, edges[next].b, edges[i].a, counts)) return false;
    const std::size_t end = i == 0 ? edges.size() - 1 : edges.size();
    for (std::size_t j = i + 2; j < end; ++j) {
      if (meeting(edges[i], edges[j], counts).any) return false;
    }
  }
  return true;
}

void check(const SceneKind& kind, std::size_t points) {
  const Scene scene = kind.make(points);
  PredicateCounts counts;
  const std::vector<Edge> first = edges_of(scene.first);
  const std::vector<Edge> second = edges_of(scene.second);
  std::size_t proper = 0;
  std::size_t other = 0;
  for (const Edge& edge : first) {
    for (const Edge& opposite : second) {
      const Meeting found = meeting(edge, opposite, counts);
      proper += found.proper;
      other += found.any && !found.proper;
    }
  }
  std::cout << std::left << std::setw(16) << kind.name << std::right << std::setw(9) << first.size() << std::setw(9)
            << second.size() << (simple(first, counts) ? "  simple" : "  NOT SIMPLE")
            << (simple(second, counts) ? "  simple" : "  NOT SIMPLE") << std::setw(9) << proper << " crossings"
            << std::setw(9) << other << " contacts"
            << (scene.crossings && *scene.crossings != proper ? "  UNEXPECTED" : "") << std::endl;
}

}  // namespace
}  // namespace lober::bench

int main(int count, char** arguments) {
  const std::size_t points = count > 1 ? std::strtoul(arguments[1], nullptr, 10) : 2000;
  if (count <= 2) {
    for (const auto& kind : lober::bench::scenes()) lober::bench::check(kind, points);
  }
  for (int k = 2; k < count; ++k) {
    const auto* kind = lober::bench::find_scene(arguments[k]);
    if (kind == nullptr) {
      std::cerr << "no scene " << arguments[k] << '\n';
      return 2;
    }
    lober::bench::check(*kind, points);
  }
}

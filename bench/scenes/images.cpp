// A circle about the saddle of the standard map, x' = x + y', y' = y + K sin x with K = 1.2, carried on by the map and
// by its inverse.
//
// Unlike the chain of shears the map has islands and a chaotic sea, so that some parts of the images are stretched a
// hundred thousand times and others hardly: points lie in all densities.
#include <cstddef>

#include "bench/scenes/sampling.hpp"

namespace lober::bench {
namespace {

class StandardImage {
 public:
  explicit StandardImage(int iterates) : iterates_(iterates) {}
  [[nodiscard]] Point operator()(double turn) const {
    constexpr double strength = 1.2, radius = 0.6;
    double x = radius * std::cos(full_turn * turn), y = radius * std::sin(full_turn * turn);
    for (int k = 0; k < iterates_; ++k) {
      y += strength * std::sin(x);
      x += y;
    }
    for (int k = 0; k > iterates_; --k) {
      x -= y;
      y -= strength * std::sin(x);
    }
    return {x, y};
  }

 private:
  int iterates_;
};

Scene images(std::size_t points, int iterates) {
  // As many as this number of points can draw without crossings; each takes 2.4 times more.
  while (iterates > 2 && 4.7 * std::pow(2.4, iterates) > static_cast<double>(points)) --iterates;
  return {sampled(StandardImage(iterates), points), sampled(StandardImage(-iterates), points), std::nullopt,
          std::nullopt};
}

}  // namespace

Scene make_images12(std::size_t points) {
  return images(points, 12);
}

Scene make_images14(std::size_t points) {
  return images(points, 14);
}

}  // namespace lober::bench

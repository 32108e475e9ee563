// Closed curves advected by an area-preserving map until they are long, thin and folded.
//
// The map is a chain of shears, y += a sin(w x + phase), then x += a sin(w y + phase): each preserves area
// exactly and is invertible, so the image of a circle is a simple closed curve for any strength a. C1 is the
// circle's image under the chain, C2 the image under its inverse: they lie to each other as unstable and
// stable manifolds do.
#include <algorithm>
#include <cstddef>

#include "bench/scenes/sampling.hpp"

namespace lober::bench {
using namespace lober::detail;
namespace {

class ShearChain {
 public:
  ShearChain(double strength, int steps, bool inverse) : strength_(strength), steps_(steps), inverse_(inverse) {}

  /// Image of the point of the initial circle at `turn` in [0, 1).
  [[nodiscard]] Point operator()(double turn) const {
    Point point{0.7 * std::cos(full_turn * turn), 0.7 * std::sin(full_turn * turn)};
    if (inverse_) {
      for (int step = steps_; step > 0; --step) {
        point.x -= strength_ * std::sin(wave_number * point.y + 2.1 * step);
        point.y -= strength_ * std::sin(wave_number * point.x + 0.4 * step);
      }
    } else {
      for (int step = 1; step <= steps_; ++step) {
        point.y += strength_ * std::sin(wave_number * point.x + 0.4 * step);
        point.x += strength_ * std::sin(wave_number * point.y + 2.1 * step);
      }
    }
    return point;
  }

 private:
  static constexpr double wave_number = 7;
  double strength_;
  int steps_;
  bool inverse_;
};

double image_length(const ShearChain& chain) {
  constexpr std::size_t count = 20000;
  return spread(chain, spread(chain, equal_turns(count), count).turns, 1).length;
}

// The chain under which the circle gets the wanted length. Few strong shears make folds of more even width
// than many weak ones.
ShearChain chain_of_length(double length, bool inverse) {
  const int steps = std::max(1, static_cast<int>(std::log(length / 4) / 1.6));
  double low = 0;
  double high = 2;
  for (int step = 0; step < 30; ++step) {
    const double middle = (low + high) / 2;
    (image_length({middle, steps, inverse}) < length ? low : high) = middle;
  }
  return {low, steps, inverse};
}

Polygon folded_curve(std::size_t points, double length, bool inverse) {
  return sampled(chain_of_length(length, inverse), points);
}

// Two curves that spread over a few units of area cross about length1 * length2 / 8 times.
Scene folded_pair(std::size_t points, double length1, double length2) {
  return {folded_curve(points, length1, false), folded_curve(points, length2, true), std::nullopt, std::nullopt};
}

}  // namespace

Scene make_tangle(std::size_t points) {
  // Both equally long, about 5000 crossings, unless there are too few points to draw that.
  const double length = 200 * std::min(1.0, std::sqrt(static_cast<double>(points) / 1e5));
  return folded_pair(points, length, length);
}

Scene make_dense_tangle(std::size_t points) {
  // The folds of C1 are area / length apart and its segments length / points long: equal for a length that
  // grows as the square root. About 55000 crossings at 10^6 points. Not much beyond: the thinnest
  // folds become so thin that the polygon is no longer simple.
  const double detail = std::sqrt(std::min(static_cast<double>(points), 2e6) / 1e6);
  return folded_pair(points, 1500 * detail, 360 * detail);
}

}  // namespace lober::bench

// Makes the two manifolds of `make demo`: the unstable and the stable manifold of the saddle of the area-preserving
// Henon map, up to a little beyond the eleventh primary intersection. By action, each lobe of the true manifolds has
// area 0.36598843872559149, and the region bounded with the one that has x1 = x-1, 6.0441780571922164.
//
//   g++ -std=c++20 -O2 examples/make_demo_manifolds.cpp -o make_demo_manifolds && ./make_demo_manifolds examples
//
//   (x, y) -> (x^2 - y, x); saddle (2, 2), multiplier 2 + sqrt 3. The map preserves area, and (x, y) -> (y, x)
//   exchanges the manifolds.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr double saddle = 2;
const double lambda = 2 + std::sqrt(3.0);

struct Point {
  double x, y;
};

Point map(Point z) {
  return {z.x * z.x - z.y, z.x};
}

// The unstable manifold by its linear parameter: map(unstable(s)) == unstable(lambda s).
Point unstable(double s) {
  int steps = 0;
  for (; s > 1e-7; s /= lambda) ++steps;
  Point z{saddle - lambda * s, saddle - s};
  for (int k = 0; k < steps; ++k) z = map(z);
  return z;
}

// The parameter of the primary intersection whose image and pre-image have the same x; the reversor takes it to its
// image.
double primary_intersection() {
  const auto beyond = [](double s) { return map(unstable(s)).x > unstable(s).y; };
  double low = 0.1;
  while (!beyond(low * 1.01)) low *= 1.01;
  double high = low * 1.01;
  for (int k = 0; k < 80; ++k) {
    const double middle = 0.5 * (low + high);
    (beyond(middle) ? high : low) = middle;
  }
  return low;
}

// Parameters between low and high, until chords are short and hug the curve.
void refine(double low, double high, std::vector<double>& parameters) {
  const double middle = std::sqrt(low * high);
  const Point a = unstable(low), m = unstable(middle), b = unstable(high);
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const double away = std::hypot(m.x - 0.5 * (a.x + b.x), m.y - 0.5 * (a.y + b.y));
  if (length < 0.04 && away < 2e-5 + 1e-3 * length && high / low < 1.3) return;
  refine(low, middle, parameters);
  parameters.push_back(middle);
  refine(middle, high, parameters);
}

}  // namespace

int main(int count, char** arguments) {
  const std::string path = std::string(count > 1 ? arguments[1] : ".") + "/manifolds.dat";
  const double primary = primary_intersection();
  std::vector<Point> manifold{{saddle, saddle}};
  constexpr double first = -8, last = 3.1;  // powers of lambda from the primary intersection
  std::vector<double> parameters;
  for (double k = first; k < last; k += 1) {
    const double low = primary * std::pow(lambda, k), high = primary * std::pow(lambda, std::fmin(k + 1, last));
    parameters.push_back(low);
    refine(low, high, parameters);
  }
  for (const double s : parameters) manifold.push_back(unstable(s));

  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) {
    std::perror(path.c_str());
    return EXIT_FAILURE;
  }
  std::fprintf(file, "TITLE=\"Henon map, k = 0\"\nVARIABLES=\"x\"\"y\"\nZONE T=\"unstable\"\n");
  for (const Point& z : manifold) std::fprintf(file, "%.8f %.8f\n", z.x, z.y);
  std::fprintf(file, "ZONE T=\"stable\"\n");
  for (const Point& z : manifold) std::fprintf(file, "%.8f %.8f\n", z.y, z.x);
  std::fclose(file);
}

// Makes the two curves of `make demo`: the resonance region of the standard map, bounded by pieces of the
// stable and unstable manifolds of its saddle, and the image of that region under some iterates of the map.
// The image has put out lobes through the boundary and drawn others in, and it shares two arcs with the
// boundary. By action, each lobe of the true manifolds has area 0.39492059602290671.
//
//   g++ -std=c++20 -O2 examples/make_demo_curves.cpp -o make_demo_curves && ./make_demo_curves examples
//
//   p' = p + K sin x, x' = x + p'; saddle (0, 0) ~ (2 pi, 0). The map preserves area, the reversor
//   R(x, p) = (2 pi - x, p + K sin x) exchanges the manifolds, and x, p -> 2 pi - x, -p the upper and the
//   lower half.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

namespace {

constexpr double K = 2;
constexpr int iterates = 4;
constexpr double two_pi = 2 * std::numbers::pi;
const double lambda = 1 + 0.5 * K + std::sqrt(K + 0.25 * K * K);  // lambda + 1 / lambda = 2 + K

struct Point {
  double x, p;
};

Point map(Point z) {
  const double p = z.p + K * std::sin(z.x);
  return {z.x + p, p};
}
Point reversor(Point z) {
  return {two_pi - z.x, z.p + K * std::sin(z.x)};
}
Point mirror(Point z) {
  return {two_pi - z.x, -z.p};
}

// The unstable manifold by its linear parameter: map(unstable(s)) == unstable(lambda s).
Point unstable(double s) {
  int steps = 0;
  for (; s > 1e-6; s /= lambda) ++steps;
  Point z{s, s * K / (lambda - 1)};
  for (int k = 0; k < steps; ++k) z = map(z);
  return z;
}

// The parameter of the first intersection with x = pi, the symmetry line, where the stable manifold passes
// too.
double primary_intersection() {
  double high = 0.1;
  while (unstable(high).x < std::numbers::pi) high *= 1.01;
  double low = high / 1.01;
  for (int k = 0; k < 80; ++k) {
    const double middle = 0.5 * (low + high);
    (unstable(middle).x < std::numbers::pi ? low : high) = middle;
  }
  return low;
}

// Parameters between low and high, until chords are short and hug the curve.
void refine(double low, double high, std::vector<double>& parameters) {
  const double middle = std::sqrt(low * high);
  const Point a = unstable(low), m = unstable(middle), b = unstable(high);
  const double length = std::hypot(b.x - a.x, b.p - a.p);
  const double away = std::hypot(m.x - 0.5 * (a.x + b.x), m.p - 0.5 * (a.p + b.p));
  if (length < 0.04 && away < 6e-5 + 2e-3 * length && high / low < 1.3) return;
  refine(low, middle, parameters);
  parameters.push_back(middle);
  refine(middle, high, parameters);
}

void write(const std::string& path, const char* title, const std::vector<Point>& points) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) {
    std::perror(path.c_str());
    std::exit(1);
  }
  std::fprintf(file, "TITLE=\"standard map, K = 2\"\nVARIABLES=\"x\"\"p\"\nZONE T=\"%s\"\n", title);
  for (const Point& z : points) std::fprintf(file, "%.8f %.8f\n", z.x, z.p);
  std::fclose(file);
}

}  // namespace

int main(int count, char** arguments) {
  const std::string folder = count > 1 ? arguments[1] : ".";
  const double primary = primary_intersection();
  // One list for both curves, so that they have the same vertices where they share an arc.
  constexpr int first = -6;
  std::vector<double> parameters;
  std::vector<std::size_t> iterate_at;  // where the iterates of the primary intersection stand in the list
  for (int k = first; k < iterates; ++k) {
    const double low = primary * std::pow(lambda, k), high = primary * std::pow(lambda, k + 1);
    iterate_at.push_back(parameters.size());
    parameters.push_back(low);
    refine(low, high, parameters);
  }
  iterate_at.push_back(parameters.size());
  parameters.push_back(primary * std::pow(lambda, iterates));

  // Out along the unstable manifold to iterate n of the intersection, in along the stable one, and back
  // below.
  const auto region = [&](int n) {
    std::vector<Point> upper{{0, 0}};
    for (std::size_t k = 0; k <= iterate_at[static_cast<std::size_t>(n - first)]; ++k) {
      upper.push_back(unstable(parameters[k]));
    }
    for (std::size_t k = iterate_at[static_cast<std::size_t>(-n - first)]; k-- > 0;) {
      upper.push_back(reversor(unstable(parameters[k])));
    }
    std::vector<Point> points = upper;
    for (const Point& z : upper) points.push_back(mirror(z));
    return points;
  };
  write(folder + "/resonance.dat", "the resonance region", region(0));
  write(folder + "/resonance_image.dat", "its image after four iterates", region(iterates));
}

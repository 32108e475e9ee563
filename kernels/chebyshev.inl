// Body of chebyshev_points, compiled once for plain x86-64 and once for AVX2.

namespace {

using namespace lober;

// So many parameters at a time that the chains of additions hide behind each other.
constexpr std::size_t group = 8;

inline void evaluate(std::span<const Point> coefficients, double centre, double half_width,
                     std::span<const double> parameters, std::span<Point> points) {
  using Group = std::array<double, group>;
  for (std::size_t first = 0; first < parameters.size(); first += group) {
    const std::size_t count = std::min(group, parameters.size() - first);
    Group x{}, later_x{}, latest_x{}, later_y{}, latest_y{};  // b_{j+2}, b_{j+1} of both coordinates
    for (std::size_t k = 0; k < count; ++k) x[k] = (parameters[first + k] - centre) / half_width;
    for (std::size_t j = coefficients.size(); j-- > 1;) {
      const Point c = coefficients[j];
      for (std::size_t k = 0; k < group; ++k) {
        const double next_x = 2 * x[k] * latest_x[k] + (c.x - later_x[k]);
        const double next_y = 2 * x[k] * latest_y[k] + (c.y - later_y[k]);
        later_x[k] = latest_x[k];
        later_y[k] = latest_y[k];
        latest_x[k] = next_x;
        latest_y[k] = next_y;
      }
    }
    const Point c = coefficients.empty() ? Point{} : coefficients[0];
    for (std::size_t k = 0; k < count; ++k) {
      points[first + k] = {x[k] * latest_x[k] + (c.x - later_x[k]), x[k] * latest_y[k] + (c.y - later_y[k])};
    }
  }
}

}  // namespace

// The oscillating vortex pair of Rom-Kedar, Leonard & Wiggins (1990): a passive particle near two counter-rotating
// vortices in an oscillating strain, in the frame that moves with their mean velocity.
#include <array>
#include <cmath>
#include <numbers>

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"

namespace lober::detail {

namespace {

constexpr std::array<ConjugatePair, 1> stream_function_pair{{{0, 1, 1}}};

/// The vortices are at (xv, +-yv):
///   yv = exp(eps (cos(t/gamma) - 1)),   vv = e^eps / (2 I0(eps)),
///   xv = -gamma e^{eps (1 - cos(t/gamma))} / I0(eps) * sum_{k >= 1} I_k(eps) sin(k t/gamma) / k,
/// and the stream function is -1/2 log(R-/R+) - vv y + (eps/gamma) x y sin(t/gamma), R-+ = (x - xv)^2 + (y -+ yv)^2.
class VortexPair {
 public:
  static constexpr int dimension = 2;

  VortexPair(double gamma, double eps)
      : gamma_(gamma), eps_(eps), vv_(0.5 * std::exp(eps) / std::cyl_bessel_i(0.0, std::abs(eps))) {
    // I_k(-e) = (-1)^k I_k(e). The terms fall off faster than (e/2)^k / k!.
    const double size = std::abs(eps);
    for (std::size_t k = 1; k <= max_terms; ++k) {
      const double sign = eps < 0 && k % 2 == 1 ? -1 : 1;
      coefficient_[k] = sign * std::cyl_bessel_i(static_cast<double>(k), size) /
                        (static_cast<double>(k) * std::cyl_bessel_i(0.0, size));
      if (std::abs(coefficient_[k]) > 1e-19) terms_ = k;
    }
  }

  [[nodiscard]] double period() const { return 2 * std::numbers::pi * gamma_; }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const { return stream_function_pair; }

  template <typename T>
  void velocity(const T* x, T* dxdt, double t) const {
    const Vortex at = vortex(t);
    const T across = x[0] - at.x;
    const T up = x[1] - at.y;
    const T down = x[1] + at.y;
    const T square = across * across;
    const T near = 1.0 / (square + up * up);
    const T far = 1.0 / (square + down * down);
    const double strain = eps_ / gamma_ * at.sine;
    dxdt[0] = down * far - up * near - vv_ + strain * x[0];
    dxdt[1] = across * (near - far) - strain * x[1];
  }

  double hamiltonian(const double* x, double t) const {
    const Vortex at = vortex(t);
    const double square = (x[0] - at.x) * (x[0] - at.x);
    // R- / R+ = 1 - 4 y yv / R+
    const double far = square + (x[1] + at.y) * (x[1] + at.y);
    return -0.5 * std::log1p(-4 * x[1] * at.y / far) - vv_ * x[1] + eps_ / gamma_ * x[0] * x[1] * at.sine;
  }

 private:
  struct Vortex {
    double x, y, sine;
  };

  [[nodiscard]] Vortex vortex(double t) const {
    const double sine = std::sin(t / gamma_);
    const double cosine = std::cos(t / gamma_);
    // Clenshaw's recurrence for sum c_k sin(k theta).
    double next = 0, after = 0;
    for (std::size_t k = terms_; k >= 1; --k) {
      const double here = coefficient_[k] + 2 * cosine * next - after;
      after = next;
      next = here;
    }
    const double y = std::exp(eps_ * (cosine - 1));
    return {-gamma_ / y * next * sine, y, sine};
  }

  static constexpr std::size_t max_terms = 40;
  double gamma_;
  double eps_;
  double vv_;
  std::array<double, max_terms + 1> coefficient_{};
  std::size_t terms_ = 0;
};

/// The same to first order in eps. dy/dt = f2 + eps g2: the minus in Eq. (ovp_expansion_eps) of Naik, Lekien & Ross
/// (2017) would not preserve area.
class FirstOrderVortexPair {
 public:
  static constexpr int dimension = 2;

  FirstOrderVortexPair(double gamma, double eps) : gamma_(gamma), eps_(eps) {}

  [[nodiscard]] double period() const { return 2 * std::numbers::pi * gamma_; }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const { return stream_function_pair; }

  template <typename T>
  void velocity(const T* x, T* dxdt, double t) const {
    const double s = std::sin(t / gamma_);
    const double c1 = std::cos(t / gamma_) - 1;
    const T up = x[1] - 1.0;
    const T down = x[1] + 1.0;
    const T square = x[0] * x[0];
    const T near = 1.0 / (square + up * up);     // 1 / I-
    const T far = 1.0 / (square + down * down);  // 1 / I+
    const T up2 = up * near * near;              // (y - 1) / I-^2
    const T down2 = down * far * far;
    const T g1 =
        c1 * (near + far - 2.0 * (up * up2 + down * down2)) + x[0] * (s * gamma_ * (up2 - down2) + s / gamma_) - 0.5;
    const T g2 = x[0] * (2 * c1 * (up2 + down2)) +
                 s * gamma_ * (0.5 * (near - far) - square * (near * near - far * far)) - x[1] * (s / gamma_);
    dxdt[0] = down * far - up * near - 0.5 + eps_ * g1;
    dxdt[1] = x[0] * (near - far) + eps_ * g2;
  }

  double hamiltonian(const double* x, double t) const {
    const double s = std::sin(t / gamma_);
    const double c1 = std::cos(t / gamma_) - 1;
    const double square = x[0] * x[0];
    const double near = square + (x[1] - 1) * (x[1] - 1);
    const double far = square + (x[1] + 1) * (x[1] + 1);
    const double psi0 = -0.5 * std::log1p(-4 * x[1] / far) - 0.5 * x[1];
    const double psi1 = c1 * ((x[1] - 1) / near + (x[1] + 1) / far) - 0.5 * gamma_ * s * (x[0] / near - x[0] / far) +
                        x[0] * x[1] / gamma_ * s - 0.5 * x[1];
    return psi0 + eps_ * psi1;
  }

 private:
  double gamma_;
  double eps_;
};

template <typename Field>
SystemEntry entry(const char* name, const char* summary) {
  SystemInfo info{name,
                  summary,
                  {{"gamma", 0.5, "dimensionless period of the strain over 2 pi"},
                   {"eps", 0.1, "amplitude of the strain"},
                   {"phase", 0, "of the section, as a fraction of the period"}}};
  return {info, [info](std::span<const double> values, const IntegrationOptions& options) {
            require_positive(info, "gamma", values[0]);
            // Forty terms of the vortices' motion are kept: more than enough up to here.
            if (std::abs(values[1]) > 8) throw UsageError("system " + info.name + ": |eps| must be at most 8");
            System system;
            system.window = window(-2.2, -0.1, 2.2, 0.1);
            // The upper boundary of the fluid that travels with the pair.
            system.connection = Connection{{1.5, 0}, {0, 1}, {-1.5, 0}, {0, 1}, Point{0, 2.05}};
            // The lower one. Both are closed by the axis y = 0, which no fluid crosses.
            system.further = {Connection{{1.5, 0}, {0, -1}, {-1.5, 0}, {0, -1}, Point{0, -2.05}}};
            system.symmetries = {{{1, 0, 0, -1}}};
            if (at_half_periods(values[2])) system.symmetries.push_back(reversor({-1, 0, 0, 1}));
            system.flow = std::make_shared<FlowOf<Field>>(Field(values[0], values[1]));
            system.map = system.flow->stroboscopic_map(values[2], options);
            return system;
          }};
}

}  // namespace

SystemEntry vortex_pair_entry() {
  return entry<VortexPair>("ovp",
                           "Oscillating vortex pair (Rom-Kedar, Leonard & Wiggins 1990), vortices move; period map");
}

SystemEntry first_order_vortex_pair_entry() {
  return entry<FirstOrderVortexPair>("ovp1", "Oscillating vortex pair to first order in eps; period map");
}

}  // namespace lober::detail

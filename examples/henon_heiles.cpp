// A system of your own in C++: the flow of Henon & Heiles (1964), H = (px^2 + py^2 + x^2 + y^2) / 2 + x^2 y - y^3 / 3,
// with its section x = 0, px > 0 in (y, py).
//
//     c++ -std=c++20 -shared -fPIC -O2 -Iengine examples/henon_heiles.cpp -o henon_heiles.so
#include <limits>

#include "lober/lober_system.h"

namespace {

int velocity(const double* /*parameters*/, const double* z, double /*t*/, double* dzdt) {
  dzdt[0] = z[2];
  dzdt[1] = z[3];
  dzdt[2] = -z[0] - 2 * z[0] * z[1];
  dzdt[3] = -z[1] - z[0] * z[0] + z[1] * z[1];
  return 0;
}

// The same for many points at a time, which is several times faster where velocities are as simple as these. With
// -O3 and -march=native (or #pragma omp simd) compilers turn it into vector instructions.
void velocity_batch(const double* /*parameters*/, size_t count, const double* z, const double* /*t*/, double* dzdt) {
  const double *x = z, *y = z + count, *px = z + 2 * count, *py = z + 3 * count;
  for (size_t k = 0; k < count; ++k) {
    dzdt[k] = px[k];
    dzdt[count + k] = py[k];
    dzdt[2 * count + k] = -x[k] - 2 * x[k] * y[k];
    dzdt[3 * count + k] = -y[k] - x[k] * x[k] + y[k] * y[k];
  }
}

int jacobian(const double* /*parameters*/, const double* z, double /*t*/, double* j) {
  const double rows[] = {0,
                         0,
                         1,
                         0,  //
                         0,
                         0,
                         0,
                         1,  //
                         -1 - 2 * z[1],
                         -2 * z[0],
                         0,
                         0,  //
                         -2 * z[0],
                         -1 + 2 * z[1],
                         0,
                         0};
  for (const double entry : rows) *j++ = entry;
  return 0;
}

double hamiltonian(const double* /*parameters*/, const double* z, double /*t*/) {
  return 0.5 * (z[2] * z[2] + z[3] * z[3] + z[0] * z[0] + z[1] * z[1]) + z[1] * (z[0] * z[0] - z[1] * z[1] / 3);
}

constexpr lober_parameter parameters[] = {{"energy", 0.125, "of the section; orbits escape above 1/6"}};
constexpr lober_range ranges[] = {
    {0, std::numeric_limits<double>::infinity(), 1, 0}};  // the bottom of the well is at 0
constexpr lober_conjugate_pair pairs[] = {{0, 2, nullptr}, {1, 3, nullptr}};
constexpr lober_section section{.coordinate = 0,
                                .value = 0,
                                .direction = 1,
                                .chart_x = 1,
                                .chart_y = 3,
                                .solved = 2,
                                .energy_parameter = 0,
                                .bound_coordinate = 0,
                                .bound = 0,
                                .bound_side = 0,
                                .period = 0};
constexpr lober_flow flow{.dimension = 4,
                          .velocity = velocity,
                          .jacobian = jacobian,
                          .period = nullptr,
                          .hamiltonian = hamiltonian,
                          .pair_count = 2,
                          .pairs = pairs,
                          .section = &section,
                          .velocity_batch = velocity_batch};
// The three saddles, at the energy 1/6.
int saddle(const double* /*parameters*/, size_t index, double state[4]) {
  constexpr double positions[][2] = {{0, 1}, {-0.86602540378443865, -0.5}, {0.86602540378443865, -0.5}};
  state[0] = positions[index][0];
  state[1] = positions[index][1];
  state[2] = state[3] = std::numeric_limits<double>::quiet_NaN();  // at rest
  return 0;
}

constexpr lober_system description{.abi = LOBER_SYSTEM_ABI,
                                   .kind = LOBER_FLOW,
                                   .name = "henon-heiles",
                                   .summary = "Henon & Heiles (1964); return map to x = 0, px > 0 in (y, py)",
                                   .parameter_count = 1,
                                   .parameters = parameters,
                                   .window = {-0.5, -0.5, 0.7, 0.5},
                                   .lattice = {0, 0},
                                   .map = nullptr,
                                   .flow = &flow,
                                   .connection_count = 0,
                                   .connection = nullptr,
                                   .all_bound_region_1 = 0,
                                   .ranges = ranges,
                                   .perturbation = nullptr,
                                   .second_lattice = {0, 0},
                                   .saddle_count = 3,
                                   .saddle = saddle};

}  // namespace

const lober_system* lober_system_describe() {
  return &description;
}

/* The restricted three-body problem as the built-in pcr3bp, with the positions of its saddles, or with one slip in
   them: SLIP 1 a momentum without a number, 2 no saddle for these parameters, 3 too many, 4 no function, 5 a flow
   without a Hamiltonian; 0 nowhere. */
#include <math.h>

#include "lober/lober_system.h"

static int velocity(const double* p, const double* x, double t, double* dxdt) {
  const double mu = p[0], a = x[0] + mu, b = x[0] - (1 - mu);
  const double pull1 = (1 - mu) / pow(a * a + x[1] * x[1], 1.5), pull2 = mu / pow(b * b + x[1] * x[1], 1.5);
  (void)t;
  dxdt[0] = x[2] + x[1];
  dxdt[1] = x[3] - x[0];
  dxdt[2] = x[3] - a * pull1 - b * pull2;
  dxdt[3] = -x[2] - x[1] * (pull1 + pull2);
  return 0;
}

static int jacobian(const double* p, const double* x, double t, double* jacobian) {
  const double mu = p[0], a = x[0] + mu, b = x[0] - (1 - mu), y = x[1];
  const double r1 = a * a + y * y, r2 = b * b + y * y;
  const double pull1 = (1 - mu) / pow(r1, 1.5), pull2 = mu / pow(r2, 1.5);
  const double bend1 = 3 * pull1 / r1, bend2 = 3 * pull2 / r2;
  const double xx = a * a * bend1 + b * b * bend2 - pull1 - pull2, xy = y * (a * bend1 + b * bend2);
  const double yy = y * y * (bend1 + bend2) - pull1 - pull2;
  const double rows[16] = {0, 1, 1, 0, -1, 0, 0, 1, xx, xy, 0, 1, xy, yy, -1, 0};
  (void)t;
  for (int k = 0; k < 16; ++k) jacobian[k] = rows[k];
  return 0;
}

static double hamiltonian(const double* p, const double* x, double t) {
  const double mu = p[0];
  (void)t;
  return (x[2] * x[2] + x[3] * x[3]) / 2 + x[2] * x[1] - x[3] * x[0] - (1 - mu) / hypot(x[0] + mu, x[1]) -
         mu / hypot(x[0] - (1 - mu), x[1]) - mu * (1 - mu) / 2;
}

/* L1 and L2, at Hill's distance from the smaller body. */
static int saddle(const double* p, size_t index, double state[4]) {
  const double hill = cbrt(p[0] / 3);
  state[0] = 1 - p[0] + (index == 0 ? -hill : hill);
  state[1] = 0;
  state[2] = NAN;
  state[3] = SLIP == 1 ? 0 : NAN;
  return SLIP == 2;
}

static const lober_parameter parameters[] = {{"mu", 9.537e-4, "mass ratio"}, {"energy", -1.525, "H"}};
static const lober_conjugate_pair pairs[] = {{0, 2, NULL}, {1, 3, NULL}};
static const lober_section section = {1, 0, 1, 0, 2, 3, 1, 0, -1, -1, 0};
static const lober_flow flow = {.dimension = 4,
                                .velocity = velocity,
                                .jacobian = jacobian,
                                .hamiltonian = SLIP == 5 ? NULL : hamiltonian,
                                .pair_count = 2,
                                .pairs = pairs,
                                .section = SLIP == 5 ? NULL : &section};
static const lober_system description = {.abi = LOBER_SYSTEM_ABI,
                                         .kind = LOBER_FLOW,
                                         .name = "three-body",
                                         .summary = "",
                                         .parameter_count = 2,
                                         .parameters = parameters,
                                         .window = {-3, -0.5, -1.05, 0.5},
                                         .flow = &flow,
                                         .saddle_count = SLIP == 3 ? 65 : 2,
                                         .saddle = SLIP == 4 ? NULL : saddle};

const lober_system* lober_system_describe(void) {
  return &description;
}

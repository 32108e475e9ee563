/* A particle in the double well x^4 / 4 - x^2 / 2 that a force rocks, as the built-in duffing, one velocity at a time.
 */
#include <math.h>

#include "lober/lober_system.h"

static int velocity(const double* p, const double* x, double t, double* dxdt) {
  dxdt[0] = x[1];
  dxdt[1] = x[0] - x[0] * x[0] * x[0] + p[0] * cos(t);
  return 0;
}

static int jacobian(const double* p, const double* x, double t, double* jacobian) {
  (void)p, (void)t;
  jacobian[0] = 0;
  jacobian[1] = 1;
  jacobian[2] = 1 - 3 * x[0] * x[0];
  jacobian[3] = 0;
  return 0;
}

static double period(const double* p) {
  (void)p;
  return 6.2831853071795865;
}

static const lober_parameter eps = {"eps", 0.1, "amplitude of the force"};
static const lober_flow flow = {2, velocity, jacobian, period, NULL, 0, NULL, NULL, NULL};
static const lober_system description = {.abi = LOBER_SYSTEM_ABI,
                                         .kind = LOBER_FLOW,
                                         .name = "double-well",
                                         .summary = "",
                                         .parameter_count = 1,
                                         .parameters = &eps,
                                         .window = {-1.8, -1.2, 1.8, 1.2},
                                         .flow = &flow};

const lober_system* lober_system_describe(void) {
  return &description;
}

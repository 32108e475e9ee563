/* A forced oscillator x'' = -x + cos t with one slip: SLIP 1 in the Jacobian, 2 in the Hamiltonian, 3 in velocity_batch,
   0 nowhere. */
#include <math.h>

#include "lober/lober_system.h"

static int velocity(const double* a, const double* x, double t, double* dxdt) {
  (void)a;
  dxdt[0] = x[1];
  dxdt[1] = -x[0] + cos(t);
  return 0;
}

static int jacobian(const double* a, const double* x, double t, double* j) {
  (void)a, (void)x, (void)t;
  j[0] = 0;
  j[1] = 1;
  j[2] = SLIP == 1 ? 1 : -1;
  j[3] = 0;
  return 0;
}

static double period(const double* a) {
  (void)a;
  return 6.283185307179586;
}

static double hamiltonian(const double* a, const double* x, double t) {
  (void)a;
  return 0.5 * (x[0] * x[0] + x[1] * x[1]) - (SLIP == 2 ? 0 : x[0] * cos(t));
}

static void velocity_batch(const double* a, size_t count, const double* x, const double* t, double* dxdt) {
  (void)a;
  for (size_t k = 0; k < count; ++k) {
    dxdt[k] = x[count + k];
    dxdt[count + k] = -x[k] + cos(SLIP == 3 ? t[0] : t[k]);
  }
}

static const lober_conjugate_pair pairs[] = {{0, 1, NULL}};
static const lober_flow flow = {2, velocity, jacobian, period, hamiltonian, 1, pairs, NULL, velocity_batch};
static const lober_system description = {LOBER_SYSTEM_ABI, LOBER_FLOW, "slip", "", 0,    NULL, {-2, -2, 2, 2},
                                         {0, 0},           NULL,       &flow,  0,  NULL, 0, NULL, NULL, {0, 0}};

const lober_system* lober_system_describe(void) {
  return &description;
}

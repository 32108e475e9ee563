/* A forced pendulum x'' = -sin x + 0.1 cos t with one slip: SLIP 1 in the Jacobian, 2 in the Hamiltonian, 3 in
   velocity_batch, 4 in the period, 5 in the lattice, 6 a Jacobian that gives no numbers, 7 a Hamiltonian that gives
   none; 0 nowhere, nor 8 and 9, where x has another unit. */
#include <math.h>

#include "lober/lober_system.h"

#define UNIT (SLIP == 8 ? 1e-6 : SLIP == 9 ? 1e6 : 1.0)

static int velocity(const double* a, const double* x, double t, double* dxdt) {
  (void)a;
  dxdt[0] = x[1];
  dxdt[1] = UNIT * (0.1 * cos(t) - sin(x[0] / UNIT));
  return 0;
}

static int jacobian(const double* a, const double* x, double t, double* j) {
  (void)a, (void)t;
  j[0] = SLIP == 6 ? NAN : 0;
  j[1] = 1;
  j[2] = SLIP == 1 ? 2 : -cos(x[0] / UNIT);
  j[3] = 0;
  return 0;
}

static double period(const double* a) {
  (void)a;
  return SLIP == 4 ? 6 : 6.283185307179586;
}

static double hamiltonian(const double* a, const double* x, double t) {
  (void)a;
  if (SLIP == 7) return NAN;
  return 0.5 * x[1] * x[1] - UNIT * UNIT * cos(x[0] / UNIT) - (SLIP == 2 ? 0 : 0.1 * UNIT * x[0] * cos(t));
}

static void velocity_batch(const double* a, size_t count, const double* x, const double* t, double* dxdt) {
  (void)a;
  for (size_t k = 0; k < count; ++k) {
    dxdt[k] = x[count + k];
    dxdt[count + k] = UNIT * (0.1 * cos(SLIP == 3 ? t[0] : t[k]) - sin(x[k] / UNIT));
  }
}

static const lober_conjugate_pair pairs[] = {{0, 1, NULL}};
static const lober_flow flow = {2, velocity, jacobian, period, hamiltonian, 1, pairs, NULL, velocity_batch};
static const lober_system description = {LOBER_SYSTEM_ABI,
                                         LOBER_FLOW,
                                         "slip",
                                         "",
                                         0,
                                         NULL,
                                         {-4 * UNIT, -4 * UNIT, 4 * UNIT, 4 * UNIT},
                                         {SLIP == 5 ? 1 : UNIT * 6.283185307179586, 0},
                                         NULL,
                                         &flow,
                                         0,
                                         NULL,
                                         0,
                                         NULL,
                                         NULL,
                                         {0, 0}};

const lober_system* lober_system_describe(void) {
  return &description;
}

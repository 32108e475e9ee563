/* The area-preserving Henon map with one slip: SLIP 1 in the derivative, 2 in the inverse, 3 in the action, 4 in the
   lattice, 5 a derivative that always fails, 6 one that gives no numbers, 0 nowhere. */
#include <math.h>

#include "lober/lober_system.h"

static int forward(const double* a, const double z[2], double image[2]) {
  const double x = z[0];
  image[0] = x * x - a[0] - z[1];
  image[1] = x;
  return 0;
}

static int backward(const double* a, const double z[2], double image[2]) {
  const double y = z[1];
  image[1] = y * y - a[0] - z[0] + (SLIP == 2 ? 1e-3 : 0);
  image[0] = y;
  return 0;
}

static int derivative(const double* a, const double z[2], double d[4]) {
  (void)a;
  d[0] = SLIP == 6 ? NAN : 2 * z[0];
  d[1] = SLIP == 1 ? 1 : -1;
  d[2] = 1;
  d[3] = 0;
  return SLIP == 5;
}

/* y' = x = dL/dx', y = x^2 - k - x' = -dL/dx. */
static double action(const double* a, double x, double to) {
  return x * to - x * x * x / (SLIP == 3 ? 2 : 3) + a[0] * x;
}

static const lober_map map = {forward, backward, derivative, action};
static const lober_parameter k = {"k", 0.5, "of the map"};
static const lober_system description = {LOBER_SYSTEM_ABI,
                                         LOBER_MAP,
                                         "slip",
                                         "",
                                         1,
                                         &k,
                                         {-3, -3, 3, 3},
                                         {SLIP == 4 ? 3 : 0, 0},
                                         &map,
                                         NULL,
                                         0,
                                         NULL,
                                         0,
                                         NULL,
                                         NULL,
                                         {0, 0}};

const lober_system* lober_system_describe(void) {
  return &description;
}

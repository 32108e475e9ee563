/* A map that preserves area at its saddle only: (x, y) -> (x^2 - k - y, g(x)), g(x) = x + c (x - s)^3, s the saddle. */
#include <math.h>

#include "lober/lober_system.h"

static double saddle(const double* a) {
  return 1 + sqrt(1 + a[0]);
}
static double shear(const double* a, double x) {
  const double d = x - saddle(a);
  return x + a[1] * d * d * d;
}

static int forward(const double* a, const double z[2], double image[2]) {
  const double x = z[0];
  image[0] = x * x - a[0] - z[1];
  image[1] = shear(a, x);
  return 0;
}

/* Newton's method; g rises everywhere. */
static int backward(const double* a, const double z[2], double image[2]) {
  double x = z[1];
  int k;
  for (k = 0; k < 60; ++k) {
    const double d = x - saddle(a);
    x -= (shear(a, x) - z[1]) / (1 + 3 * a[1] * d * d);
  }
  image[1] = x * x - a[0] - z[0];
  image[0] = x;
  return 0;
}

static int derivative(const double* a, const double z[2], double d[4]) {
  const double e = z[0] - saddle(a);
  d[0] = 2 * z[0];
  d[1] = -1;
  d[2] = 1 + 3 * a[1] * e * e;
  d[3] = 0;
  return 0;
}

static int connection(const double* a, size_t index, lober_connection* found) {
  if (index != 0) return 1;
  found->from[0] = found->from[1] = found->to[0] = found->to[1] = saddle(a);
  found->u_direction[0] = found->u_direction[1] = found->s_direction[0] = found->s_direction[1] = -1;
  return 0;
}

static const lober_map map = {forward, backward, derivative, NULL};
static const lober_parameter parameters[] = {{"k", 0.5, "of the map"}, {"c", 0.001, "of the leak"}};
static const lober_system description = {
    LOBER_SYSTEM_ABI, LOBER_MAP, "leaky", "", 2, parameters, {-3, -3, 3, 3}, {0, 0}, &map, NULL, 1, connection, 0, NULL, NULL, {0, 0}};

const lober_system* lober_system_describe(void) {
  return &description;
}

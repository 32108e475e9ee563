/* The area-preserving Henon map with the manifolds of its saddle, whose path back is spelled out. */
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
  image[1] = y * y - a[0] - z[0];
  image[0] = y;
  return 0;
}

static int derivative(const double* a, const double z[2], double d[4]) {
  (void)a;
  d[0] = 2 * z[0];
  d[1] = -1;
  d[2] = 1;
  d[3] = 0;
  return 0;
}

static const lober_map map = {forward, backward, derivative, NULL};
static const lober_parameter k = {"k", 0.5, "of the map"};

static int connection(const double* a, size_t index, lober_connection* found) {
  const double saddle = 1 + sqrt(1 + a[0]);
  if (index != 0) return 1;
  found->from[0] = found->from[1] = found->to[0] = found->to[1] = saddle;
  found->u_direction[0] = found->u_direction[1] = found->s_direction[0] = found->s_direction[1] = -1;
  found->has_bip = 1;
  found->bip[0] = -1.533;
  found->bip[1] = 0.925;
  return 0;
}

static const lober_system description = {LOBER_SYSTEM_ABI, LOBER_MAP, "henon-c", "", 1,          &k, {-3, -3, 3, 3},
                                         {0, 0},           &map,      NULL,      1,  connection, 0, NULL, NULL, {0, 0}};

const lober_system* lober_system_describe(void) {
  return &description;
}

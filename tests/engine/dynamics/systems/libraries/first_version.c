/* The area-preserving Henon map as version 1 of the interface had it: nothing behind `flow` is there, so nothing may be
   read; here it would look like connections. */
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

static const lober_system description = {1,      LOBER_MAP, "henon-1", "",   1,    &k, {-3, -3, 3, 3},
                                         {0, 0}, &map,      NULL,      1000, NULL, 1};

const lober_system* lober_system_describe(void) {
  return &description;
}

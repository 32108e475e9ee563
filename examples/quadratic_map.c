/* A system of your own in C: the quadratic map of Henon (1969) as a rotation after a shear,
   (x, y) -> (x cos a - (y - x^2) sin a, x sin a + (y - x^2) cos a).

       cc -shared -fPIC -O2 -Iengine examples/quadratic_map.c -o quadratic_map.so -lm */
#include <math.h>

#include "lober/lober_system.h"

static int forward(const double* a, const double z[2], double image[2]) {
  const double c = cos(a[0]), s = sin(a[0]), y = z[1] - z[0] * z[0];
  image[0] = z[0] * c - y * s;
  image[1] = z[0] * s + y * c;
  return 0;
}

static int backward(const double* a, const double z[2], double image[2]) {
  const double c = cos(a[0]), s = sin(a[0]), x = z[0] * c + z[1] * s;
  image[0] = x;
  image[1] = z[1] * c - z[0] * s + x * x;
  return 0;
}

static int derivative(const double* a, const double z[2], double d[4]) {
  const double c = cos(a[0]), s = sin(a[0]);
  d[0] = c + 2 * z[0] * s;
  d[1] = -s;
  d[2] = s - 2 * z[0] * c;
  d[3] = c;
  return 0;
}

/* y = (x c - x') / s + x^2 and y' = (x - c x') / s, as functions of x and x', are -dL/dx and dL/dx'. */
static double action(const double* a, double x, double to) {
  const double c = cos(a[0]), s = sin(a[0]);
  return (x * to - 0.5 * c * (x * x + to * to)) / s - x * x * x / 3;
}

static const lober_parameter parameters[] = {{"angle", 1.3, "of rotation, radians"}};
static const lober_map map = {forward, backward, derivative, action};
/* Any angle but the multiples of pi, which have no action. What is not named is 0 or NULL. */
static const lober_system description = {.abi = LOBER_SYSTEM_ABI,
                                         .kind = LOBER_MAP,
                                         .name = "quadratic",
                                         .summary = "Henon's quadratic map: a rotation after a shear",
                                         .parameter_count = 1,
                                         .parameters = parameters,
                                         .window = {-2, -2, 2, 2},
                                         .map = &map};

const lober_system* lober_system_describe(void) {
  return &description;
}

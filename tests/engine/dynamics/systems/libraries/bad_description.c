/* The shear with one slip in its description: SLIP 1 in the number of connections, 2 in the window, 3 in the lattice, 4 in
   the second lattice, 5 in the name, 6 in the name of a parameter, 7 in a connection, 0 nowhere. */
#include <math.h>

#include "lober/lober_system.h"

static int forward(const double* a, const double z[2], double image[2]) {
  image[0] = z[0] + a[0] * z[1];
  image[1] = z[1];
  return 0;
}

static int backward(const double* a, const double z[2], double image[2]) {
  image[0] = z[0] - a[0] * z[1];
  image[1] = z[1];
  return 0;
}

static int derivative(const double* a, const double z[2], double d[4]) {
  (void)z;
  d[0] = 1;
  d[1] = a[0];
  d[2] = 0;
  d[3] = 1;
  return 0;
}

static const lober_map map = {forward, backward, derivative, NULL};
static const lober_parameter rate = {SLIP == 6 ? "r\xe4te" : "rate", 1, "of the shear"};

static int connection(const double* a, size_t index, lober_connection* found) {
  (void)a, (void)index;
  found->u_direction[0] = SLIP == 7 ? NAN : 1;
  found->s_direction[1] = 1;
  return 0;
}

static const lober_system description = {LOBER_SYSTEM_ABI,
                                         LOBER_MAP,
                                         SLIP == 5 ? "she\xffr" : "shear",
                                         "",
                                         1,
                                         &rate,
                                         {-1, -1, SLIP == 2 ? NAN : 1, 1},
                                         {SLIP == 3 ? INFINITY : 0, 0},
                                         &map,
                                         NULL,
                                         SLIP == 1 ? (size_t)-1 : 1,
                                         connection,
                                         0,
                                         NULL,
                                         NULL,
                                         {0, SLIP == 4 ? NAN : 0}};

const lober_system* lober_system_describe(void) {
  return &description;
}

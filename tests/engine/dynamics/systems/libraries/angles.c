/* A section of an angle and two lifted angles, version 4: the ABC flow. Built with SLIP = 1 to 3 its ranges or the name
   of its perturbation are wrong. */
#include <math.h>
#include <stddef.h>

#include "lober/lober_system.h"

#ifndef SLIP
#define SLIP 0
#endif
#define TWO_PI 6.283185307179586

static int velocity(const double* p, const double* x, double t, double* v) {
  (void)t;
  v[0] = p[0] * sin(x[2]) + p[2] * cos(x[1]);
  v[1] = p[1] * sin(x[0]) + p[0] * cos(x[2]);
  v[2] = p[2] * sin(x[1]) + p[1] * cos(x[0]);
  return 0;
}

static int jacobian(const double* p, const double* x, double t, double* j) {
  (void)t;
  const double rows[] = {0, -p[2] * sin(x[1]), p[0] * cos(x[2]),  p[1] * cos(x[0]),
                         0, -p[0] * sin(x[2]), -p[1] * sin(x[0]), p[2] * cos(x[1]),
                         0};
  for (size_t k = 0; k < 9; ++k) j[k] = rows[k];
  return 0;
}

static const lober_parameter parameters[] = {
    {"A", 1.7320508075688772, "wave along z"}, {"B", 1.4142135623730951, "wave along x"}, {"C", 1, "wave along y"}};
static const lober_range ranges[] = {
    {-INFINITY, INFINITY, 0, 0}, {0, SLIP == 1 ? -1 : INFINITY, 1, 0}, {0, SLIP == 2 ? 0.5 : 2, 0, 1}};
static const lober_section section = {2, 0, 1, 0, 1, -1, -1, 0, 0, 0, TWO_PI};
static const lober_flow flow = {3, velocity, jacobian, NULL, NULL, 0, NULL, &section, NULL};
static const lober_system description = {LOBER_SYSTEM_ABI,
                                         LOBER_FLOW,
                                         "abc-c",
                                         "",
                                         3,
                                         parameters,
                                         {-TWO_PI / 2, -TWO_PI / 2, TWO_PI / 2, TWO_PI / 2},
                                         {TWO_PI, 0},
                                         NULL,
                                         &flow,
                                         0,
                                         NULL,
                                         0,
                                         ranges,
                                         SLIP == 3 ? "D" : "C",
                                         {0, TWO_PI}};

const lober_system* lober_system_describe(void) {
  return &description;
}

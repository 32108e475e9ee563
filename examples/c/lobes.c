/* The lobes of two curves, transport of the standard map, and many curves against each other, from C:
       cc lobes.c $(pkg-config --cflags --libs lober) -lm -o lobes */
#include <lober/lober.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void check(int status) {
  if (status == LOBER_OK) return;
  fprintf(stderr, "%s\n", lober_message());
  exit(status);
}

int main(void) {
  enum { n = 1000 };
  static double circle[2 * n], wave[2 * n];
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * 3.14159265358979323846 * k / n, radius = 1 + 0.2 * sin(5 * angle);
    circle[2 * k] = cos(angle);
    circle[2 * k + 1] = sin(angle);
    wave[2 * k] = radius * cos(angle);
    wave[2 * k + 1] = radius * sin(angle);
  }
  lober_result* result = NULL;
  check(lober_overlay(circle, n, wave, n, NULL, &result));
  lober_array lobes;
  check(lober_array_named(result, "pieces.c1_minus_c2.area", &lobes));
  printf("%zu lobes of area %.12f in all\n", lobes.rows, lober_number(result, "areas.c1_minus_c2"));
  lober_result_free(result);

  lober_model* map = NULL;
  check(lober_model_open("standard", "K=1.2", NULL, &map));
  check(lober_transport(map, "iterates=3", &result));
  lober_array flux;
  check(lober_array_named(result, "turnstile.flux12", &flux));
  printf("flux %.9f\n", ((const double*)flux.data)[0]);
  lober_result_free(result);
  lober_model_free(map);

  /* A row of five circles, each of which overlaps some of the others. The points of all follow each other. */
  enum { circles = 5 };
  static double row[2 * n * circles];
  size_t begin[circles + 1];
  for (size_t k = 0; k <= circles; ++k) begin[k] = k * n;
  for (int k = 0; k < n * circles; ++k) {
    row[2 * k] = circle[2 * (k % n)] + 0.6 * (k / n);
    row[2 * k + 1] = circle[2 * (k % n) + 1];
  }
  check(lober_overlap_matrix(row, begin, circles, NULL, NULL, 0, "what=intersection,crossings dense=1", &result));
  lober_array shared, crossings;
  check(lober_array_named(result, "intersection", &shared));
  check(lober_array_named(result, "crossings", &crossings));
  const double *areas = shared.data, *counts = crossings.data;
  for (size_t k = 1; k < circles; ++k) printf("%.9f %.0f\n", areas[k], counts[k]);
  lober_result_free(result);
  return 0;
}

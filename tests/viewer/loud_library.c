/* The quadratic map in a library that shows that it was loaded: it leaves a file named "loaded" in the folder. */
#include <stdio.h>

#include "examples/quadratic_map.c"

__attribute__((constructor)) static void leave_a_file(void) {
  FILE* const file = fopen("loaded", "w");
  if (file != NULL) fclose(file);
}

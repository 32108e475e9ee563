/* lober for C, and for all languages that call C: Julia, Fortran, MATLAB and Octave, R, Python's ctypes.

       lober_result* lobes = NULL;
       if (lober_overlay(curve1, n1, curve2, n2, "threads=2", &lobes) != LOBER_OK) {
         fprintf(stderr, "%s\n", lober_message());
         exit(1);
       }
       double flux = lober_number(lobes, "areas.c1_minus_c2");
       lober_array areas;
       lober_array_named(lobes, "pieces.c1_minus_c2.area", &areas);   areas.rows doubles from areas.data
       lober_result_free(lobes);

   Link with liblober.so (pkg-config lober; -DBUILD_SHARED_LIBS=ON). Points are pairs of doubles, x and y, one after the
   other; a curve of n points is an array of 2 n doubles, which is only read, and need not outlive the call. A closed
   curve joins its last point to the first, which need not be repeated. Units are those of the coordinates; areas are in
   their square. Definitions and signs: docs/conventions.md.

   A result is a list of named arrays, which belong to it: they are valid until lober_result_free. Each operation says
   which arrays it makes. Numbers are arrays of one row and column. A matrix is stored row by row.

   Options are one text of words NAME=VALUE, separated by blanks, or NULL. All operations know threads=N, 0 (one for
   each core) to 4096. A name that an operation does not know is refused, with the known names.

   Functions that return int return LOBER_OK or a status; then lober_message() says in a sentence what is wrong, and
   *result is NULL unless the status says that there is one. No exception leaves this interface, and no signal is
   handled. All functions may be called from several threads at the same time, with the same results and models too,
   except that nothing else may use an object that is being freed. Results are the same bits for any number of threads.

   Within a minor version of lober functions and names of arrays are only added (docs/stability.md). */
#ifndef LOBER_H
#define LOBER_H

#include <stddef.h>
#include <stdint.h>

/* A function of the interface. */
#if defined(__GNUC__)
#define LOBER_C_API __attribute__((visibility("default")))
#else
#define LOBER_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Raised with each addition to this header. */
#define LOBER_INTERFACE_VERSION 4
/* The interface version of the linked library. */
LOBER_C_API int lober_interface_version(void);
/* The version of the linked library: "0.2.0". */
LOBER_C_API const char* lober_version(void);

/* The numbers of the program's exit status. */
enum lober_status {
  LOBER_OK = 0,
  LOBER_DATA_ERROR = 1,   /* a curve, a file or a system that cannot be used */
  LOBER_USAGE_ERROR = 2,  /* an option or an argument that makes no sense */
  LOBER_DISAGREEMENT = 3, /* two routes to a number differ beyond their error bars; there is a result all the same */
  LOBER_OUT_OF_MEMORY = 4,
  LOBER_INTERNAL_ERROR = 5, /* a defect of lober */
  LOBER_INCOMPLETE = 6,     /* a limit, such as max_points, ended the work; there is a result all the same */
  LOBER_CANCELLED = 130     /* the progress function returned 0 */
};

/* Why the last failed call of this thread failed; "" before any failed. Valid until the next call fails. */
LOBER_C_API const char* lober_message(void);

/* Called during long operations of this thread, several times a second, by one thread at a time: with the fraction
   done, or -1 where it is not known. 0 cancels. NULL: none. It may be called by another thread, and cannot call lober:
   functions that return a status refuse with LOBER_USAGE_ERROR. */
typedef int (*lober_progress)(double fraction, void* context);
/* Sets the progress function of this thread, which is called with `context`. */
LOBER_C_API void lober_set_progress(lober_progress function, void* context);

/* ------------------------------------------------------------------------------------------------------------ results
 */

typedef struct lober_result lober_result;

/* Type of the elements of an array. */
enum lober_type {
  LOBER_DOUBLES = 1,  /* const double* */
  LOBER_INTEGERS = 2, /* const int64_t* */
  LOBER_TEXT = 3      /* const char*, ended by a zero that `columns` does not count; rows is 1 */
};

/* An array of a result, which belongs to it. */
typedef struct lober_array {
  const char* name;     /* such as "areas.c1_minus_c2" */
  int type;             /* LOBER_DOUBLES, LOBER_INTEGERS or LOBER_TEXT */
  const void* data;     /* the elements, row by row */
  size_t rows, columns; /* its shape */
} lober_array;

/* Number of arrays. */
LOBER_C_API size_t lober_array_count(const lober_result* result);
/* The array of this number, from 0. LOBER_USAGE_ERROR where there is none. */
LOBER_C_API int lober_array_at(const lober_result* result, size_t number, lober_array* array);
/* The array of this name. LOBER_USAGE_ERROR where there is none. */
LOBER_C_API int lober_array_named(const lober_result* result, const char* name, lober_array* array);
/* The only number of an array, also of integers; NaN where there is no number or no such array. */
LOBER_C_API double lober_number(const lober_result* result, const char* name);
/* NULL is allowed. */
LOBER_C_API void lober_result_free(lober_result* result);

/* Polygons of one piece of a result of lober_overlay ("intersection", "union", "c1_minus_c2", "c2_minus_c1"), or of a
   lobe of a tangle ("lobes"; "boundary" has the piece 0), with the option outlines=1. Arrays: points (n x 2), begin:
   the row where each polygon begins; the outer one first, counter-clockwise, then its holes, clockwise. */
LOBER_C_API int lober_outline(const lober_result* of, const char* kind, size_t piece, lober_result** result);

/* ------------------------------------------------------------------------------------------------------------- curves
 */

/* These are calls of the operations of their names; lober_call describes their common parts. Each has the
   option outlines=0|1 (0): the result keeps the curves given, for lober_outline. */

/* Areas, pieces and crossings of two simple closed curves (lober/overlay.hpp). Options: areas_only=0|1,
   check_simple=0|1 and more. Among its arrays: areas.NAME and error.rounding.NAME of c1, c2, intersection, union,
   c1_minus_c2, c2_minus_c1, symmetric_difference; pieces.PAIRING.area; crossings.list.x, .y, .rho, .segment1,
   .segment2, .class. */
LOBER_C_API int lober_overlay(const double* curve1, size_t n1, const double* curve2, size_t n2, const char* options,
                              lober_result** result);
/* The same areas by the interior function (lober/interior.hpp). Options: method=split|ends, passes=N, points=N,
   check_simple=0|1 and more. Among its arrays: areas.NAME, error.rounding.NAME, q1, q2, q3, delta. */
LOBER_C_API int lober_interior(const double* curve1, size_t n1, const double* curve2, size_t n2, const char* options,
                               lober_result** result);
/* Regions of closed curves that may cross themselves (lober/regions.hpp); n2 = 0: of one curve. Options:
   rule=nonzero|evenodd|positive|negative and more. Among its arrays: winding.c1, winding.c2, winding.area; areas.NAME,
   error.rounding.NAME by the rule; pieces.PAIRING.area. */
LOBER_C_API int lober_regions(const double* curve1, size_t n1, const double* curve2, size_t n2, const char* options,
                              lober_result** result);
/* Each closed curve of one set with each of another, in memory (lober/overlay/overlap_matrix.hpp). The points of a set
   follow each other: curve k are the points begin[k] to begin[k + 1], so that begin has count + 1 numbers. With NULL,
   NULL, 0 the curves of one set with each other. Options: what=NAME,... (intersection), of intersection, union,
   c1_minus_c2, c2_minus_c1, symmetric_difference, crossings, touches and shared_arcs; dense=0|1 (0);
   check_simple=0|1 (1); keep_going=0|1 (0): a curve that cannot be used is a failure and not the end. Arrays: NAME, and
   error.rounding.NAME of areas; with dense=1 count1 x count2, else a number for each pair that has a point in common:
   row i has those from begin[i] to begin[i + 1], of the curves column[...]. areas1, areas2: of the curves; pairs: number
   of pairs that were overlaid; failures.row, failures.column (-1: none) and failures.message, a line each. */
LOBER_C_API int lober_overlap_matrix(const double* points1, const size_t* begin1, size_t count1, const double* points2,
                                     const size_t* begin2, size_t count2, const char* options, lober_result** result);
/* Winding numbers of a closed curve about points. Arrays: points.winding, points.on (0 or 1), points.j: the interior
   function. */
LOBER_C_API int lober_winding(const double* curve, size_t n, const double* points, size_t count, const char* options,
                              lober_result** result);
/* Signed area of a closed curve, positive counter-clockwise. */
LOBER_C_API int lober_signed_area(const double* curve, size_t n, double* area);
/* More points: lober_call of "densify" (lober/densify.hpp). Options: closed=true|false (true), max_length=D,
   angle=RADIANS, distance_angle=D, min_length=D, interpolation=linear|dritschel|spline, max_points=N and more; with a
   second input for passes=N, points=N and crossings=true use lober_call. Among its arrays: points;
   diagnostics.list.segment, .count and .cause: segments that break a criterion, and why: min_length, corner,
   max_points, max_rounds. Returns LOBER_INCOMPLETE with a result where one of the last two ended the work. */
LOBER_C_API int lober_densify(const double* curve, size_t n, const char* options, lober_result** result);
/* Fewer points: lober_call of "simplify". Options: closed=true|false (true), tolerance=D, max_length=D. Among its
   arrays: points. */
LOBER_C_API int lober_simplify(const double* curve, size_t n, const char* options, lober_result** result);
/* Pips, lobes and overlaps of two manifolds, outward from their saddles (lober/tangle.hpp). Options: bip=N,
   bip_near=X,Y, period=N, smooth=0|1, overlaps=0|1, check_simple=0|1 and more. Among its arrays: pips.x, pips.y,
   pips.rho; lobes.area (signed), lobes.inside, lobes.outside, lobes.discretisation, lobes.label: a line each;
   overlaps.i, overlaps.j, overlaps.area; bip.index, boundary.area, images.period. */
LOBER_C_API int lober_tangle(const double* u, size_t nu, const double* s, size_t ns, const char* options,
                             lober_result** result);

/* -------------------------------------------------------------------------------------------------------------- files
 */

/* One curve of a file as the program reads it, of any format that it reads: FILE, or FILE#K for zone K from 0,
   FILE#TITLE for that of a title, FILE:LON,LAT for columns of a table or arrays of a file. Options: closed=0|1 (1).
   Arrays: points. */
LOBER_C_API int lober_read(const char* spec, const char* options, lober_result** result);
/* Writes points as an open curve, in the format of the ending: .npy, .csv, .dat (Tecplot), .geojson and more (`lober doctor`
   lists them); under any other name as text. */
LOBER_C_API int lober_write(const char* path, const double* points, size_t n);

/* ------------------------------------------------------------------------------------------------------------ dynamics
 */

/* A map, or a flow with its map: built in, or a shared library (lober/lober_system.h). */
typedef struct lober_model lober_model;
/* Parameters: words NAME=VALUE; the others have their defaults. Options: tolerance=D of the integration. */
LOBER_C_API int lober_model_open(const char* name, const char* parameters, const char* options, lober_model** model);
/* NULL is allowed. */
LOBER_C_API void lober_model_free(lober_model* model);
/* Names, summaries, parameters and defaults of the built-in systems, as lines of text. Arrays: names, summaries. */
LOBER_C_API int lober_systems(lober_result** result);
/* Replaces each point by its image; NaN where an orbit is lost. Negative iterates use the inverse. Where the call
   fails or is cancelled, points stay as they were. */
LOBER_C_API int lober_iterate(const lober_model* model, double* points, size_t n, int iterates);
/* Fixed and periodic points in a box: lober_call of "fixed_points". Options: box=XMIN,YMIN,XMAX,YMAX, period=N,
   turns=N, grid=N, max_grid=N, budget=SECONDS. Among its arrays: points.x, points.y, points.residue, points.type: a
   line each; points.derivative and points.multipliers (n x 4, row by row); search.settled. */
LOBER_C_API int lober_fixed_points(const lober_model* model, const char* options, lober_result** result);
/* A branch of the manifold of a saddle: lober_call of "grow". Options: from=X,Y near the saddle (that of the system),
   side=unstable|stable, branch=+|-|X,Y: a vector roughly along it (that of the system, else the one of larger x),
   tolerance=D, iterates=N, length=D, max_points=N, period=N and more. Among its arrays: points, parameters,
   result.generations, local_manifold.saddle, local_manifold.multiplier, result.length, result.stop. Returns
   LOBER_INCOMPLETE with a result where max_points ends the work, or no point has an image. */
LOBER_C_API int lober_grow(const lober_model* model, const char* options, lober_result** result);
/* Images of a curve under the map, with as many points as they need: lober_call of "image". Options: closed=0|1 (1),
   first=N (1), last=N (first), tolerance=D, max_length=D, max_points=N and more. Among its arrays: images.0.polygon:
   the points, and images.0.parameters of the first; images.0.area (1 x 2): area and error. LOBER_INCOMPLETE as
   lober_grow. */
LOBER_C_API int lober_image(const lober_model* model, const double* curve, size_t n, const char* options,
                            lober_result** result);
/* The tangle of the system's saddles: lober_call of "manifold_tangle". Options: tolerance=D, before=N, after=N,
   smooth=0|1, max_points=N, bip=X,Y and more. Arrays: those of lober_tangle, and among others u, s: points of both;
   turnstile_by_action.lobes.action (n x 2): area and error; saddles.unstable.at, saddles.unstable.multiplier. */
LOBER_C_API int lober_model_tangle(const lober_model* model, const char* options, lober_result** result);
/* Transport between the regions of the system: lober_call of "transport". Among its arrays: regions.area (n x 2): area,
   error; turnstile.flux12, turnstile.flux21 (1 x 2): of the first boundary in one iterate; steps.a_ij and steps.T_ij
   (steps x 2 regions^2): a_ij(n) and T_ij(n), each followed by its error, row by row; iterates_a_step; remarks: a line
   each. */
LOBER_C_API int lober_transport(const lober_model* model, const char* options, lober_result** result);

/* ---------------------------------------------------------------------------------------------------------- operations
 */

/* Points of a curve, or others; or a model. */
typedef struct lober_input {
  const double* points;     /* x, y of each point; NULL for a model */
  size_t n;                 /* number of points */
  const lober_model* model; /* a system; NULL for points */
} lober_input;
/* Runs an operation of the table (lober/operations.hpp) by its name. Options are those of the table, 1 or 0 for true or
   false, X,Y for points, numbers with commas between for boxes and lists; threads=N; outlines=1 keeps a copy of the
   curves given, for lober_outline. Each field of the result is an array: NAME of a member, "OBJECT.MEMBER",
   "LIST.MEMBER" with a row for each element; "LIST.K.MEMBER" where elements hold lists. Numbers with an error bar have
   two columns; fields of several numbers as many columns, or NAME.sizes beside them where elements have different
   numbers of them. Where routes disagree: LOBER_DISAGREEMENT with a result and disagreements, a line each. */
LOBER_C_API int lober_call(const char* operation, const lober_input* inputs, size_t count, const char* options,
                           lober_result** result);
/* Arrays: names, summaries, schemas (JSON Schema of the members of each result): a line each. */
LOBER_C_API int lober_operations(lober_result** result);

#ifdef __cplusplus
}
#endif
#endif

/* A map or a flow of your own, as a shared library that lober loads:

       cc -shared -fPIC -O2 mysystem.c -o mysystem.so
       lober systems ./mysystem.so

   Its path stands for the name of a system in every command.

   The library exports one function, lober_system_describe, which returns a description that stays valid as long as
   the library is loaded. See examples/quadratic_map.c and examples/henon_heiles.cpp.

   All functions get the values of the parameters, in the order in which they are listed, and must be pure: the same
   arguments give the same result, and several threads call them at the same time. Those that return int return 0
   for success; otherwise the point counts as lost. They must not throw.

   When a system is made, some points of its window are checked: the inverse of a map, its derivative and its action,
   the Jacobian of a flow, its Hamiltonian and velocity_batch, with finite differences where that is needed. A system
   whose functions do not belong together is refused, with the place and both numbers. */
#ifndef LOBER_SYSTEM_H
#define LOBER_SYSTEM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Raised whenever the structures below change their layout. Version 2 added the connections at the end of lober_system,
   version 3 velocity_batch at the end of lober_flow, version 4 the ranges, the perturbation and the second lattice at
   the end of lober_system and the period at the end of lober_section, version 5 the saddles at the end of lober_system;
   libraries built for earlier versions are still loaded. */
#define LOBER_SYSTEM_ABI 5
#define LOBER_MAX_DIMENSION 6 /* coordinates of a flow at most */

/* The kind of a system. */
typedef enum lober_kind { LOBER_MAP = 1, LOBER_FLOW = 2 } lober_kind;

/* A parameter of a system. */
typedef struct lober_parameter {
  const char* name;     /* the name on the command line */
  double default_value; /* the value when it is not given */
  const char* meaning;  /* a phrase */
} lober_parameter;

/* The values of a parameter that make sense: min to max, without min or max where it is excluded. -INFINITY and
   INFINITY (math.h) where there is no bound. Others are refused before any function of the library is called with them.
 */
typedef struct lober_range {
  double min, max;                /* the bounds */
  int min_excluded, max_excluded; /* not 0: the bound itself is excluded */
} lober_range;

/* A diffeomorphism of the plane; points are x, y. */
typedef struct lober_map {
  /* The map. */
  int (*forward)(const double* parameters, const double point[2], double image[2]);
  /* The inverse map. */
  int (*backward)(const double* parameters, const double point[2], double image[2]);
  /* Derivative of the forward map: dx'/dx, dx'/dy, dy'/dx, dy'/dy. */
  int (*derivative)(const double* parameters, const double point[2], double derivative[4]);
  /* Optional (NULL): the generating function L(from x, to x) of a map that preserves area, with dL/dx' = y' and
     dL/dx = -y. Lobe areas by action need it. */
  double (*action)(const double* parameters, double from_x, double to_x);
} lober_map;

/* Coordinates q and p such that q and factor * p are conjugate: factor dq/dt = dH/dp, factor dp/dt = -dH/dq. */
typedef struct lober_conjugate_pair {
  int q, p;                                   /* numbers of the coordinates */
  double (*factor)(const double* parameters); /* NULL: 1 */
} lober_conjugate_pair;

/* Return maps: crossings of x[coordinate] = value in the direction +1 or -1, in the chart (x[chart_x], x[chart_y]). */
typedef struct lober_section {
  int coordinate;       /* number of the coordinate that is constant */
  double value;         /* its value */
  int direction;        /* sign of its derivative at the crossings that count */
  int chart_x, chart_y; /* numbers of the coordinates of the planar map */
  int solved; /* the coordinate that follows from the energy, conjugate to `coordinate`; -1 in three dimensions */
  int energy_parameter; /* number of the parameter that is the energy; -1 in three dimensions */
  /* Only crossings with bound_side * (x[bound_coordinate] - bound) > 0 count; bound_side 0: all. */
  int bound_coordinate;
  double bound;   /* value that parts the sides */
  int bound_side; /* the side that counts */
  /* From version 4 on: where the coordinate is an angle, its period; crossings of value + k * period count for every
     whole number k. 0: the coordinate is not an angle. */
  double period;
} lober_section;

/* dx/dt = velocity(x, t) in `dimension` coordinates. */
typedef struct lober_flow {
  int dimension; /* 1 .. LOBER_MAX_DIMENSION */
  /* The velocity at x and t. */
  int (*velocity)(const double* parameters, const double* x, double t, double* dxdt);
  /* d(velocity i)/d(x j) at [i * dimension + j]. */
  int (*jacobian)(const double* parameters, const double* x, double t, double* jacobian);
  /* The period in time; NULL for an autonomous flow. A periodic flow of two dimensions gives a stroboscopic map; its
     phase, a fraction of the period, is the parameter called "phase" if there is one. */
  double (*period)(const double* parameters);
  /* Optional: the Hamiltonian, with its conjugate pairs. */
  double (*hamiltonian)(const double* parameters, const double* x, double t);
  size_t pair_count;                 /* number of conjugate pairs */
  const lober_conjugate_pair* pairs; /* the pairs */
  /* Optional: the section of an autonomous flow of three dimensions, or of four with a Hamiltonian. */
  const lober_section* section;
  /* Optional, from version 3 on: the velocity of `count` points at a time, each with its own time t[k], in a loop that
     the compiler can turn into vector instructions. Coordinate i of point k is x[i * count + k], dxdt likewise. The
     velocity at a point must not depend on the other points, bit for bit (so no -ffast-math); NaN stands for a velocity
     that does not exist. Trajectories use this function, Jacobians and actions do not. */
  void (*velocity_batch)(const double* parameters, size_t count, const double* x, const double* t, double* dxdt);
} lober_flow;

#define LOBER_MAX_CORNERS 16     /* corners of a closure at most */
#define LOBER_MAX_CONNECTIONS 64 /* connections of a system at most */

/* The manifolds that bound a region: U from the saddle near `from`, S from the one near `to`, each on the branch that
   leaves in the given direction. */
typedef struct lober_connection {
  double from[2], u_direction[2]; /* near the saddle of U, and the direction in which U leaves it */
  double to[2], s_direction[2];   /* near the saddle of S, and the direction in which S leaves it */
  int has_bip;                    /* whether `bip` is near a pip that is a good one to bound the region with */
  double bip[2];                  /* a point near that pip */
  /* Corners of the path from `to` back to `from` that the map keeps (walls, an axis) and that closes the boundary; none
     for a straight one, or where it closes itself. */
  size_t corner_count;                  /* 0 .. LOBER_MAX_CORNERS */
  double corners[LOBER_MAX_CORNERS][2]; /* from `to` on */
} lober_connection;

#define LOBER_MAX_SADDLES 64 /* saddles of a system at most */

/* The description of a system. */
typedef struct lober_system {
  unsigned abi;                      /* LOBER_SYSTEM_ABI */
  lober_kind kind;                   /* a map or a flow */
  const char* name;                  /* name in messages */
  /* One line; all texts are UTF-8. Pictures name their axes by the coordinates of the plane that it names last, with
     units in brackets: "...; map in (angle [rad], action [J s])". */
  const char* summary;
  size_t parameter_count;            /* number of parameters */
  const lober_parameter* parameters; /* the parameters, in the order in which functions get their values */
  /* The box of the fixed points of interest: min x, min y, max x, max y in the plane of the map. The largest power of ten
     in its extent is the unit by which tolerances and errors of integration are judged. */
  double window[4];
  /* The shift of the plane after which the map repeats itself; 0, 0 for none. */
  double lattice[2];
  const lober_map* map;   /* for LOBER_MAP */
  const lober_flow* flow; /* for LOBER_FLOW */
  /* From version 2 on. The number of connections whose boundaries bound regions, the first one region 1, up to
     LOBER_MAX_CONNECTIONS; 0 and NULL for none. `connection` fills in number `index`. */
  size_t connection_count;
  /* Fills in connection `index`. */
  int (*connection)(const double* parameters, size_t index, lober_connection* connection);
  /* Not 0: region 1 is bounded by all of them together, such as the strip of a cylinder between two boundaries. */
  int all_bound_region_1;
  /* From version 4 on. NULL, or a range for each parameter, in their order. */
  const lober_range* ranges;
  /* The name of the parameter that is the size of a perturbation, without which (at 0) manifolds coincide; NULL for
     none. Libraries of earlier versions have one if they call a parameter "eps". */
  const char* perturbation;
  /* A second shift in another direction after which the map repeats itself, where both coordinates are angles; 0, 0 for
     none. */
  double second_lattice[2];
  /* From version 5 on, for an autonomous flow of four dimensions with a Hamiltonian: the number of saddles whose
     bottlenecks bound a well, for escape, tubes and levels, up to LOBER_MAX_SADDLES; 0 and NULL for none. `saddle`
     fills in a state near number `index`; NAN for both momenta stands for those with which the position is at rest. */
  size_t saddle_count;
  /* Fills in saddle `index`. */
  int (*saddle)(const double* parameters, size_t index, double state[4]);
} lober_system;

#define LOBER_EXPORT __attribute__((visibility("default"))) /* a function that the library exports */

/* The one function that the library exports: its description, valid as long as the library is loaded. */
LOBER_EXPORT const lober_system* lober_system_describe(void);

#ifdef __cplusplus
}
#endif

#endif

// All of the library. Topics, each with its own header:
//
//   curves      curve.hpp, files.hpp, densify.hpp, drawing.hpp
//   areas       overlay.hpp (crossings, lobes, areas), interior.hpp, regions.hpp, smooth.hpp
//   tangles     tangle.hpp of curves, manifold_tangle.hpp of systems
//   dynamics    systems.hpp, planar_map.hpp, flow.hpp, fixed_points.hpp, manifolds.hpp, orbits.hpp, levels.hpp
//   transport   transport.hpp, sweep.hpp, melnikov.hpp, escape.hpp, monte_carlo.hpp
//   batch       batch.hpp
//
// The table of operations, operations.hpp, runs any of them by its name.
#pragma once

#include "lober/agreement.hpp"
#include "lober/areas.hpp"
#include "lober/batch.hpp"
#include "lober/buffer.hpp"
#include "lober/cancellation.hpp"
#include "lober/connecting_orbit.hpp"
#include "lober/counts.hpp"
#include "lober/crossings.hpp"
#include "lober/curve.hpp"
#include "lober/densify.hpp"
#include "lober/drawing.hpp"
#include "lober/element_iterator.hpp"
#include "lober/error.hpp"
#include "lober/escape.hpp"
#include "lober/export.hpp"
#include "lober/files.hpp"
#include "lober/fixed_points.hpp"
#include "lober/flow.hpp"
#include "lober/index.hpp"
#include "lober/interior.hpp"
#include "lober/levels.hpp"
#include "lober/local_manifold.hpp"
#include "lober/manifold_tangle.hpp"
#include "lober/manifolds.hpp"
#include "lober/melnikov.hpp"
#include "lober/monte_carlo.hpp"
#include "lober/operations.hpp"
#include "lober/orbits.hpp"
#include "lober/overlay.hpp"
#include "lober/periodic_orbit.hpp"
#include "lober/planar_map.hpp"
#include "lober/point.hpp"
#include "lober/progress.hpp"
#include "lober/regions.hpp"
#include "lober/segment_pair.hpp"
#include "lober/smooth.hpp"
#include "lober/sweep.hpp"
#include "lober/systems.hpp"
#include "lober/tangle.hpp"
#include "lober/threads.hpp"
#include "lober/transport.hpp"
#include "lober/tube_surface.hpp"
#include "lober/tubes.hpp"
#include "lober/version.hpp"

// All of the library, by topic:
//
//   curve.hpp       curves and their files
//   overlay.hpp     two curves: crossings, lobes, areas, regions
//   tangle.hpp      lobes of manifolds: of curves and of systems
//   dynamics.hpp    maps, flows, fixed points, manifolds
//   transport.hpp   fluxes, sweeps, Melnikov's method, escape
//   batch.hpp       many jobs from a manifest
//
// operations.hpp, the table of operations, runs any of them by its name. Each topic has a folder with a header for each
// concept, and base/ has what all share: errors, cancellation, progress, threads.
#pragma once

#include "lober/base/agreement.hpp"
#include "lober/base/buffer.hpp"
#include "lober/base/cancellation.hpp"
#include "lober/base/element_iterator.hpp"
#include "lober/base/error.hpp"
#include "lober/base/export.hpp"
#include "lober/base/measured.hpp"
#include "lober/base/progress.hpp"
#include "lober/base/threads.hpp"
#include "lober/base/version.hpp"
#include "lober/batch.hpp"
#include "lober/curve.hpp"
#include "lober/dynamics.hpp"
#include "lober/operations.hpp"
#include "lober/overlay.hpp"
#include "lober/tangle.hpp"
#include "lober/transport.hpp"

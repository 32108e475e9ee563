// The two steps of `arrange`: splitting the curves, and tracing the faces.
#pragma once

#include "tests/oracle/exact_arrangement.hpp"

namespace lober::oracle {

/// Fills points, edges, chain and chain_edges from `curves`.
void split_curves(Arrangement& arrangement);

/// Fills left and faces from the edges.
void trace_faces(Arrangement& arrangement);

}  // namespace lober::oracle

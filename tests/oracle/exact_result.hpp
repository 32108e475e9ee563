// The two halves of `exact_overlay`: where the curves meet, and the pieces between them.
#pragma once

#include "tests/oracle/exact_arrangement.hpp"
#include "tests/oracle/exact_overlay.hpp"

namespace lober::oracle {

/// Fills nodes, their counts and the orbits of sigma.
void find_nodes(const Arrangement& arrangement, ExactOverlay& overlay);

/// The pieces of one pairing, largest first.
[[nodiscard]] std::vector<ExactPiece> find_pieces(const Arrangement& arrangement, std::size_t pairing);

}  // namespace lober::oracle

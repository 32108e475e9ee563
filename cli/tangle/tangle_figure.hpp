// Parts of pictures of tangles, which those of transport share.
#pragma once

#include <string>

#include "cli/picture/figure.hpp"
#include "lober/tangle/tangle.hpp"

namespace lober::cli {

/// "L12(1)" with its regions as subscript.
[[nodiscard]] std::string lobe_text(const LobeLabel& label);
/// S, then U, borrowed.
void add_manifolds(Figure& figure, const Tangle& tangle);
/// A wide band, for below all others.
void add_boundary(Figure& figure, const Tangle& tangle, double area);
/// Squares, and their names: p, or p- and p+.
void add_saddles(Figure& figure, const Tangle& tangle, bool names);

}  // namespace lober::cli

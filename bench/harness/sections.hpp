// The tables of the benchmark. Each prints its own heading and explanation, as Markdown.
#pragma once

#include <ostream>

#include "bench/harness/options.hpp"

namespace lober::bench {

/// Every scene at options.points: time, multiple of the floor, with the check that curves are simple, totals
/// only, more threads, memory, phases, and areas against formulas.
void own_section(const Options& options, std::ostream& out);

/// The fast rivals at options.points.
void fast_rivals_section(const Options& options, std::ostream& out);

/// All rivals at options.small_points: run time against error.
void all_rivals_section(const Options& options, std::ostream& out);

/// Every scene from 10^4 to 10^7 points, and the exponents.
void growth_section(const Options& options, std::ostream& out);

}  // namespace lober::bench

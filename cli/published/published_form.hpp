// The first two command lines of Lober 1.8, unchanged:
//
//   lober <c1> <c2> <rslt> [-DENS <nPass> <nDens>]          by the overlay
//   lober -light <c1> <c2> <rslt> [-DENS <nPass> <nDens>]   by the interior method
//
// write <rslt>, one line `[C1 \ C2]  err%  [C2 \ C1]  err%`, and in the current directory c12.dat, c21.dat
// (vertices of C1, C2 outside the other curve), c11.dat, c22.dat (inside) and c10.dat, c20.dat (on it, the
// points where the curves meet included).
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// All arguments of the program. Throws UsageError, also for the third form of Lober 1.8;
/// DataError.
void run_published_form(const std::vector<std::string>& arguments);

}  // namespace lober::cli

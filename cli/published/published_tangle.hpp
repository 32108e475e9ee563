// The third command line of Lober 1.8:
//
//   lober <u> <s> <lobefile> <manifile> <pipsfile> <uskip> <sskip> <nzones> [<lobebfile> [<lobeseq>]] [-BIP k]
//
// <u> and <s> hold manifolds as zones, and may be one file. Zones uskip, uskip + 1, ... of <u> (from 0), nzones of
// them, are taken with zones sskip, sskip + 1, ... of <s>, pair by pair; z counts the pairs from 0. Written are
//
//   <lobefile>     100 x 100 points of a window that fits the lobes, with the number of the lobe that each lies in
//                  (lober/drawing.hpp); a zone for each pair
//   <manifile>     both manifolds of each pair as zones
//   <pipsfile>     the pips of each pair as a zone
//   <lobebfile>    a zone for each lobe, its first point repeated at the end, with the title `zone=z lobe=k`
//   <lobeseq>N.dat the same zones in a file each, N counting through all pairs from 0
//   separ.dat      in the current directory: the boundary of each pair, an open polyline; pip k is the bip, by default
//                  the middle one
//
// Pips and areas of lobes are printed. A pair without pips adds no zone to the files of pips and boundaries.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// Whether these arguments are meant to be the third form: eight that are no options, or -BIP.
[[nodiscard]] bool is_published_tangle(const std::vector<std::string>& arguments);

/// `arguments` are all arguments of the program. Throws UsageError, DataError, Cancelled.
void run_published_tangle(const std::vector<std::string>& arguments);

}  // namespace lober::cli

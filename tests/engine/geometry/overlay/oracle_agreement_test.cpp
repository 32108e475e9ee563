// The oracles against each other, without the engine: brute force in rationals, CGAL, and the sum over
// trapezoids. Only what three independent ways agree on is fit to judge the engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <sstream>
#include <string>

#include "engine/base/parallel/parallel.hpp"
#include "tests/oracle/cgal_overlay.hpp"
#include "tests/oracle/exact_overlay.hpp"
#include "tests/oracle/families.hpp"
#include "tests/oracle/pair_file.hpp"
#include "tests/oracle/trapezoid_area.hpp"

namespace lober::oracle {
using namespace lober::detail;
namespace {

std::uint64_t pairs_per_family() {
  const char* text = std::getenv("LOBER_AGREEMENT_PAIRS");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 1000;
}

void compare_areas(const CurvePair& pair, const ExactOverlay& exact, std::ostream& difference) {
  if (abs(trapezoid_area(pair.first)) != exact.area1 || abs(trapezoid_area(pair.second)) != exact.area2) {
    difference << "area of a curve\n";
  }
  if (trapezoid_intersection(pair.first, pair.second) != exact.areas[intersection]) {
    difference << "intersection by trapezoids\n";
  }
}

// By Euler's formula: with every node drawn together to a point, curves that meet are a connected graph in
// which all nodes have degree four, so it has two faces more than nodes. A wholly shared curve is the
// exception.
std::size_t expected_faces(const ExactOverlay& exact) {
  if (exact.nodes.empty()) return 3;
  return exact.same_curve ? 2 : exact.nodes.size() + 2;
}

// The same curves listed from another vertex, backwards, or in the other order.
void compare_with_itself(const CurvePair& pair, const ExactOverlay& exact, std::ostream& difference) {
  Polygon first = pair.first;
  Polygon second = pair.second;
  std::rotate(first.begin(), first.begin() + 1, first.end());
  std::reverse(second.begin(), second.end());
  const ExactOverlay other = exact_overlay(second, first);
  const bool same = other.crossings == exact.crossings && other.touches == exact.touches &&
                    other.shared_arcs == exact.shared_arcs && other.areas[c1_minus_c2] == exact.areas[c2_minus_c1] &&
                    other.pieces[union_].size() == exact.pieces[union_].size();
  if (!same) difference << "another answer for the same curves, exchanged\n";
}

// Equal areas may come in any order: compare as sorted lists of (area, holes).
void compare_with_cgal(const CurvePair& pair, const ExactOverlay& exact, std::ostream& difference) {
  const CgalOverlay cgal = cgal_overlay(pair.first, pair.second);
  if (cgal.faces != expected_faces(exact)) {
    difference << cgal.faces << " faces, " << exact.nodes.size() << " nodes\n";
  }
  for (std::size_t pairing = 0; pairing < 4; ++pairing) {
    if (cgal.areas[pairing] != exact.areas[pairing]) difference << "total of pairing " << pairing << "\n";
    std::vector<std::pair<Rational, unsigned>> ours;
    std::vector<std::pair<Rational, unsigned>> theirs;
    for (const ExactPiece& piece : exact.pieces[pairing]) ours.emplace_back(piece.area, piece.holes);
    for (const CgalPiece& piece : cgal.pieces[pairing]) theirs.emplace_back(piece.area, piece.holes);
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    if (ours != theirs) {
      difference << "pieces of pairing " << pairing << ": " << ours.size() << " and " << theirs.size() << "\n";
    }
  }
}

class OracleAgreement : public testing::TestWithParam<Family> {};

TEST_P(OracleAgreement, ThreeWaysGiveTheSame) {
  std::mutex mutex;
  std::size_t written = 0;
  for_each_block(pairs_per_family(), 1, [&](std::size_t seed, std::size_t) {
    const CurvePair pair = make_curve_pair(GetParam(), seed);
    std::ostringstream difference;
    try {
      const ExactOverlay exact = exact_overlay(pair.first, pair.second);
      compare_areas(pair, exact, difference);
      compare_with_cgal(pair, exact, difference);
      compare_with_itself(pair, exact, difference);
    } catch (const std::exception& error) {
      difference << error.what() << "\n";
    }
    if (difference.str().empty()) return;
    const std::lock_guard lock(mutex);
    if (++written > 5) return;  // one cause is enough to study
    ADD_FAILURE() << difference.str() << "written to " << write_pair(pair, difference.str());
  });
}

INSTANTIATE_TEST_SUITE_P(Families, OracleAgreement, testing::ValuesIn(families().begin(), families().end()),
                         [](const auto& member) { return std::string(member.param.name); });

}  // namespace
}  // namespace lober::oracle

// Every area within its stated bound of the exact one, and unmoved by what does not change it, for all families of
// random pairs under all transformations; and how loose the bounds are.
//
// LOBER_STABILITY_PAIRS  how many pairs, over all families, each under every transformation (default 800)
// LOBER_SEED             the first seed (default 0)
// LOBER_FAILURES         folder for pairs that fail, with the smallest pair that still does (see pair_file.hpp)
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "tests/environment.hpp"
#include "tests/oracle/exact_curve.hpp"
#include "tests/oracle/exact_overlay.hpp"
#include "tests/oracle/pair_file.hpp"
#include "tests/stress/coverage.hpp"
#include "tests/stress/transformations.hpp"
#include "tests/views.hpp"

namespace lober::stress {
using namespace lober::detail;
namespace {

using oracle::CurvePair;
using oracle::ExactOverlay;
using oracle::Rational;

struct NamedArea {
  const char* name;
  double Areas::*area;
};
constexpr std::array named_areas{
    NamedArea{"C1", &Areas::c1},
    NamedArea{"C2", &Areas::c2},
    NamedArea{"intersection", &Areas::intersection},
    NamedArea{"union", &Areas::union_},
    NamedArea{"C1 minus C2", &Areas::c1_minus_c2},
    NamedArea{"C2 minus C1", &Areas::c2_minus_c1},
    NamedArea{"symmetric difference", &Areas::symmetric_difference},
};
constexpr std::array area_of_pairing{&Areas::c1_minus_c2, &Areas::c2_minus_c1, &Areas::intersection, &Areas::union_};

std::array<Rational, 7> areas_of(const ExactOverlay& exact) {
  const auto& areas = exact.areas;
  return {exact.area1,
          exact.area2,
          areas[oracle::intersection],
          areas[oracle::union_],
          areas[oracle::c1_minus_c2],
          areas[oracle::c2_minus_c1],
          areas[oracle::c1_minus_c2] + areas[oracle::c2_minus_c1]};
}

// The exact results of a pair: areas and pieces only.
struct Truth {
  std::array<Rational, 7> areas;
  std::array<std::vector<Rational>, 4> pieces;  // largest first
};

Truth truth_of(const CurvePair& pair) {
  const ExactOverlay exact = oracle::exact_overlay(pair.first, pair.second);
  Truth truth{areas_of(exact), {}};
  for (std::size_t k = 0; k < 4; ++k) {
    for (const oracle::ExactPiece& piece : exact.pieces[k]) truth.pieces[k].push_back(piece.area);
  }
  return truth;
}

Truth scaled(Truth truth, int exponent) {
  for (Rational& area : truth.areas) area = oracle::scaled(area, exponent);
  for (auto& pieces : truth.pieces) {
    for (Rational& area : pieces) area = oracle::scaled(area, exponent);
  }
  return truth;
}

// The results of the engine, by both methods.
struct Answer {
  struct Method {
    const char* name;
    Areas areas, bounds;
  };
  std::array<Method, 2> methods;
  std::array<std::vector<double>, 4> pieces;  // largest first
};

Answer answer_to(const CurvePair& pair) {
  const CurveView c1{pair.first}, c2{pair.second};
  const Overlay found = overlay(c1, c2);
  const InteriorAreas interior = interior_areas(c1, c2);
  Answer answer{{{{"overlay", found.areas, found.rounding}, {"interior", interior.areas, interior.rounding}}}, {}};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto areas = found.pieces(all_pairings[k]).areas();
    answer.pieces[k].assign(areas.begin(), areas.end());
    std::sort(answer.pieces[k].rbegin(), answer.pieces[k].rend());
  }
  return answer;
}

using Coverages = std::array<Coverage, 2>;

// Each area and each piece within its bound of the truth. A piece is part of its pairing's area, whose bound is
// therefore one for it.
void compare(const Answer& answer, const Truth& truth, Coverages& coverages, std::ostream& complaints) {
  for (std::size_t m = 0; m < answer.methods.size(); ++m) {
    const auto& [method, areas, bounds] = answer.methods[m];
    for (std::size_t k = 0; k < named_areas.size(); ++k) {
      const auto& [name, area] = named_areas[k];
      if (coverages[m].add(areas.*area, bounds.*area, truth.areas[k])) continue;
      complaints << name << " by " << method << ": " << areas.*area << ", bound " << bounds.*area << ", exactly "
                 << truth.areas[k].get_d() << ", error " << Rational(Rational(areas.*area) - truth.areas[k]).get_d()
                 << "\n";
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const std::vector<double>& found = answer.pieces[k];
    const std::vector<Rational>& exact = truth.pieces[k];
    if (found.size() != exact.size()) {
      complaints << found.size() << " pieces of " << name(all_pairings[k]) << ", exactly " << exact.size() << "\n";
      continue;
    }
    const Rational bound(answer.methods[0].bounds.*area_of_pairing[k]);
    for (std::size_t piece = 0; piece < found.size(); ++piece) {
      const Rational error = abs(Rational(found[piece]) - exact[piece]);
      if (error > bound) {
        complaints << "piece " << piece << " of " << name(all_pairings[k]) << ": " << found[piece] << ", bound "
                   << bound.get_d() << ", exactly " << exact[piece].get_d() << ", error " << error.get_d() << "\n";
      }
    }
  }
}

// The answers to a pair before and after a transformation that multiplies areas by 2^exponent, with no oracle between.
void compare(const Answer& before, const Answer& after, int exponent, std::ostream& complaints) {
  const auto expect = [&](const std::string& what, double old, double old_bound, double now, double now_bound) {
    const Rational change = abs(Rational(now) - oracle::scaled(Rational(old), exponent));
    if (change > oracle::scaled(Rational(old_bound), exponent) + Rational(now_bound)) {
      complaints << what << " was " << old << " +- " << old_bound << ", is " << now << " +- " << now_bound
                 << ", factor 2^" << exponent << "\n";
    }
  };
  for (std::size_t m = 0; m < after.methods.size(); ++m) {
    const auto &old = before.methods[m], &now = after.methods[m];
    for (const auto& [name, area] : named_areas) {
      expect(std::string(name) + " by " + now.name, old.areas.*area, old.bounds.*area, now.areas.*area,
             now.bounds.*area);
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string what = "a piece of " + std::string(name(all_pairings[k]));
    if (before.pieces[k].size() != after.pieces[k].size()) {
      complaints << before.pieces[k].size() << " times " << what << ", then " << after.pieces[k].size() << "\n";
      continue;
    }
    for (std::size_t piece = 0; piece < after.pieces[k].size(); ++piece) {
      expect(what, before.pieces[k][piece], before.methods[0].bounds.*area_of_pairing[k], after.pieces[k][piece],
             after.methods[0].bounds.*area_of_pairing[k]);
    }
  }
}

// Sums over all pairs, by transformation; filled by many threads.
class Tally {
 public:
  struct Row {
    Coverages coverage;
    std::size_t cases = 0, exact = 0, not_simple = 0, refused = 0;
  };

  void try_all(const CurvePair& pair) {
    const Truth truth = truth_of(pair);
    const Answer answer = answer_to(pair);
    for (const Transformation& transformation : transformations()) {
      const Transformed there = transformed(pair, transformation);
      Row row;
      if (!there.exact && !(oracle::is_simple(there.pair.first) && oracle::is_simple(there.pair.second))) {
        row.not_simple = 1;
      } else {
        try_one(there, truth, answer, row);
      }
      add(transformation, row);
    }
  }

  // Prints the table and expects what holds for all cases.
  void finish() {
    std::size_t cases = 0, refused = 0;
    std::string text;
    for (auto& [number, row] : rows_) {
      const Transformation& transformation = transformations()[number];
      cases += row.cases;
      refused += row.refused;
      std::printf("%-18s %zu pairs, %zu of them with the same areas exactly; %zu not simple, %zu refused\n",
                  std::string(transformation.name).c_str(), row.cases, row.exact, row.not_simple, row.refused);
      for (std::size_t m = 0; m < 2; ++m) {
        Coverage& coverage = row.coverage[m];
        coverage.sort();
        text += coverage.row(std::string(transformation.name) + (m == 0 ? ", overlay" : ", interior"));
        EXPECT_EQ(coverage.inside(), coverage.areas()) << transformation.name;
        // Tight for areas that are not small: nearly nothing but the rounding to double.
        ASSERT_FALSE(coverage.size().empty()) << transformation.name;
        EXPECT_LT(quantile(coverage.size(), 0.5), 1.01) << transformation.name;
      }
    }
    std::printf("%zu cases\n%s%s", cases, Coverage::heading("transformation, method").c_str(), text.c_str());
    EXPECT_EQ(failed_, 0U) << "cases of " << cases;
    EXPECT_LE(refused * 100, cases);
  }

 private:
  void try_one(const Transformed& there, const Truth& truth, const Answer& answer, Row& row) {
    std::ostringstream complaints;
    complaints.precision(17);
    try {
      const Answer now = answer_to(there.pair);
      row.cases = 1;
      row.exact = there.exact ? 1 : 0;
      compare(now, there.exact ? scaled(truth, 2 * there.exponent) : truth_of(there.pair), row.coverage, complaints);
      if (there.exact) compare(answer, now, 2 * there.exponent, complaints);
    } catch (const DataError& error) {
      // Coordinates between the smallest doubles and 1e90 have no areas in double: 0 jittered in these families.
      row.refused = 1;
      const std::string& family = there.pair.family;
      if (!family.starts_with("extreme_scale") && !family.starts_with("powers_of_2_200")) {
        complaints << "refused: " << error.what() << "\n";
      }
    } catch (const std::exception& error) {
      complaints << "thrown: " << error.what() << "\n";
    }
    if (!complaints.str().empty()) report(there.pair, complaints.str());
  }

  void add(const Transformation& transformation, const Row& one) {
    const std::lock_guard lock(mutex_);
    Row& row = rows_[&transformation - transformations().data()];
    row.cases += one.cases;
    row.exact += one.exact;
    row.not_simple += one.not_simple;
    row.refused += one.refused;
    for (std::size_t m = 0; m < 2; ++m) row.coverage[m].add(one.coverage[m]);
  }

  static std::string complaints_about(const CurvePair& pair) {
    std::ostringstream complaints;
    complaints.precision(17);
    Coverages coverages;
    try {
      compare(answer_to(pair), truth_of(pair), coverages, complaints);
    } catch (const std::exception& error) {
      complaints << "thrown: " << error.what() << "\n";
    }
    return complaints.str();
  }

  // A handful is enough to study; the count goes on.
  void report(const CurvePair& pair, const std::string& complaints) {
    const std::lock_guard lock(mutex_);
    if (++failed_ > 5) return;
    ADD_FAILURE() << pair.family << ", seed " << pair.seed << "\n"
                  << complaints << "written to " << oracle::write_pair(pair, complaints);
    if (complaints_about(pair).empty()) return;  // wrong only beside the pair before
    const CurvePair smallest =
        oracle::minimised(pair, [](const CurvePair& smaller) { return !complaints_about(smaller).empty(); });
    ADD_FAILURE() << "smallest pair that fails\n" << oracle::as_source(smallest) << complaints_about(smallest);
  }

  std::mutex mutex_;
  std::map<std::ptrdiff_t, Row> rows_;
  std::size_t failed_ = 0;
};

TEST(Stability, AreasStayWithinTheirBounds) {
  const std::uint64_t seed = from_environment("LOBER_SEED", 0);
  const std::size_t count = from_environment("LOBER_STABILITY_PAIRS", 800);
  const auto families = oracle::families();
  Tally tally;
  for_each_block(count, 1, [&](std::size_t k, std::size_t) {
    tally.try_all(oracle::make_curve_pair(families[k % families.size()], seed + k / families.size()));
  });
  tally.finish();
}

}  // namespace
}  // namespace lober::stress

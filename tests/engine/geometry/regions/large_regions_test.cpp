// Regions of curves of many points: against the same curves with few points, against the overlay of simple curves, and
// against themselves with other numbers of threads and other indexes.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "engine/base/parallel/parallel.hpp"
#include "lober/overlay/regions.hpp"
#include "tests/oracle/crossing_polygons.hpp"
#include "tests/oracle/families.hpp"
#include "tests/views.hpp"

namespace lober::oracle {
using namespace lober::detail;
namespace {

std::vector<RegionPiece> sorted(const RegionPieces& pieces) {
  std::vector<RegionPiece> list;
  for (std::size_t k = 0; k < pieces.size(); ++k) list.push_back(pieces[k]);
  std::sort(list.begin(), list.end(), [](const RegionPiece& x, const RegionPiece& y) {
    return x.area != y.area ? x.area < y.area : x.holes < y.holes;
  });
  return list;
}

// Each segment cut into `parts` (a power of two), exactly: coordinates are small multiples of a power of two.
Polygon refined(const Polygon& polygon, int parts) {
  Polygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    for (int m = 0; m < parts; ++m) {
      result.push_back({a.x + (b.x - a.x) / parts * m, a.y + (b.y - a.y) / parts * m});
    }
  }
  return result;
}

TEST(LargeRegions, AreThoseOfTheCurvesBeforeTheyWereSubdivided) {
  std::mutex mutex;
  std::size_t wrong = 0, tried = 0;
  for (const CrossingFamily& family : crossing_families()) {
    const std::vector<std::string_view> on_lattices{"lattices", "spikes", "repeats", "walks"};
    if (std::find(on_lattices.begin(), on_lattices.end(), family.name) == on_lattices.end()) continue;
    for_each_block(60, 1, [&](std::size_t seed, std::size_t) {
      Random random(seed + 77);
      const PolygonPair pair = family.make(random);
      // Enough for leaves, and for some pairs blocks, of their own.
      const Polygon first = refined(pair.first, seed % 8 == 0 ? 1024 : 64), second = refined(pair.second, 32);
      const Regions coarse = regions(CurveView{pair.first}, CurveView{pair.second});
      const Regions fine = regions(CurveView{first}, CurveView{second});
      bool same = coarse.table().size() == fine.table().size() && coarse.counts().faces == fine.counts().faces;
      for (std::size_t k = 0; same && k < coarse.table().size(); ++k) {
        const WindingArea x = coarse.table()[k], y = fine.table()[k];
        same = x.w1 == y.w1 && x.w2 == y.w2 && std::fabs(x.area - y.area) <= 1e-15 * x.area;
      }
      for (const Pairing pairing : all_pairings) {
        const auto rule = all_fill_rules[seed % 4];
        const auto x = sorted(coarse.pieces(rule, pairing)), y = sorted(fine.pieces(rule, pairing));
        same = same && x.size() == y.size();
        for (std::size_t k = 0; same && k < x.size(); ++k) same = std::fabs(x[k].area - y[k].area) <= 1e-15 * x[k].area;
        const auto holes = [](const std::vector<RegionPiece>& list) {
          std::uint32_t sum = 0;
          for (const RegionPiece& piece : list) sum += piece.holes;
          return sum;
        };
        same = same && holes(x) == holes(y);
      }
      const std::lock_guard lock(mutex);
      ++tried;
      if (!same && ++wrong <= 3) ADD_FAILURE() << family.name << ", seed " << seed + 77;
    });
  }
  EXPECT_EQ(tried, 240U);
  EXPECT_EQ(wrong, 0U);
}

TEST(LargeRegions, OfSimpleCurvesAreThoseOfTheOverlay) {
  constexpr std::size_t pairs_per_family = 100;
  std::mutex mutex;
  std::size_t wrong = 0, tried = 0;
  for (const Family& family : families()) {
    for_each_block(pairs_per_family, 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t seed = begin; seed < end; ++seed) {
        const CurvePair pair = make_curve_pair(family, seed + 4000);
        const CurveView c1{pair.first}, c2{pair.second};
        const Overlay expected = overlay(c1, c2);
        const Regions found = regions(c1, c2);
        const Areas areas = found.areas(FillRule::nonzero), bounds = found.rounding(FillRule::nonzero);
        bool same = true;
        for (double Areas::*area : {&Areas::c1, &Areas::c2, &Areas::intersection, &Areas::union_, &Areas::c1_minus_c2,
                                    &Areas::c2_minus_c1, &Areas::symmetric_difference}) {
          same = same && std::fabs(areas.*area - expected.areas.*area) <= bounds.*area + expected.rounding.*area;
        }
        for (const Pairing pairing : all_pairings) {
          std::vector<RegionPiece> x;
          for (const Piece& piece : expected.pieces(pairing)) x.push_back({piece.area, piece.holes});
          std::sort(x.begin(), x.end(), [](const RegionPiece& p, const RegionPiece& q) { return p.area < q.area; });
          const std::vector<RegionPiece> y = sorted(found.pieces(FillRule::evenodd, pairing));
          same = same && x.size() == y.size();
          std::uint32_t holes_x = 0, holes_y = 0;
          for (std::size_t k = 0; same && k < x.size(); ++k) {
            same = std::fabs(x[k].area - y[k].area) <= 2 * found.rounding(x[k].area);
            holes_x += x[k].holes;
            holes_y += y[k].holes;
          }
          same = same && holes_x == holes_y;
        }
        const std::lock_guard lock(mutex);
        ++tried;
        if (!same && ++wrong <= 3) ADD_FAILURE() << family.name << ", seed " << seed + 4000;
      }
    });
  }
  EXPECT_EQ(tried, pairs_per_family * families().size());
  EXPECT_EQ(wrong, 0U);
}

// A rosette that crosses itself thousands of times.
Polygon rosette(std::size_t points, int turns, int waves, double amplitude, Point centre) {
  Polygon polygon;
  for (std::size_t k = 0; k < points; ++k) {
    const double t = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points);
    polygon.push_back({centre.x + std::cos(turns * t) + amplitude * std::cos(waves * t),
                       centre.y + std::sin(turns * t) + amplitude * std::sin(waves * t)});
  }
  return polygon;
}

TEST(LargeRegions, AreTheSameBitsForAnyNumberOfThreadsAndAnyIndex) {
  const tbb::global_control at_most(tbb::global_control::max_allowed_parallelism, 7);
  const Polygon first = rosette(40000, 13, 80, 0.4, {0, 0});
  Polygon second = rosette(30000, 7, 60, 0.5, {0.1, 0});
  std::copy(first.begin() + 1000, first.begin() + 9000, second.begin() + 1000);  // an arc in common
  struct Answer {
    std::vector<double> numbers;
    std::vector<Point> points;
    std::uint64_t nodes;
    bool operator==(const Answer&) const = default;
  };
  const auto answer = [&](IndexKind index) {
    RegionOptions options;
    options.index = index;
    const Regions result = regions(CurveView{first}, CurveView{second}, options);
    Answer all;
    all.nodes = result.counts().nodes;
    for (const WindingArea& entry : result.table()) all.numbers.push_back(entry.area);
    for (const FillRule rule : all_fill_rules) {
      for (const Pairing pairing : all_pairings) {
        const RegionPieces pieces = result.pieces(rule, pairing);
        all.numbers.insert(all.numbers.end(), pieces.areas().begin(), pieces.areas().end());
        for (std::size_t k = 0; k < std::min<std::size_t>(pieces.size(), 20); ++k) {
          for (const Polygon& polygon : pieces.outline(k)) {
            all.points.insert(all.points.end(), polygon.begin(), polygon.end());
          }
        }
      }
    }
    return all;
  };
  const Answer expected = with_threads(1, [&] { return answer(IndexKind::tree); });
  EXPECT_GT(expected.nodes, 11000U);
  EXPECT_GT(expected.numbers.size(), 1000U);
  for (const int threads : {2, 7}) {
    EXPECT_TRUE(with_threads(threads, [&] { return answer(IndexKind::tree); }) == expected) << threads << " threads";
  }
  for (const IndexKind index : {IndexKind::grid, IndexKind::kd, IndexKind::automatic}) {
    EXPECT_TRUE(answer(index) == expected) << name(index);
  }
}

TEST(LargeRegions, SignedAreaIsTheSumOfWindingTimesArea) {
  const Polygon first = rosette(100000, 17, 60, 0.6, {0, 0}), second = rosette(100000, -5, 33, 0.3, {0.2, 0});
  const Regions result = regions(CurveView{first}, CurveView{second});
  double sum1 = 0, sum2 = 0;
  for (const WindingArea& entry : result.table()) {
    sum1 += entry.w1 * entry.area;
    sum2 += entry.w2 * entry.area;
  }
  EXPECT_NEAR(sum1, signed_area(CurveView{first}), 1e-12);
  EXPECT_NEAR(sum2, signed_area(CurveView{second}), 1e-12);
  EXPECT_NEAR(result.signed_areas()[0], sum1, 1e-12);
  EXPECT_NEAR(result.signed_areas()[1], sum2, 1e-12);
}

}  // namespace
}  // namespace lober::oracle

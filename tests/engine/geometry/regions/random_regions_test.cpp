// Winding regions against the exact slabs on random pairs of every family.
//
// LOBER_RANDOM_REGIONS  how many pairs, over all families (default 12000)
// LOBER_SEED            the first seed (default 0)
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <sstream>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/box.hpp"
#include "lober/overlay/regions.hpp"
#include "tests/environment.hpp"
#include "tests/oracle/crossing_polygons.hpp"
#include "tests/oracle/slab_arrangement.hpp"
#include "tests/views.hpp"

namespace lober::oracle {
using namespace lober::detail;
namespace {

bool in_pairing(Pairing pairing, bool in1, bool in2) {
  switch (pairing) {
    case Pairing::c1_minus_c2:
      return in1 && !in2;
    case Pairing::c2_minus_c1:
      return !in1 && in2;
    case Pairing::intersection:
      return in1 && in2;
    case Pairing::union_:
      break;
  }
  return in1 || in2;
}

bool is_inside(FillRule rule, int winding) {
  switch (rule) {
    case FillRule::nonzero:
      return winding != 0;
    case FillRule::evenodd:
      return winding % 2 != 0;
    case FillRule::positive:
      return winding > 0;
    case FillRule::negative:
      break;
  }
  return winding < 0;
}

// Everything there is to complain of about one pair.
class Examination {
 public:
  Examination(const PolygonPair& pair, FillRule rule)
      : exact_(pair.first, pair.second), result_(regions(CurveView{pair.first}, CurveView{pair.second})), rule_(rule) {
    double low_x = INFINITY, low_y = INFINITY, high_x = -INFINITY, high_y = -INFINITY;
    for (const Polygon* polygon : {&pair.first, &pair.second}) {
      for (const Point& p : *polygon) {
        low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
        low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
      }
    }
    box_ = (high_x - low_x) * (high_y - low_y);
    compare_tables();
    for (const FillRule any : all_fill_rules) compare_totals(any);
    for (const Pairing pairing : all_pairings) compare_pieces(pairing);
  }

  [[nodiscard]] std::string complaints() const { return complaints_.str(); }
  [[nodiscard]] double relative_error() const { return relative_error_; }
  [[nodiscard]] double small_error() const { return small_error_; }
  [[nodiscard]] std::size_t pieces() const { return pieces_; }

 private:
  // Whether an area is right to 1e-15 of itself or 1e-27 of the box, and within its own bound.
  bool right(double area, const Rational& exact) {
    const Rational difference = abs(Rational(area) - exact);
    const double error = difference.get_d(), size = exact.get_d();
    if (area > 1e-12 * box_) {
      relative_error_ = std::max(relative_error_, error / size);
    } else {
      small_error_ = std::max(small_error_, error / box_);
    }
    return (error <= 1e-15 * size || error <= 1e-27 * box_) && error <= result_.rounding(area) * (1 + 1e-12);
  }

  void compare_tables() {
    for (const WindingArea& entry : result_.table()) {
      const auto found = exact_.areas().find({entry.w1, entry.w2});
      if (found == exact_.areas().end()) {
        complaints_ << "no area winds " << entry.w1 << ", " << entry.w2 << "\n";
      } else if (!right(entry.area, found->second)) {
        complaints_ << "area of winding " << entry.w1 << ", " << entry.w2 << " is " << entry.area << ", not "
                    << found->second.get_d() << "\n";
      }
    }
    if (result_.table().size() != exact_.areas().size()) {
      complaints_ << result_.table().size() << " pairs of winding numbers, not " << exact_.areas().size() << "\n";
    }
  }

  void compare_totals(FillRule rule) {
    const Areas areas = result_.areas(rule);
    const auto compare = [&](const char* what, double area, const auto& wanted) {
      Rational exact;
      for (const auto& [windings, part] : exact_.areas()) {
        if (wanted(is_inside(rule, windings.first), is_inside(rule, windings.second))) exact += part;
      }
      if (!right(area, exact)) {
        complaints_ << name(rule) << " " << what << " is " << area << ", not " << exact.get_d() << "\n";
      }
    };
    compare("c1", areas.c1, [](bool in1, bool) { return in1; });
    compare("c2", areas.c2, [](bool, bool in2) { return in2; });
    compare("symmetric difference", areas.symmetric_difference, [](bool in1, bool in2) { return in1 != in2; });
    for (const auto& [pairing, area] : {std::pair{Pairing::c1_minus_c2, areas.c1_minus_c2},
                                        {Pairing::c2_minus_c1, areas.c2_minus_c1},
                                        {Pairing::intersection, areas.intersection},
                                        {Pairing::union_, areas.union_}}) {
      compare("pairing", area, [pairing = pairing](bool in1, bool in2) { return in_pairing(pairing, in1, in2); });
    }
  }

  void compare_pieces(Pairing pairing) {
    std::vector<SlabPiece> exact =
        exact_.pieces([&](int w1, int w2) { return in_pairing(pairing, is_inside(rule_, w1), is_inside(rule_, w2)); });
    const RegionPieces found = result_.pieces(rule_, pairing);
    pieces_ += found.size();
    const auto complain = [&] { return std::ostringstream() << name(rule_) << " " << name(pairing) << ": "; };
    if (found.size() != exact.size()) {
      complaints_ << complain().str() << found.size() << " pieces, not " << exact.size() << "\n";
      return;
    }
    for (std::size_t k = 0; k < found.size(); ++k) {
      const RegionPiece piece = found[k];
      const auto nearest = std::min_element(exact.begin(), exact.end(), [&](const SlabPiece& x, const SlabPiece& y) {
        return distance(piece, x) < distance(piece, y);
      });
      if (nearest->holes != static_cast<int>(piece.holes) || !right_piece(piece.area, nearest->area)) {
        complaints_ << complain().str() << "no piece has area " << piece.area << " and " << piece.holes << " holes\n";
      }
      exact.erase(nearest);
      compare_outline(found, k);
    }
  }

  // How far two pieces are from being the same: by holes first.
  [[nodiscard]] static std::pair<bool, Rational> distance(const RegionPiece& piece, const SlabPiece& other) {
    return {other.holes != static_cast<int>(piece.holes), abs(Rational(piece.area) - other.area)};
  }

  [[nodiscard]] bool right_piece(double area, const Rational& exact) const {
    const Rational difference = abs(Rational(area) - exact);
    const double error = difference.get_d();
    return error <= 1e-15 * exact.get_d() || error <= 1e-27 * box_;
  }

  // Outlines have rounded vertices, so their areas are only nearly right.
  void compare_outline(const RegionPieces& found, std::size_t piece) {
    double sum = 0;
    bool first = true;
    for (const Polygon& polygon : found.outline(piece)) {
      const double area = signed_area(CurveView{polygon});
      if (std::fabs(area) > 1e-12 * box_ && (area > 0) != first) complaints_ << "an outline turns the wrong way\n";
      first = false;
      sum += area;
    }
    if (std::fabs(sum - found[piece].area) > 1e-13 * box_) {
      complaints_ << "an outline has area " << sum << ", not " << found[piece].area << "\n";
    }
  }

  SlabArrangement exact_;
  Regions result_;
  FillRule rule_;
  double box_ = 0;
  std::ostringstream complaints_;
  double relative_error_ = 0, small_error_ = 0;
  std::size_t pieces_ = 0;
};

std::string polygon_source(const Polygon& polygon) {
  std::ostringstream text;
  text << std::hexfloat << "{";
  for (const Point& p : polygon) text << "{" << p.x << ", " << p.y << "}, ";
  text << "}\n";
  return text.str();
}

class RandomRegions : public testing::TestWithParam<CrossingFamily> {};

TEST_P(RandomRegions, AgreeWithExactSlabs) {
  const std::uint64_t first = from_environment("LOBER_SEED", 0);
  const std::uint64_t wanted = from_environment("LOBER_RANDOM_REGIONS", 12000);
  const std::uint64_t count = (wanted + crossing_families().size() - 1) / crossing_families().size();
  std::mutex mutex;
  std::size_t failed = 0, pieces = 0;
  double relative_error = 0, small_error = 0;
  for_each_block(count, 8, [&](std::size_t begin, std::size_t end) {
    for (std::uint64_t seed = first + begin; seed < first + end; ++seed) {
      Random random(seed);
      const PolygonPair pair = GetParam().make(random);
      const Examination examination(pair, all_fill_rules[seed % all_fill_rules.size()]);
      const std::lock_guard lock(mutex);
      relative_error = std::max(relative_error, examination.relative_error());
      small_error = std::max(small_error, examination.small_error());
      pieces += examination.pieces();
      if (examination.complaints().empty()) continue;
      if (++failed > 3) continue;
      ADD_FAILURE() << GetParam().name << ", seed " << seed << "\n"
                    << examination.complaints() << polygon_source(pair.first) << polygon_source(pair.second);
    }
  });
  std::printf("%-14s %zu pairs, %zu wrong, %zu pieces; worst errors: area %.2e of itself, small area %.2e of the box\n",
              std::string(GetParam().name).c_str(), static_cast<std::size_t>(count), failed, pieces, relative_error,
              small_error);
  EXPECT_EQ(failed, 0U);
}

INSTANTIATE_TEST_SUITE_P(Families, RandomRegions,
                         testing::ValuesIn(crossing_families().begin(), crossing_families().end()),
                         [](const auto& family) { return std::string(family.param.name); });

}  // namespace
}  // namespace lober::oracle

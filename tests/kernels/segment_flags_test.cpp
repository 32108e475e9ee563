#include "kernels/segment_flags.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "kernels/cpu.hpp"
#include "kernels/graded.hpp"
#include "kernels/turning.hpp"

namespace lober::detail {
namespace {

constexpr InstructionSet sets[] = {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512};

struct Row {
  std::vector<Point> points;
  std::vector<double> parameters, lengths, bends, parts;
  [[nodiscard]] double gap(std::size_t k) const { return parameters[k + 1] - parameters[k]; }
};

// Numbers of every order, corners, points outside of the box and such without coordinates.
Row random_row(std::size_t count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Row row;
  for (std::size_t k = 0; k <= count; ++k) row.points.push_back({3 * unit(random) - 1, 3 * unit(random) - 1});
  row.points[random() % (count + 1)].x = std::numeric_limits<double>::quiet_NaN();
  row.points[random() % (count + 1)].y = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < count + 2; ++k) {
    row.lengths.push_back(random() % 9 == 0 ? 0 : std::exp(3 * unit(random) - 3));
  }
  row.parameters.push_back(unit(random));
  for (std::size_t k = 0; k < count + 2; ++k) row.parameters.push_back(row.parameters.back() + std::exp(unit(random)));
  for (std::size_t k = 0; k <= count; ++k) row.bends.push_back(random() % 4 == 0 ? -1 : 5 * unit(random));
  for (std::size_t k = 0; k < count; ++k) row.parts.push_back(6 * unit(random));
  return row;
}

TEST(SegmentFlags, AreThoseOfTheirDefinition) {
  const SegmentBounds bounds{Box::of({-0.5, -0.25}, {1.5, 1.75}), 0.1, 4, 0.97, 5, 0.7};
  std::mt19937_64 random(5);
  std::size_t seen[32] = {};
  for (const InstructionSet set : sets) {
    limit_instruction_set(set);
    for (const std::size_t count : {1U, 2U, 7U, 8U, 9U, 100U, 255U, 256U}) {
      const Row row = random_row(count, random);
      std::vector<std::int64_t> flags(count);
      const std::int64_t any = flag_segments({row.points.data(), &row.parameters[1], true, true, row.lengths.data(),
                                              row.bends.data(), row.parts.data(), count},
                                             bounds, flags.data());
      const auto inside = [&](std::size_t k) {
        const Point p = row.points[k];
        return p.x >= -0.5 && p.x <= 1.5 && p.y >= -0.25 && p.y <= 1.75;
      };
      const auto uneven = [&](std::size_t k) {
        const double a = row.lengths[k] / row.gap(k), b = row.lengths[k + 1] / row.gap(k + 1);
        const bool is_seen = std::max(row.lengths[k], row.lengths[k + 1]) >= 0.1;
        return row.bends[k] >= 0 && is_seen && std::max(a, b) > 4 * std::min(a, b);
      };
      std::int64_t all = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const double bend = std::max(row.bends[k], row.bends[k + 1]), turn = bend * row.lengths[k + 1];
        std::int64_t expected = 0;
        if (bend < 0) expected |= unknown_segment;
        if (uneven(k) || uneven(k + 1)) expected |= uneven_segment;
        if (!inside(k) || !inside(k + 1)) expected |= outside_segment;
        if (row.parts[k] > 0.97) expected |= coarse_segment;
        if (row.parts[k] > 5 || (turn > 0.7 && row.parts[k] > 1)) expected |= rough_segment;
        ASSERT_EQ(flags[k], expected) << count << ' ' << k;
        all |= expected;
        ++seen[expected];
      }
      EXPECT_EQ(any, all);
    }
  }
  for (const std::int64_t flag : {unknown_segment, uneven_segment, outside_segment, coarse_segment, rough_segment}) {
    std::size_t with = 0;
    for (std::int64_t k = 0; k < 32; ++k) with += (k & flag) != 0 ? seen[k] : std::size_t{0};
    EXPECT_GT(with, 50U) << flag;
  }
  limit_instruction_set(InstructionSet::avx512);
}

// A row with what turns_along and parts_needed make of it, as a curve's segments are judged; `before` and `behind` say
// whether there is a segment before the first and behind the last one.
std::int64_t judged(const std::vector<Point>& points, const std::vector<double>& parameters, bool before, bool behind,
                    const SegmentBounds& bounds, PartsAsked asked) {
  const std::size_t count = points.size() - 3;
  std::vector<double> lengths(count + 2), bends(count + 1, -1), parts(count);
  const std::size_t first = before ? 0 : 1;
  turns_along(&points[first], count + (before ? 1 : 0) + (behind ? 1 : 0), &lengths[first], &bends[first]);
  parts_needed(&lengths[1], bends.data(), count, asked, parts.data());
  std::vector<std::int64_t> flags(count);
  return flag_segments({&points[1], &parameters[1], before, behind, lengths.data(), bends.data(), parts.data(), count},
                       bounds, flags.data());
}

// Rows of smooth curves near what the tolerance lets pass, of any size, some of them with a fault.
TEST(SegmentFlags, NothingSurelyFineIsFlagged) {
  constexpr double tolerance = 1e-6, longest = 0.02;
  constexpr std::int64_t looked_for = outside_segment | uneven_segment | coarse_segment;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::size_t fine = 0, sure = 0, faulty = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const std::size_t count = 1 + random() % 40;
    const double size = trial % 3 != 0 ? 1 : std::exp(500 * (2 * unit(random) - 1));
    const double radius = 0.01 + unit(random), step = std::sqrt(8 * tolerance / radius) * (0.5 + 0.55 * unit(random));
    const double grading = 0.3 * unit(random);
    std::vector<Point> points;
    std::vector<double> parameters;
    double angle = 6 * unit(random), parameter = unit(random);
    for (std::size_t k = 0; k < count + 3; ++k) {
      points.push_back({size * radius * std::cos(angle), size * radius * std::sin(angle)});
      parameters.push_back(parameter);
      const double stretched = std::exp(grading * unit(random));
      angle += step * stretched;
      parameter += size * step * (random() % 400 == 0 ? 4.2 : 1) / stretched;
    }
    const std::size_t at = random() % points.size();
    switch (random() % 16) {
      case 0:
        points[at] = points[random() % points.size()];
        break;
      case 1:
        points[at].x += size * 1e-3 * (unit(random) - 0.5);
        break;
      case 2:
        points[at].y = std::numeric_limits<double>::quiet_NaN();
        break;
      case 3:
        points[at].x = std::numeric_limits<double>::infinity();
        break;
      default:
        break;
    }
    const double reach = 1.2 * size * (random() % 8 == 0 ? 0.5 : 1);
    const SegmentBounds bounds{Box::of({-reach, -reach}, {reach, reach}), 4 * tolerance * size, 4, 0.97, 5, 0.7};
    const double max_length = random() % 4 == 0 ? std::numeric_limits<double>::infinity() : longest * size;
    const PartsAsked asked{tolerance * size, max_length, 16};
    const bool before = random() % 8 != 0, behind = random() % 8 != 0;
    const PointRow row{&points[1], &parameters[1], before, behind, count};
    limit_instruction_set(InstructionSet::avx512);
    const bool is_fine = (judged(points, parameters, before, behind, bounds, asked) & looked_for) == 0;
    const bool is_sure = surely_fine(row, bounds, asked);
    ASSERT_TRUE(is_fine || !is_sure) << trial;
    for (const InstructionSet set : sets) {
      limit_instruction_set(set);
      ASSERT_EQ(surely_fine(row, bounds, asked), is_sure) << trial;
    }
    fine += is_fine ? 1 : 0;
    sure += is_sure ? 1 : 0;
    faulty += is_fine ? 0 : 1;
  }
  limit_instruction_set(InstructionSet::avx512);
  EXPECT_GT(fine, 5000U);
  EXPECT_GT(faulty, 5000U);
  EXPECT_GT(sure, fine / 2) << fine;
}

// A row of one fold that the flags call coarse, or uneven, by one part in a million, and just not.
TEST(SegmentFlags, SurelyFineEndsWhereTheFlagsBegin) {
  const auto is_sure = [](double height, double gap) {
    const std::vector<Point> points{{0, 0}, {1, 0}, {2, height}};
    const std::vector<double> parameters{0, 1, 1 + gap};
    const double curvature = 2 * std::tan(std::atan(height) / 2) / (0.5 * (1 + std::hypot(1, height)));
    const double tolerance = curvature / 8;  // one part, for a length of 1
    const SegmentBounds bounds{Box::of({-9, -9}, {9, 9}), 1e-9, 4, 1, 5, 0.7};
    return surely_fine({points.data(), parameters.data(), false, false, 2}, bounds, {tolerance * 1.000001, 9, 16});
  };
  for (const InstructionSet set : sets) {
    limit_instruction_set(set);
    EXPECT_TRUE(is_sure(1e-4, 1));
    EXPECT_FALSE(is_sure(0.5, 1));  // what it bends is bounded from above
    EXPECT_TRUE(is_sure(1e-4, 3.99999));
    EXPECT_FALSE(is_sure(1e-4, 4.00001));
    EXPECT_TRUE(is_sure(1e-4, 1 / 3.99999));
    EXPECT_FALSE(is_sure(1e-4, 1 / 4.00001));
  }
  limit_instruction_set(InstructionSet::avx512);
}

TEST(SegmentFlags, LengthInABox) {
  for (const InstructionSet set : sets) {
    limit_instruction_set(set);
    std::vector<Point> points(max_flagged + 1);
    for (std::size_t k = 0; k < points.size(); ++k)
      points[k] = {std::sin(static_cast<double>(k)), 1 / (1 + static_cast<double>(k))};
    const auto length = [&](std::size_t count, const Box& box) { return length_in_box(points.data(), count, box); };
    for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 250U, 256U}) {
      std::array<double, 8> sums{};
      for (std::size_t k = 0; k < count; ++k) sums[k % 8] += distance(points[k], points[k + 1]);
      const double sum = ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
      EXPECT_EQ(length(count, Box::of({-1, 0}, {1, 1})).sum, sum) << count;
      EXPECT_TRUE(length(count, Box::of({-1, 0}, {1, 1})).inside) << count;
    }
    points.back().y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(length(max_flagged, Box::of({-1, 0}, {1, 1})).inside);
    EXPECT_TRUE(length(max_flagged - 1, Box::of({-1, 0}, {1, 1})).inside);
    EXPECT_FALSE(length(20, Box::of({-1, 0}, {1, 0.5})).inside);
  }
  limit_instruction_set(InstructionSet::avx512);
}

// One point at a time, from the integral of a density that varies linearly, and with the operations of the kernel.
struct GradedPoint {
  double exact, place;
};
GradedPoint graded_point(const GradedRow& row, std::size_t k, double number) {
  const double gap = row.parameters[k + 1] - row.parameters[k], own = 2 * row.required[k] / (2 * gap);
  const auto at_end = [&](double around) { return around < 0 ? own : std::clamp(around, own / 4, own * 4); };
  const double a = at_end(row.around[k]), b = at_end(row.around[k + 1]);
  const double m = number - row.index[k], width = row.index[k + 1] - row.index[k], part = m / width;
  const double t = own > 0 ? part * (a + b) / (a + std::sqrt(a * a + (b - a) * (b + a) * part)) : part;
  const double begin = own > 0 ? a : 1, end = own > 0 ? b : 1, per_width = 1 / width;
  const double root = std::sqrt(begin * begin + (end - begin) * (end + begin) * per_width * m);
  return {row.parameters[k] + gap * t, row.parameters[k] + gap * (begin + end) * per_width * m / (begin + root)};
}

TEST(Graded, PointsHaveTheBitsOfOneByOne) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const InstructionSet set : sets) {
    limit_instruction_set(set);
    for (const std::size_t count : {1U, 3U, 256U}) {
      std::vector<double> parameters{1}, index{2.5}, required, around{-1};
      for (std::size_t k = 0; k < count; ++k) {
        parameters.push_back(parameters.back() + 0.1 + unit(random));
        required.push_back(k % 5 == 2 ? 0 : 9 * unit(random));
        index.push_back(k % 7 == 3 ? std::ceil(index.back() + 1) : index.back() + 12 * unit(random));
        around.push_back(k % 3 == 0 ? -1 : 8 * unit(random));
      }
      const GradedRow row{parameters.data(), index.data(), required.data(), around.data(), count};
      const auto end = static_cast<std::size_t>(std::ceil(index.back()));
      std::vector<double> places(end + 8, -7);
      place_graded(row, places.data());
      std::size_t k = 0;
      for (std::size_t n = 3; n < end; ++n) {
        while (!(static_cast<double>(n) < index[k + 1])) ++k;
        const GradedPoint point = graded_point(row, k, static_cast<double>(n));
        ASSERT_EQ(places[n], point.place) << count << ' ' << n;
        ASSERT_NEAR(places[n], point.exact, 4e-16 * point.exact) << count << ' ' << n;
        ASSERT_GE(places[n], places[n - (n > 3 ? 1 : 0)]);
      }
      for (std::size_t n = 0; n < places.size(); ++n) {
        if (n < 3 || n >= end) {
          ASSERT_EQ(places[n], -7) << n;
        }
      }
    }
  }
  limit_instruction_set(InstructionSet::avx512);
}

}  // namespace
}  // namespace lober::detail

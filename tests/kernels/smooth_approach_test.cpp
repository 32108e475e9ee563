#include "kernels/smooth_approach.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "kernels/cpu.hpp"

namespace lober::detail {
namespace {

using PairState = SmoothPair::State;

struct Pairs {
  std::vector<SmoothSegment> shapes1, shapes2;
  std::vector<SmoothPair> pairs;
  std::vector<std::uint32_t> numbers;
};

// Segments that cross at angles from a right one down to 1e-4, bend by up to 0.2, and meet anywhere.
Pairs random_pairs(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  Pairs made;
  for (std::uint32_t k = 0; k < count; ++k) {
    const double turn = uniform(0, 6), apart = std::pow(10, uniform(-4, 0)) * (random() % 2 == 0 ? 1 : -1);
    const double size = std::pow(10, uniform(-3, 3)), other = size * uniform(0.3, 3), bend = uniform(0, 0.2);
    const auto shape_of = [&](double length, double angle) {
      SmoothSegment shape;
      shape.chord = {length * std::cos(angle), length * std::sin(angle)};
      for (std::size_t m = 2; m < 6; ++m) shape.f[m] = bend * uniform(-1, 1) / static_cast<double>(m);
      shape.f[1] = -(shape.f[2] + shape.f[3] + shape.f[4] + shape.f[5]);
      shape.error = size * size * uniform(0, 1e-9);
      shape.kind = SmoothSegment::Kind::smooth;
      return shape;
    };
    made.shapes1.push_back(shape_of(size, turn));
    made.shapes2.push_back(shape_of(other, turn + apart));
    SmoothPair pair{};
    const double t1 = uniform(0, 1), t2 = uniform(0, 1);
    const Point chord1 = made.shapes1.back().chord, chord2 = made.shapes2.back().chord;
    pair.polygons = {t1 * chord1.x, t1 * chord1.y};
    pair.on1 = {t1, {0, 0}};
    pair.on2 = {t2, {pair.polygons.x - t2 * chord2.x, pair.polygons.y - t2 * chord2.y}};
    pair.shape1 = pair.shape2 = k;
    pair.steps_left = static_cast<std::int16_t>(random() % 8 == 0 ? 2 : SmoothPair::max_steps);
    pair.rightward_to_left = random() % 8 == 0 ? apart < 0 : apart > 0;
    pair.state = PairState::running;
    made.pairs.push_back(pair);
    if (random() % 16 != 0) made.numbers.push_back(k);
  }
  return made;
}

Point point_of(const SmoothPair::Runner& runner, const SmoothSegment& shape) {
  return runner.vertex + shape.at(runner.u);
}

// The iteration for one pair, in plain doubles.
void approach_one(SmoothPair& pair, const SmoothSegment& shape1, const SmoothSegment& shape2) {
  for (;;) {
    const Point along1 = shape1.velocity(pair.on1.u), along2 = shape2.velocity(pair.on2.u);
    const Point apart = point_of(pair.on2, shape2) - point_of(pair.on1, shape1);
    const double sine = cross(along1, along2);
    const double step1 = cross(apart, along2) / sine, step2 = cross(apart, along1) / sine;
    pair.on1.u += std::clamp(step1, -1.0, 1.0);
    pair.on2.u += std::clamp(step2, -1.0, 1.0);
    --pair.steps_left;
    pair.small = std::fabs(step1) < SmoothPair::small_step && std::fabs(step2) < SmoothPair::small_step;
    if (!(pair.rightward_to_left ? sine > 0 : sine < 0)) {
      pair.state = PairState::stays;
    } else if (SmoothPair::leaves(pair.on1.u) || SmoothPair::leaves(pair.on2.u)) {
      pair.state = PairState::outside;
    } else if (pair.small) {
      pair.state = PairState::met;
    } else if (pair.steps_left == 0) {
      pair.state = PairState::tired;
    } else {
      continue;
    }
    return;
  }
}

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

TEST(SmoothApproach, HasTheBitsOfOneByOne) {
  const InstructionSet before = instruction_set();
  std::array<std::size_t, 5> seen{};
  for (const InstructionSet set : {before, InstructionSet::avx2, InstructionSet::baseline}) {
    limit_instruction_set(set);
    for (unsigned seed = 0; seed < 40; ++seed) {
      Pairs many = random_pairs(seed % 10 == 0 ? seed / 10 : 300, seed);
      std::vector<SmoothPair> one_by_one = many.pairs;
      for (const std::uint32_t k : many.numbers) approach_one(one_by_one[k], many.shapes1[k], many.shapes2[k]);
      approach_crossings(many.pairs.data(), many.numbers.data(), many.numbers.size(), many.shapes1.data(),
                         many.shapes2.data());
      for (std::size_t k = 0; k < many.pairs.size(); ++k) {
        const SmoothPair &found = many.pairs[k], &wanted = one_by_one[k];
        ASSERT_EQ(found.state, wanted.state) << seed << ' ' << k;
        ++seen[static_cast<std::size_t>(found.state)];
        if (found.state == PairState::stays) continue;
        ASSERT_EQ(bits(found.on1.u), bits(wanted.on1.u)) << seed << ' ' << k;
        ASSERT_EQ(bits(found.on2.u), bits(wanted.on2.u)) << seed << ' ' << k;
        ASSERT_EQ(found.steps_left, wanted.steps_left) << seed << ' ' << k;
        ASSERT_EQ(found.small, wanted.small) << seed << ' ' << k;
      }
    }
  }
  limit_instruction_set(before);
  for (const std::size_t count : seen) EXPECT_GT(count, 100U);  // each state, and pairs that were not to move
}

TEST(SmoothApproach, MeetsWhereTheSegmentsCross) {
  Pairs many = random_pairs(2000, 99);
  approach_crossings(many.pairs.data(), many.numbers.data(), many.numbers.size(), many.shapes1.data(),
                     many.shapes2.data());
  std::size_t met = 0;
  for (const SmoothPair& pair : many.pairs) {
    if (pair.state != PairState::met) continue;
    ++met;
    const SmoothSegment &shape1 = many.shapes1[pair.shape1], &shape2 = many.shapes2[pair.shape2];
    const double size = std::max(length(shape1.chord), length(shape2.chord));
    EXPECT_LT(length(point_of(pair.on2, shape2) - point_of(pair.on1, shape1)), 1e-14 * size);
  }
  EXPECT_GT(met, 300U);
}

TEST(SmoothApproach, EndsAreTheLoopsToTheCrossing) {
  const InstructionSet before = instruction_set();
  Pairs many = random_pairs(203, 7);
  approach_crossings(many.pairs.data(), many.numbers.data(), many.numbers.size(), many.shapes1.data(),
                     many.shapes2.data());
  std::vector<EndOfArcs> first(many.pairs.size());
  std::size_t met = 0;
  for (const InstructionSet set : {before, InstructionSet::avx2, InstructionSet::baseline}) {
    limit_instruction_set(set);
    std::vector<EndOfArcs> ends(many.pairs.size());
    end_arcs(many.pairs.data(), many.pairs.size(), many.shapes1.data(), many.shapes2.data(), ends.data());
    if (set == before) first = ends;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      ASSERT_EQ(bits(ends[k].on1), bits(first[k].on1)) << k;
      ASSERT_EQ(bits(ends[k].on2), bits(first[k].on2)) << k;
      ASSERT_EQ(bits(ends[k].uncertainty), bits(first[k].uncertainty)) << k;
    }
  }
  limit_instruction_set(before);
  for (std::size_t k = 0; k < many.pairs.size(); ++k) {
    const SmoothPair& pair = many.pairs[k];
    const SmoothSegment &shape1 = many.shapes1[k], &shape2 = many.shapes2[k];
    met += pair.state == PairState::met;
    const Point at1 = point_of(pair.on1, shape1), at2 = point_of(pair.on2, shape2);
    const Point meeting = pair.state == PairState::met ? at1 : pair.polygons;
    // Triangles about where the polygons meet: to the vertex, along the curve, to the meeting point.
    const auto loop = [&](const SmoothPair::Runner& runner, const SmoothSegment& shape) {
      constexpr int steps = 4000;
      double sum = 0;
      Point previous = runner.vertex - pair.polygons;
      for (int j = 1; j <= steps; ++j) {
        const Point next = runner.vertex + shape.at(runner.u * j / steps) - pair.polygons;
        sum += cross(previous, next);
        previous = next;
      }
      return sum + cross(previous, meeting - pair.polygons);
    };
    const double longer = std::max(length(shape1.chord), length(shape2.chord)), square = longer * longer;
    EXPECT_NEAR(first[k].on1, loop(pair.on1, shape1), 1e-6 * square) << k;
    EXPECT_NEAR(first[k].on2, loop(pair.on2, shape2), 1e-6 * square) << k;
    EXPECT_NEAR(first[k].uncertainty, shape1.error + shape2.error + 2 * length(at2 - at1) * longer, 1e-14 * square);
  }
  EXPECT_GT(met, 30U);
}

}  // namespace
}  // namespace lober::detail

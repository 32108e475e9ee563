// Bodies of approach_crossings and end_arcs (kernels/all.inl).
#pragma once

#include "kernels/smooth_approach.hpp"
#include "kernels/values.inl"

namespace lober::detail {
namespace {

// Segments with a runner on each.
struct RunnerLanes {
  Values u, vertex_x, vertex_y, chord_x, chord_y, f[5];
  Values x, y, along_x, along_y;  // at the parameters

  // In the lane of the mask.
  LOBER_INLINE void enter(ValueMask lane, const SmoothPair::Runner& runner, const SmoothSegment& shape) {
    u = select(lane, all_of(runner.u), u);
    vertex_x = select(lane, all_of(runner.vertex.x), vertex_x);
    vertex_y = select(lane, all_of(runner.vertex.y), vertex_y);
    chord_x = select(lane, all_of(shape.chord.x), chord_x);
    chord_y = select(lane, all_of(shape.chord.y), chord_y);
    double coefficients[6];
    __builtin_memcpy(coefficients, &shape.f, sizeof coefficients);
#pragma GCC unroll 5
    for (std::size_t k = 0; k < 5; ++k) f[k] = select(lane, all_of(coefficients[k + 1]), f[k]);
  }
  LOBER_INLINE void enter_all(Values at, Values from_x, Values from_y, const double* const* shapes) {
    static_assert(offsetof(SmoothSegment, f) == 2 * sizeof(double), "a shape begins with its chord and coefficients");
    Values columns[8];
    load_rows(shapes, columns);
    u = at, vertex_x = from_x, vertex_y = from_y, chord_x = columns[0], chord_y = columns[1];
#pragma GCC unroll 5
    for (std::size_t k = 0; k < 5; ++k) f[k] = columns[3 + k];
  }
  LOBER_INLINE void find_point() {
    const Values height = u * (f[0] + u * (f[1] + u * (f[2] + u * (f[3] + u * f[4]))));
    x = vertex_x + (u * chord_x - height * chord_y);
    y = vertex_y + (u * chord_y + height * chord_x);
  }
  LOBER_INLINE void find_velocity() {
    const Values slope =
        f[0] + u * (all_of(2) * f[1] + u * (all_of(3) * f[2] + u * (all_of(4) * f[3] + u * all_of(5) * f[4])));
    along_x = chord_x - slope * chord_y;
    along_y = chord_y + slope * chord_x;
  }
  LOBER_INLINE ValueMask move(Values step) {
    u += greater(all_of(-1), step > all_of(1) ? all_of(1) : step);
    return (u < all_of(-SmoothPair::slack)) | (u > all_of(1 + SmoothPair::slack));
  }
  [[nodiscard]] LOBER_INLINE Values chord_square() const {
    return chord_x * chord_x + chord_y * chord_y;
  }
  // Twice the area of the loop from `from` to the vertex, along the smooth curve to the point, straight to `to` and
  // back, if `from` is on the segment.
  [[nodiscard]] LOBER_INLINE Values loop(Values from_x, Values from_y, Values to_x, Values to_y) const {
    const Values curve =
        u * u * u *
        (f[1] * all_of(1.0 / 3) + u * (f[2] * all_of(0.5) + u * (f[3] * all_of(0.6) + u * f[4] * all_of(2.0 / 3))));
    const Values ax = vertex_x - from_x, ay = vertex_y - from_y, bx = x - from_x, by = y - from_y;
    return chord_square() * curve + (ax * by - ay * bx) + (bx * (to_y - from_y) - by * (to_x - from_x));
  }
};

// A lane takes the next pair as soon as its own has stopped.
inline void approach_all(SmoothPair* pairs, const std::uint32_t* numbers, std::size_t count,
                         const SmoothSegment* shapes1, const SmoothSegment* shapes2) {
  using State = SmoothPair::State;
  RunnerLanes one{}, two{};
  Values sense{}, steps{};
  SmoothPair* own[value_lanes];
  std::size_t next = 0;
  unsigned running = 0;
  const auto start_next = [&](std::size_t lane) __attribute__((always_inline)) {
    if (next == count) {
      running &= ~(1U << lane);
      return;
    }
    SmoothPair& pair = pairs[numbers[next++]];
    const ValueMask mask = mask_of(1U << lane);
    one.enter(mask, pair.on1, shapes1[pair.shape1]);
    two.enter(mask, pair.on2, shapes2[pair.shape2]);
    sense = select(mask, all_of(pair.rightward_to_left ? 1 : -1), sense);
    steps = select(mask, all_of(pair.steps_left), steps);
    own[lane] = &pair;
    running |= 1U << lane;
  };
  for (std::size_t lane = 0; lane < value_lanes; ++lane) start_next(lane);
  while (running != 0) {
    one.find_point();
    two.find_point();
    one.find_velocity();
    two.find_velocity();
    const Values apart_x = two.x - one.x, apart_y = two.y - one.y;
    const Values sine = one.along_x * two.along_y - one.along_y * two.along_x;
    const Values step1 = (apart_x * two.along_y - apart_y * two.along_x) / sine;
    const Values step2 = (apart_x * one.along_y - apart_y * one.along_x) / sine;
    const Values small_step = all_of(SmoothPair::small_step);
    const ValueMask away = ~(sine * sense > all_of(0));
    const ValueMask outside = one.move(step1) | two.move(step2);
    const ValueMask small = (magnitude_of(step1) < small_step) & (magnitude_of(step2) < small_step);
    steps -= all_of(1);
    unsigned stopped = bits_of(away | outside | small | (steps <= all_of(0))) & running;
    if (stopped == 0) continue;
    const unsigned all_away = bits_of(away), all_outside = bits_of(outside), all_small = bits_of(small);
    alignas(64) double u1[value_lanes], u2[value_lanes], left[value_lanes];
    store_values(u1, one.u);
    store_values(u2, two.u);
    store_values(left, steps);
    for (; stopped != 0; stopped &= stopped - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(stopped));
      const auto has = [&](unsigned bits) __attribute__((always_inline)) {
        return (bits >> lane & 1U) != 0;
      };
      SmoothPair& pair = *own[lane];
      pair.on1.u = u1[lane];
      pair.on2.u = u2[lane];
      pair.steps_left = static_cast<std::int16_t>(left[lane]);
      pair.small = has(all_small);
      pair.state = has(all_away)      ? State::stays
                   : has(all_outside) ? State::outside
                   : pair.small       ? State::met
                                      : State::tired;
      start_next(lane);
    }
  }
}

inline void end_all_arcs(const SmoothPair* pairs, std::size_t count, const SmoothSegment* shapes1,
                         const SmoothSegment* shapes2, EndOfArcs* ends) {
  for (std::size_t begin = 0; begin < count; begin += value_lanes) {
    const std::size_t together = count - begin < value_lanes ? count - begin : value_lanes;
    const double *rows[value_lanes], *first[value_lanes], *second[value_lanes];
    Values errors{};
    unsigned met = 0;
    for (std::size_t k = 0; k < value_lanes; ++k) {
      const SmoothPair& pair = pairs[begin + (k < together ? k : together - 1)];
      const SmoothSegment &shape1 = shapes1[pair.shape1], &shape2 = shapes2[pair.shape2];
      rows[k] = &pair.on1.u;
      first[k] = &shape1.chord.x;
      second[k] = &shape2.chord.x;
      errors[k] = shape1.error + shape2.error;
      met |= static_cast<unsigned>(pair.state == SmoothPair::State::met) << k;
    }
    static_assert(offsetof(SmoothPair, polygons) == 6 * sizeof(double), "a pair begins with eight numbers");
    Values columns[8];
    load_rows(rows, columns);
    RunnerLanes one{}, two{};
    one.enter_all(columns[0], columns[1], columns[2], first);
    two.enter_all(columns[3], columns[4], columns[5], second);
    one.find_point();
    two.find_point();
    const Values from_x = columns[6], from_y = columns[7];
    const ValueMask at_crossing = mask_of(met);
    const Values to_x = select(at_crossing, one.x, from_x), to_y = select(at_crossing, one.y, from_y);
    const Values on1 = one.loop(from_x, from_y, to_x, to_y), on2 = two.loop(from_x, from_y, to_x, to_y);
    const Values apart_x = two.x - one.x, apart_y = two.y - one.y;
    const Values apart = root_of(apart_x * apart_x + apart_y * apart_y);
    const Values longer = greater(root_of(one.chord_square()), root_of(two.chord_square()));
    const Values uncertainty = errors + all_of(2) * apart * longer;
    for (std::size_t k = 0; k < together; ++k) ends[begin + k] = {on1[k], on2[k], uncertainty[k]};
  }
}

}  // namespace
}  // namespace lober::detail

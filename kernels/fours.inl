// Rows of four numbers or four pairs turned into columns, as many rows as there is room for in a column.
#pragma once

#include "kernels/eight.hpp"

namespace lober::detail {
namespace {

// Rows of four pairs (x, y), one behind the other: x[i] and y[i] hold pair i of each row.
inline void load_fours(const double* rows, Widest (&x)[4], Widest (&y)[4]) {
#ifdef __AVX512F__
  const auto turn = [&](auto half, Eight(&to)[4]) {
    Eight two[4];  // two rows each, in turns
    for (std::size_t k = 0; k < 4; ++k) two[k] = half(load_widest(rows + 16 * k), load_widest(rows + 16 * k + 8));
    const Eight a = __builtin_shufflevector(two[0], two[1], 0, 1, 4, 5, 8, 9, 12, 13),
                b = __builtin_shufflevector(two[0], two[1], 2, 3, 6, 7, 10, 11, 14, 15),
                c = __builtin_shufflevector(two[2], two[3], 0, 1, 4, 5, 8, 9, 12, 13),
                d = __builtin_shufflevector(two[2], two[3], 2, 3, 6, 7, 10, 11, 14, 15);
    to[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5, 8, 9, 12, 13);
    to[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5, 8, 9, 12, 13);
    to[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7, 10, 11, 14, 15);
    to[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7, 10, 11, 14, 15);
  };
  turn([](Eight p, Eight q) { return __builtin_shufflevector(p, q, 0, 8, 2, 10, 4, 12, 6, 14); }, x);
  turn([](Eight p, Eight q) { return __builtin_shufflevector(p, q, 1, 9, 3, 11, 5, 13, 7, 15); }, y);
#else
  for (std::size_t i = 0; i < 4; i += 2) {
    Lanes row[lanes];
    for (std::size_t k = 0; k < lanes; ++k) row[k] = load(rows + 8 * k + 2 * i);
    transpose(row);
    x[i] = row[0];
    y[i] = row[1];
    x[i + 1] = row[2];
    y[i + 1] = row[3];
  }
#endif
}

// Rows of four numbers at rows[0], rows[1] ...: to[i] holds number i of each.
inline void load_fours(const double* const* rows, Widest (&to)[4]) {
#ifdef __AVX512F__
  Eight two[4];  // rows k and k + 4
  for (std::size_t k = 0; k < 4; ++k) two[k] = side_by_side(load(rows[k]), load(rows[k + 4]));
  const Eight a = __builtin_shufflevector(two[0], two[1], 0, 8, 2, 10, 4, 12, 6, 14),
              b = __builtin_shufflevector(two[0], two[1], 1, 9, 3, 11, 5, 13, 7, 15),
              c = __builtin_shufflevector(two[2], two[3], 0, 8, 2, 10, 4, 12, 6, 14),
              d = __builtin_shufflevector(two[2], two[3], 1, 9, 3, 11, 5, 13, 7, 15);
  to[0] = __builtin_shufflevector(a, c, 0, 1, 8, 9, 4, 5, 12, 13);
  to[1] = __builtin_shufflevector(b, d, 0, 1, 8, 9, 4, 5, 12, 13);
  to[2] = __builtin_shufflevector(a, c, 2, 3, 10, 11, 6, 7, 14, 15);
  to[3] = __builtin_shufflevector(b, d, 2, 3, 10, 11, 6, 7, 14, 15);
#else
  for (std::size_t k = 0; k < lanes; ++k) to[k] = load(rows[k]);
  transpose(to);
#endif
}

// Writes them as rows, one behind the other.
inline void store_fours(const Widest (&from)[4], double* rows) {
  const auto put = [](Lanes a, Lanes b, Lanes c, Lanes d, double* to) {
    Lanes row[lanes] = {a, b, c, d};
    transpose(row);
    for (std::size_t k = 0; k < lanes; ++k) store(to + lanes * k, row[k]);
  };
#ifdef __AVX512F__
  put(low_half(from[0]), low_half(from[1]), low_half(from[2]), low_half(from[3]), rows);
  put(high_half(from[0]), high_half(from[1]), high_half(from[2]), high_half(from[3]), rows + 16);
#else
  put(from[0], from[1], from[2], from[3], rows);
#endif
}

}  // namespace
}  // namespace lober::detail

// Numbers that are Taylor series: what automatic differentiation of a field computes with.
//
// A field is written once for any kind of number, as a fixed sequence of operations. The velocity is called once for
// each order with numbers that are rows of one sheet: each operation adds the next coefficient to its row, from earlier
// coefficients of its operands and of itself. The sequence is the tape; as all of it is inlined, the compiler knows
// which rows an operation reads, and nothing is looked up while it runs.
#pragma once

#include <cstddef>

#include "kernels/inline.hpp"
#include "kernels/wide.hpp"

namespace lober::bench {

/// Enough for the operations of all fields that are compared.
inline constexpr int series_rows = 48;

template <int order, typename V>
struct SeriesSheet {
  V at[series_rows][order + 1];
  V inverse[series_rows];  ///< of rows that are divided by: 1 / leading coefficient, or what the operation needs
};

/// A row of the sheet, of which coefficient n is computed. As n is known to the compiler, there are no loops left.
template <int order, typename V, int n>
struct Series {
  static constexpr bool first = n == 0;

  struct Replay {
    SeriesSheet<order, V>* sheet;
    int next;  ///< the row of the next operation

    LOBER_INLINE Series result(V value) {
      sheet->at[next][n] = value;
      return {this, next++};
    }
  };
  Replay* replay;
  int row;

  [[nodiscard]] LOBER_INLINE const V* c() const { return replay->sheet->at[row]; }
  [[nodiscard]] LOBER_INLINE V last() const { return c()[n]; }

  LOBER_INLINE friend Series operator+(Series a, Series b) { return a.replay->result(a.last() + b.last()); }
  LOBER_INLINE friend Series operator-(Series a, Series b) { return a.replay->result(a.last() - b.last()); }
  LOBER_INLINE friend Series operator-(Series a) { return a.replay->result(-a.last()); }
  LOBER_INLINE friend Series operator*(double a, Series b) { return b.replay->result(a * b.last()); }
  LOBER_INLINE friend Series operator*(Series a, double b) { return b * a; }
  // All coefficients of a constant but the first are 0.
  LOBER_INLINE friend Series operator+(Series a, double b) { return a.replay->result(first ? a.last() + b : a.last()); }
  LOBER_INLINE friend Series operator+(double a, Series b) { return b + a; }
  LOBER_INLINE friend Series operator-(Series a, double b) { return a + -b; }
  LOBER_INLINE friend Series operator-(double a, Series b) {
    return b.replay->result(first ? a - b.last() : -b.last());
  }

  LOBER_INLINE friend Series operator*(Series a, Series b) {
    const V* const p = a.c();
    const V* const q = b.c();
    if (a.row == b.row) return a.replay->result(square_terms<0>(p));
    return a.replay->result(product_terms<0>(p, q));
  }
  /// r = a / b: b_0 r_n = a_n - sum b_k r_{n-k}.
  LOBER_INLINE friend Series operator/(double a, Series b) {
    const V* const q = b.c();
    SeriesSheet<order, V>& sheet = *b.replay->sheet;
    const int row = b.replay->next;
    if constexpr (first) {
      sheet.inverse[row] = -1.0 / q[0];
      return b.replay->result(-a * sheet.inverse[row]);
    } else {
      return b.replay->result(sheet.inverse[row] * product_terms<1>(q, sheet.at[row]));
    }
  }
  /// r = sqrt(a): 2 r_0 r_n = a_n - sum r_k r_{n-k}, without the terms that hold r_n.
  LOBER_INLINE friend Series square_root(Series a) {
    SeriesSheet<order, V>& sheet = *a.replay->sheet;
    const int row = a.replay->next;
    if constexpr (first) {
      const V root = square_root(a.c()[0]);
      sheet.inverse[row] = 0.5 / root;
      return a.replay->result(root);
    } else {
      const V rest = a.last() - square_terms<1>(sheet.at[row]);
      return a.replay->result(sheet.inverse[row] * rest);
    }
  }

 private:
  // Bounds of the loops are constants: the compiler writes them out.

  /// The sum of p_k q_{n-k} for k = from ... n, in two parts so that no addition waits for the last one.
  template <int from>
  LOBER_INLINE static V product_terms(const V* p, const V* q) {
    V parts[2] = {p[from] * q[n - from], V(0.0)};
#pragma GCC unroll 32
    for (int k = from + 1; k <= n; ++k) parts[(k - from) % 2] += p[k] * q[n - k];
    return parts[0] + parts[1];
  }
  /// The sum of p_k p_{n-k} for k = from ... n - from, of which k and n - k give the same.
  template <int from>
  LOBER_INLINE static V square_terms(const V* p) {
    V parts[2] = {V(0.0), V(0.0)};
#pragma GCC unroll 32
    for (int k = from; k < (n + 1) / 2; ++k) parts[k % 2] += p[k] * p[n - k];
    V sum = parts[0] + parts[1];
    sum += sum;
    if constexpr (n % 2 == 0 && n / 2 >= from) sum += p[n / 2] * p[n / 2];
    return sum;
  }
};

}  // namespace lober::bench

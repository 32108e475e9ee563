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

/// A row of the sheet, of which coefficient n is computed. `first`: whether n is 0.
template <int order, typename V, bool first>
struct Series {
  struct Replay {
    SeriesSheet<order, V>* sheet;
    int n;
    int next;  ///< the row of the next operation

    LOBER_INLINE Series result(V value) {
      sheet->at[next][n] = value;
      return {this, next++};
    }
  };
  Replay* replay;
  int row;

  [[nodiscard]] LOBER_INLINE int n() const { return first ? 0 : replay->n; }
  [[nodiscard]] LOBER_INLINE const V* c() const { return replay->sheet->at[row]; }
  [[nodiscard]] LOBER_INLINE V last() const { return c()[n()]; }

  LOBER_INLINE friend Series operator+(Series a, Series b) { return a.replay->result(a.last() + b.last()); }
  LOBER_INLINE friend Series operator-(Series a, Series b) { return a.replay->result(a.last() - b.last()); }
  LOBER_INLINE friend Series operator-(Series a) { return a.replay->result(-a.last()); }
  LOBER_INLINE friend Series operator*(double a, Series b) { return b.replay->result(a * b.last()); }
  LOBER_INLINE friend Series operator*(Series a, double b) { return b * a; }
  // Of a constant all coefficients but the first are 0.
  LOBER_INLINE friend Series operator+(Series a, double b) { return a.replay->result(first ? a.last() + b : a.last()); }
  LOBER_INLINE friend Series operator+(double a, Series b) { return b + a; }
  LOBER_INLINE friend Series operator-(Series a, double b) { return a + -b; }
  LOBER_INLINE friend Series operator-(double a, Series b) {
    return b.replay->result(first ? a - b.last() : -b.last());
  }

  LOBER_INLINE friend Series operator*(Series a, Series b) {
    const V* const p = a.c();
    const V* const q = b.c();
    if (a.row == b.row) return a.replay->result(square_term(p, 0, a.n()));
    return a.replay->result(product_terms(p, q, 0, a.n()));
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
      return b.replay->result(sheet.inverse[row] * product_terms(q, sheet.at[row], 1, b.n()));
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
      const V rest = a.last() - square_term(sheet.at[row], 1, a.n());
      return a.replay->result(sheet.inverse[row] * rest);
    }
  }

 private:
  /// The sum of p_k q_{n-k} for k = from ... n, in two parts so that no addition waits for the last one.
  LOBER_INLINE static V product_terms(const V* p, const V* q, int from, int n) {
    V even = p[from] * q[n - from], odd(0.0);
    int k = from + 1;
    for (; k < n; k += 2) {
      odd += p[k] * q[n - k];
      even += p[k + 1] * q[n - k - 1];
    }
    if (k == n) odd += p[k] * q[n - k];
    return even + odd;
  }
  /// The sum of p_k p_{n-k} for k = from ... n - from.
  LOBER_INLINE static V square_term(const V* p, int from, int n) {
    if constexpr (first) return p[0] * p[0];
    V even(0.0), odd(0.0);
    const int pairs = (n + 1) / 2;  // k and n - k give the same
    int k = from;
    for (; k + 1 < pairs; k += 2) {
      even += p[k] * p[n - k];
      odd += p[k + 1] * p[n - k - 1];
    }
    if (k < pairs) even += p[k] * p[n - k];
    const V twice = 2.0 * (even + odd);
    return n % 2 == 0 && n / 2 >= from ? twice + p[n / 2] * p[n / 2] : twice;
  }
};

}  // namespace lober::bench

// Sines of many angles at a time.
#pragma once

#include <cstddef>

namespace lober::detail {

/// y[k] += factor * sin(x[k]). The sine is right to 2.5 ulp for |x| < 1e8 (beyond, to a few ulps of x), without a
/// branch, so that four run side by side; the same bits wherever an angle comes. Cody & Waite reduction by multiples of
/// pi in three parts, then a minimax polynomial of degree 17 (relative error 3.4e-19 times x^2).
void add_sines(double* y, const double* x, double factor, std::size_t count);

}  // namespace lober::detail

// Systems of equations and eigenvalues of a few dozen unknowns, by Eigen, which only linear_algebra.cpp includes.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

#include "lober/dynamics/flow.hpp"

namespace lober::detail {

/// A matrix, row by row.
class Matrix {
 public:
  Matrix(std::size_t rows, std::size_t columns) : columns_(columns), entries_(rows * columns) {}
  [[nodiscard]] std::size_t rows() const { return entries_.size() / columns_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] double& operator()(std::size_t row, std::size_t column) { return entries_[row * columns_ + column]; }
  [[nodiscard]] const double* data() const { return entries_.data(); }

 private:
  std::size_t columns_;
  std::vector<double> entries_;
};

/// A matrix factored once for many right-hand sides, by Householder's QR.
class LeastSquares {
 public:
  explicit LeastSquares(const Matrix& matrix);
  ~LeastSquares();
  LeastSquares(const LeastSquares&) = delete;
  LeastSquares& operator=(const LeastSquares&) = delete;
  /// x with the least |matrix x - right|; the solution when the matrix is square and regular.
  [[nodiscard]] std::vector<double> solve(const std::vector<double>& right) const;

 private:
  struct Factors;
  std::unique_ptr<const Factors> factors_;
};

/// x with the least |matrix x - right|, by Householder's QR; the solution when the matrix is square and regular.
[[nodiscard]] std::vector<double> least_squares(const Matrix& matrix, const std::vector<double>& right);

struct EigenPair {
  std::complex<double> value;
  std::vector<std::complex<double>> vector;
};
/// The eigenpairs of a square matrix, in no particular order.
[[nodiscard]] std::vector<EigenPair> eigen_pairs(const Matrix& matrix);

}  // namespace lober::detail

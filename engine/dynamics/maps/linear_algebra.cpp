#include "engine/dynamics/maps/linear_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace lober::detail {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::MatrixXd converted(const Matrix& matrix) {
  return Eigen::Map<const RowMajor>(matrix.data(), static_cast<Eigen::Index>(matrix.rows()),
                                    static_cast<Eigen::Index>(matrix.columns()));
}

}  // namespace

struct LeastSquares::Factors {
  Eigen::HouseholderQR<Eigen::MatrixXd> qr;
};

LeastSquares::LeastSquares(const Matrix& matrix)
    : factors_(std::make_unique<const Factors>(Factors{converted(matrix).householderQr()})) {}

LeastSquares::~LeastSquares() = default;

std::vector<double> LeastSquares::solve(const std::vector<double>& right) const {
  const Eigen::Map<const Eigen::VectorXd> b(right.data(), static_cast<Eigen::Index>(right.size()));
  const Eigen::VectorXd x = factors_->qr.solve(b);
  return {x.data(), x.data() + x.size()};
}

std::vector<double> least_squares(const Matrix& matrix, const std::vector<double>& right) {
  return LeastSquares(matrix).solve(right);
}

std::vector<EigenPair> eigen_pairs(const Matrix& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(converted(matrix));
  std::vector<EigenPair> pairs;
  for (Eigen::Index k = 0; k < solver.eigenvalues().size(); ++k) {
    const Eigen::VectorXcd vector = solver.eigenvectors().col(k);
    pairs.push_back({solver.eigenvalues()(k), {vector.data(), vector.data() + vector.size()}});
  }
  return pairs;
}

}  // namespace lober::detail

#pragma once
// Factorises symmetric positive definite matrices that are small or dense, with Eigen.

#include <Eigen/Cholesky>

#include "tuner/quadratic/cholesky.hpp"

namespace armtune::internal {

class DenseCholesky final : public Cholesky {
 public:
  bool factorize(const SymmetricMatrix& matrix) override;
  void solve(Eigen::VectorXd& x) override;

 private:
  Eigen::MatrixXd whole_;  ///< only its upper triangle is used
  Eigen::LLT<Eigen::MatrixXd, Eigen::Upper> llt_;
};

/// Makes a DenseCholesky, for InteriorPoint.
std::unique_ptr<Cholesky> make_dense_cholesky(const SymmetricMatrix& pattern);

}  // namespace armtune::internal

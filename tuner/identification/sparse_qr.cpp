#include "tuner/identification/sparse_qr.hpp"

#include <SuiteSparseQR.hpp>
#include <stdexcept>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

/// Holds SPQR's workspace and its results until the end of a factorisation.
class Spqr {
 public:
  Spqr() { cholmod_l_start(&common_); }
  ~Spqr() {
    cholmod_l_free_sparse(&R_, &common_);
    cholmod_l_finish(&common_);
  }
  Spqr(const Spqr&) = delete;
  Spqr& operator=(const Spqr&) = delete;

  /// Computes R of A with the columns in their given order. Returns the rank under the tolerance.
  long factorize(const SparseMatrix& A, double tolerance) {
    columns_ = static_cast<std::size_t>(A.cols());
    cholmod_sparse view{};  // a view of Eigen's own arrays, which SPQR only reads
    view.nrow = static_cast<std::size_t>(A.rows());
    view.ncol = columns_;
    view.nzmax = static_cast<std::size_t>(A.nonZeros());
    view.p = const_cast<long*>(A.outerIndexPtr());
    view.i = const_cast<long*>(A.innerIndexPtr());
    view.x = const_cast<double*>(A.valuePtr());
    view.stype = 0;
    view.itype = CHOLMOD_LONG;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    const long rank =
        SuiteSparseQR<double>(SPQR_ORDERING_FIXED, tolerance, A.cols(), &view, &R_, nullptr, &common_);
    if (rank < 0 || R_ == nullptr) throw FailedError("SuiteSparseQR failed, perhaps because memory ran out");
    return rank;
  }

  /// Returns the first `rows` rows of R as a dense matrix.
  Eigen::MatrixXd dense_R(Eigen::Index rows) const {
    Eigen::MatrixXd R = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(columns_));
    const auto* starts = static_cast<const long*>(R_->p);
    const auto* row = static_cast<const long*>(R_->i);
    const auto* value = static_cast<const double*>(R_->x);
    for (Eigen::Index k = 0; k < R.cols(); ++k) {
      for (long e = starts[k]; e < starts[k + 1]; ++e) {
        if (row[e] < rows) R(row[e], k) = value[e];
      }
    }
    return R;
  }

 private:
  cholmod_common common_{};
  cholmod_sparse* R_ = nullptr;
  std::size_t columns_ = 0;
};

}  // namespace

Eigen::MatrixXd triangular_factor(const SparseMatrix& A) {
  Spqr spqr;
  spqr.factorize(A, SPQR_NO_TOL);
  return spqr.dense_R(A.cols());
}

RankRevealed rank_revealing_factor(const SparseMatrix& A, double tolerance) {
  Spqr spqr;
  const Eigen::Index rank = spqr.factorize(A, tolerance);
  const Eigen::MatrixXd staircase = spqr.dense_R(rank);
  RankRevealed revealed;
  revealed.live.reserve(static_cast<std::size_t>(rank));
  revealed.dead.reserve(static_cast<std::size_t>(A.cols() - rank));
  // A live column reaches one row deeper than all columns before it; a dead column does not.
  Eigen::Index row = 0;
  for (int k = 0; k < static_cast<int>(A.cols()); ++k) {
    const bool live = row < rank && staircase(row, k) != 0.0;
    (live ? revealed.live : revealed.dead).push_back(k);
    if (live) ++row;
  }
  revealed.R.resize(rank, A.cols());
  Eigen::Index k = 0;
  for (const auto* columns : {&revealed.live, &revealed.dead}) {
    for (const int column : *columns) revealed.R.col(k++) = staircase.col(column);
  }
  return revealed;
}

}  // namespace armtune::internal

#include "tuner/planning/solver/sparse_cholesky.hpp"

#include <cholmod.h>

#include <algorithm>
#include <stdexcept>

#include "armtune/error.hpp"

namespace armtune::internal {

struct SparseCholesky::Work {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  // Memory of solve(), kept from one call to the next.
  cholmod_dense* solution = nullptr;
  cholmod_dense* y = nullptr;
  cholmod_dense* e = nullptr;

  Work() { cholmod_start(&common); }
  ~Work() {
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&y, &common);
    cholmod_free_dense(&e, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
};

namespace {

cholmod_sparse view_of(const SymmetricMatrix& matrix) {
  cholmod_sparse view{};  // points to our own arrays, which CHOLMOD does not change
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.size);
  view.nzmax = matrix.rows.size();
  view.p = const_cast<int*>(matrix.column_starts.data());
  view.i = const_cast<int*>(matrix.rows.data());
  view.x = const_cast<double*>(matrix.values.data());
  view.stype = 1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

}  // namespace

SparseCholesky::SparseCholesky(const SymmetricMatrix& pattern) : work_(std::make_unique<Work>()) {
  cholmod_common& common = work_->common;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_NATURAL;
  common.postorder = 0;
  common.supernodal = CHOLMOD_SIMPLICIAL;  // blocks of one knot are too small to benefit from BLAS
  common.final_ll = 1;                     // L D L^T would accept negative pivots
  common.print = 0;
  cholmod_sparse view = view_of(pattern);
  work_->factor = cholmod_analyze(&view, &common);
  if (work_->factor == nullptr) throw FailedError("CHOLMOD failed, perhaps because memory ran out");
}

SparseCholesky::~SparseCholesky() = default;

bool SparseCholesky::factorize(const SymmetricMatrix& matrix) {
  cholmod_sparse view = view_of(matrix);
  cholmod_factorize(&view, work_->factor, &work_->common);
  if (work_->common.status < CHOLMOD_OK) throw FailedError("CHOLMOD failed, perhaps because memory ran out");
  return work_->common.status == CHOLMOD_OK && work_->factor->minor == work_->factor->n;
}

void SparseCholesky::solve(Eigen::VectorXd& x) {
  cholmod_dense right{};
  right.nrow = right.nzmax = right.d = static_cast<std::size_t>(x.size());
  right.ncol = 1;
  right.x = x.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  if (cholmod_solve2(CHOLMOD_A, work_->factor, &right, nullptr, &work_->solution, nullptr, &work_->y,
                     &work_->e, &work_->common) == 0)
    throw FailedError("CHOLMOD failed, perhaps because memory ran out");
  std::copy_n(static_cast<const double*>(work_->solution->x), x.size(), x.data());
}

std::unique_ptr<Cholesky> make_sparse_cholesky(const SymmetricMatrix& pattern) {
  return std::make_unique<SparseCholesky>(pattern);
}

}  // namespace armtune::internal

#include "tuner/quadratic/condensed_system.hpp"

#include <cmath>

namespace armtune::internal {
namespace {

using Eigen::VectorXd;

constexpr double kPrimalProximal = 1e-8;  // relative to the program's curvature, thus the same on every grid
constexpr double kDualProximal = 1e-6;    // for rows of size 1; less: rounding errors; more: more corrections
constexpr double kMoreProximal = 100.0;   // factor on delta if K is not positive definite,
constexpr int kMoreOften = 2;             // applied at most this often
constexpr int kCorrections = 20;          // most steps that correct the error of the dual proximal part

bool small(const VectorXd& left, double within) {
  return left.lpNorm<Eigen::Infinity>() <= within;
}

}  // namespace

CondensedSystem::CondensedSystem(const QuadraticProgram& program, NormalMatrix& normal, Cholesky& cholesky)
    : program_(program), R_(*program.residuals), G_(*program.rows), normal_(normal), cholesky_(cholesky) {}

bool CondensedSystem::factorize(const VectorXd& yield) {
  yield_ = &yield;
  D_ = (yield.array() + kDualProximal).inverse();
  for (int more = 0; more <= kMoreOften; ++more) {
    delta_ = kPrimalProximal * std::pow(kMoreProximal, more) * program_.scale;
    normal_.assemble((program_.damping.array() + delta_).matrix(), {&ones_, &D_});
    if (cholesky_.factorize(normal_.matrix())) return true;
  }
  return false;
}

void CondensedSystem::solve(const VectorXd& rd, const VectorXd& e, const LinearAccuracy& accuracy,
                            LinearUnknowns& found) {
  found.x = rd;
  solve_proximal(e, found);
  rows_left(e, found, r2_);
  make_rows_exact(accuracy.rows, found);
  hessian_times(found.x, Hx_);
  r1_ = rd - Hx_ - delta_ * found.x;
  minus_y_ = -found.y;
  G_.add_transposed(minus_y_, r1_);
  rows_left(e, found, r2_);
  if (r1_.lpNorm<1>() <= accuracy.sum && small(r2_, accuracy.rows)) return;
  step_.x = r1_;
  solve_proximal(r2_, step_);
  found.x += step_.x;
  found.y += step_.y;
}

void CondensedSystem::solve_proximal(const VectorXd& e, LinearUnknowns& found) {
  De_ = D_.cwiseProduct(e);
  G_.add_transposed(De_, found.x);
  cholesky_.solve(found.x);
  G_.multiply(found.x, Gx_);
  found.y = D_.cwiseProduct(Gx_) - De_;
}

void CondensedSystem::hessian_times(const VectorXd& v, VectorXd& result) {
  R_.multiply(v, Rx_);
  result = program_.damping.cwiseProduct(v);
  R_.add_transposed(Rx_, result);
  program_.curvature->add_product(v, result);
}

void CondensedSystem::rows_left(const VectorXd& e, const LinearUnknowns& d, VectorXd& left) {
  G_.multiply(d.x, Gx_);
  left = e - Gx_ + yield_->cwiseProduct(d.y);
}

void CondensedSystem::make_rows_exact(double within, LinearUnknowns& d) {
  if (small(r2_, within)) return;
  gap_.x.setZero(d.x.size());
  solve_proximal(r2_, gap_);
  step_ = gap_;
  double size = gap_.y.squaredNorm();
  for (int i = 0; i < kCorrections; ++i) {
    G_.multiply(step_.x, Gx_);
    moved_ = Gx_ - yield_->cwiseProduct(step_.y);
    image_.x.setZero(d.x.size());
    solve_proximal(moved_, image_);
    const double along = step_.y.dot(image_.y);
    if (!(along > 0.0)) return;
    const double alpha = size / along;
    d.x += alpha * step_.x;
    d.y += alpha * step_.y;
    r2_ -= alpha * moved_;
    if (small(r2_, within)) return;
    gap_.x -= alpha * image_.x;
    gap_.y -= alpha * image_.y;
    const double before = size;
    size = gap_.y.squaredNorm();
    step_.x = gap_.x + size / before * step_.x;
    step_.y = gap_.y + size / before * step_.y;
  }
}

}  // namespace armtune::internal

#include "tuner/quadratic/interior_point_iteration.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kLinearAccuracy = 0.3;     // error of a direction, relative to the residuals that it removes
constexpr double kStepBack = 0.995;         // fraction to the boundary
constexpr double kElasticCentering = 0.05;  // relative to the other pairs' target, so that violations vanish
constexpr double kLeastCentering = 0.9;     // least target, relative to the tolerance

}  // namespace

InteriorPointIteration::InteriorPointIteration(const QuadraticProgram& program, NormalMatrix& normal,
                                               Cholesky& cholesky)
    : program_(program),
      G_(*program.rows),
      bounds_(program.bounds),
      rows_(program.rows->rows()),
      system_(program, normal, cholesky) {
  kind_.assign(static_cast<std::size_t>(rows_), 0);
  for (Index i = 0; i < rows_; ++i) {
    unsigned& kind = kind_[static_cast<std::size_t>(i)];
    if (bounds_.lower[i] == bounds_.upper[i])
      kind = kEquation;
    else
      kind =
          (std::isfinite(bounds_.upper[i]) ? kUpper : 0U) | (std::isfinite(bounds_.lower[i]) ? kLower : 0U);
    if (std::isfinite(bounds_.penalty[i])) kind |= kElastic;
  }
  for (VectorXd* part : {&theta_, &yield_, &rw_, &pairs_.upper, &pairs_.lower, &pairs_.over, &pairs_.under})
    part->setZero(rows_);
}

void InteriorPointIteration::start(const VectorXd& x, const VectorXd& y, double mu) {
  at_.set_zero(x.size(), rows_);
  at_.x = x;
  at_.y = y;
  G_.multiply(x, at_.w);
  for (Index i = 0; i < rows_; ++i) {
    keep_within_penalty(i);
    if (equation(i)) {
      at_.w[i] = bounds_.lower[i];
    } else {
      start_range(i, mu);
    }
    if (elastic(i)) {
      at_.over[i] = mu / (bounds_.penalty[i] - at_.y[i]);
      at_.under[i] = mu / (bounds_.penalty[i] + at_.y[i]);
    }
    count_ += (has_upper(i) ? 1 : 0) + (has_lower(i) ? 1 : 0) + (elastic(i) ? 2 : 0);
  }
}

void InteriorPointIteration::measure(InteriorPointResult& result) {
  system_.hessian_times(at_.x, rd_);
  rd_ = -rd_ - program_.gradient;
  rp_ = -at_.y;
  G_.add_transposed(rp_, rd_);
  G_.multiply(at_.x, rp_);
  rp_ = at_.w + at_.over - at_.under - rp_;
  for (Index i = 0; i < rows_; ++i) rw_[i] = equation(i) ? 0.0 : at_.y[i] - at_.upper[i] + at_.lower[i];
  mu_ = complementarity(nullptr, 0.0);
  result.stationarity = rd_.lpNorm<1>() + rw_.lpNorm<1>();
  result.infeasibility = rp_.lpNorm<Eigen::Infinity>();
  result.complementarity = mu_ * static_cast<double>(count_);
}

bool InteriorPointIteration::advance(const InteriorPointOptions& options) {
  if (!factorize()) return false;
  rows_wanted_ =
      std::max(kLinearAccuracy * rp_.lpNorm<Eigen::Infinity>(), kLinearAccuracy * options.infeasibility);
  aim(0.0, nullptr);
  direction(predictor_, count_ == 0);
  const InteriorUnknowns* step = &predictor_;
  if (count_ > 0) {
    const double ratio = complementarity(&predictor_, longest(predictor_)) / mu_;
    const double least = kLeastCentering * options.complementarity / static_cast<double>(count_);
    aim(std::max(ratio * ratio * ratio * mu_, least), &predictor_);
    direction(corrector_, true);
    step = &corrector_;
  }
  at_.add(std::min(1.0, kStepBack * longest(*step)), *step);
  return true;
}

void InteriorPointIteration::keep_within_penalty(Index i) {
  if (elastic(i)) at_.y[i] = std::clamp(at_.y[i], -0.9 * bounds_.penalty[i], 0.9 * bounds_.penalty[i]);
}

void InteriorPointIteration::start_range(Index i, double mu) {
  const double root = std::sqrt(mu);
  const double room = std::min(0.25 * (bounds_.upper[i] - bounds_.lower[i]), root);
  double& y = at_.y[i];
  double w = at_.w[i];
  if (has_upper(i))
    w = y > root ? bounds_.upper[i] - std::min(room, mu / y) : std::min(w, bounds_.upper[i] - room);
  if (has_lower(i))
    w = y < -root ? bounds_.lower[i] + std::min(room, -mu / y) : std::max(w, bounds_.lower[i] + room);
  at_.w[i] = w;
  if (has_upper(i)) at_.upper[i] = std::max(y, mu / below_upper(at_, i));
  if (has_lower(i)) at_.lower[i] = std::max(-y, mu / above_lower(at_, i));
  y = at_.upper[i] - at_.lower[i];
  keep_within_penalty(i);
}

double InteriorPointIteration::complementarity(const InteriorUnknowns* d, double part) const {
  const auto at = [&](const VectorXd InteriorUnknowns::*of, Index i) {
    return d == nullptr ? (at_.*of)[i] : (at_.*of)[i] + part * (d->*of)[i];
  };
  using U = InteriorUnknowns;
  double sum = 0.0;
  for (Index i = 0; i < rows_; ++i) {
    if (has_upper(i)) sum += at(&U::upper, i) * (bounds_.upper[i] - at(&U::w, i));
    if (has_lower(i)) sum += at(&U::lower, i) * (at(&U::w, i) - bounds_.lower[i]);
    if (elastic(i))
      sum += at(&U::over, i) * (bounds_.penalty[i] - at(&U::y, i)) +
             at(&U::under, i) * (bounds_.penalty[i] + at(&U::y, i));
  }
  return count_ == 0 ? 0.0 : sum / static_cast<double>(count_);
}

bool InteriorPointIteration::factorize() {
  for (Index i = 0; i < rows_; ++i) {
    theta_[i] = (has_upper(i) ? at_.upper[i] / below_upper(at_, i) : 0.0) +
                (has_lower(i) ? at_.lower[i] / above_lower(at_, i) : 0.0);
    yield_[i] = theta_[i] > 0.0 ? 1.0 / theta_[i] : 0.0;
    if (elastic(i))
      yield_[i] +=
          at_.over[i] / (bounds_.penalty[i] - at_.y[i]) + at_.under[i] / (bounds_.penalty[i] + at_.y[i]);
  }
  return system_.factorize(yield_);
}

void InteriorPointIteration::aim(double target, const InteriorUnknowns* affine) {
  const auto second = [&](const VectorXd& a, const VectorXd& b, Index i) {
    return affine == nullptr ? 0.0 : a[i] * b[i];
  };
  const InteriorUnknowns& d = affine == nullptr ? at_ : *affine;
  for (Index i = 0; i < rows_; ++i) {
    if (has_upper(i)) pairs_.upper[i] = target - at_.upper[i] * below_upper(at_, i) + second(d.upper, d.w, i);
    if (has_lower(i)) pairs_.lower[i] = target - at_.lower[i] * above_lower(at_, i) - second(d.lower, d.w, i);
    if (!elastic(i)) continue;
    const double give = kElasticCentering * target;
    pairs_.over[i] = give - at_.over[i] * (bounds_.penalty[i] - at_.y[i]) + second(d.over, d.y, i);
    pairs_.under[i] = give - at_.under[i] * (bounds_.penalty[i] + at_.y[i]) - second(d.under, d.y, i);
  }
}

double InteriorPointIteration::push_on_w(Index i) const {
  double push = rw_[i];
  if (has_upper(i)) push -= pairs_.upper[i] / below_upper(at_, i);
  if (has_lower(i)) push += pairs_.lower[i] / above_lower(at_, i);
  return push;
}

void InteriorPointIteration::direction(InteriorUnknowns& d, bool exact) {
  e_ = rp_;
  for (Index i = 0; i < rows_; ++i) {
    if (theta_[i] > 0.0) e_[i] += push_on_w(i) / theta_[i];
    if (elastic(i))
      e_[i] += pairs_.over[i] / (bounds_.penalty[i] - at_.y[i]) -
               pairs_.under[i] / (bounds_.penalty[i] + at_.y[i]);
  }
  d.set_zero(at_.x.size(), rows_);
  if (exact) {
    system_.solve(rd_, e_, {kLinearAccuracy * rd_.lpNorm<1>(), rows_wanted_}, d);
  } else {
    d.x = rd_;
    system_.solve_proximal(e_, d);
  }
  for (Index i = 0; i < rows_; ++i) {
    if (theta_[i] > 0.0) {
      d.w[i] = (push_on_w(i) + d.y[i]) / theta_[i];
      if (has_upper(i)) d.upper[i] = (pairs_.upper[i] + at_.upper[i] * d.w[i]) / below_upper(at_, i);
      if (has_lower(i)) d.lower[i] = (pairs_.lower[i] - at_.lower[i] * d.w[i]) / above_lower(at_, i);
    }
    if (elastic(i)) {
      d.over[i] = (pairs_.over[i] + at_.over[i] * d.y[i]) / (bounds_.penalty[i] - at_.y[i]);
      d.under[i] = (pairs_.under[i] - at_.under[i] * d.y[i]) / (bounds_.penalty[i] + at_.y[i]);
    }
  }
}

double InteriorPointIteration::longest(const InteriorUnknowns& d) const {
  double alpha = 1.0;
  const auto limit = [&](double value, double change) {
    if (change < 0.0) alpha = std::min(alpha, -value / change);
  };
  for (Index i = 0; i < rows_; ++i) {
    if (has_upper(i)) {
      limit(below_upper(at_, i), -d.w[i]);
      limit(at_.upper[i], d.upper[i]);
    }
    if (has_lower(i)) {
      limit(above_lower(at_, i), d.w[i]);
      limit(at_.lower[i], d.lower[i]);
    }
    if (elastic(i)) {
      limit(at_.over[i], d.over[i]);
      limit(at_.under[i], d.under[i]);
      limit(bounds_.penalty[i] - at_.y[i], -d.y[i]);
      limit(bounds_.penalty[i] + at_.y[i], d.y[i]);
    }
  }
  return alpha;
}

}  // namespace armtune::internal

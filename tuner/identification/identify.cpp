#include "tuner/identification/identify.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/common/error.hpp"

namespace armtune {
namespace {

/// Huber's constant: 95 % of the efficiency of least squares on normal errors. Huber, Robust Statistics,
/// 1981.
constexpr double kHuber = 1.345;

/// E[min(|z|, kHuber)^2] of a normal z: what the clipped squares are of the variance.
constexpr double kClippedVariance = 0.7102;

/// Iteratively reweighted least squares: between passes the estimate and every joint's scale, which comes
/// from clipped residuals, so that neither outliers nor their weights move it (Huber's proposal 2).
class Reweighting {
 public:
  explicit Reweighting(int joints)
      : squares_(JointVector::Zero(joints)), clipped_(JointVector::Zero(joints)) {}

  /// Takes what a pass has found.
  void update(const Estimate& estimate) {
    scale_ = rows_ == 0
                 ? JointVector(estimate.torque_residual)
                 : JointVector((clipped_ / (kClippedVariance * static_cast<double>(rows_))).cwiseSqrt());
    theta_ = estimate.theta;
    if (rows_ > 0) residual_ = (squares_ / static_cast<double>(rows_)).cwiseSqrt();
    clipped_.setZero();
    squares_.setZero();
    rows_ = 0;
  }

  /// Multiplies each row by the root of Huber's weight of its residual.
  void weigh(Eigen::MatrixXd& rows) {
    const Eigen::Index rank = theta_.size();
    for (Eigen::Index j = 0; j < rows.rows(); ++j) {
      const double residual = std::abs(rows(j, rank) - rows.row(j).head(rank).dot(theta_));
      const double bound = kHuber * scale_[j];
      squares_[j] += residual * residual;
      clipped_[j] += std::pow(std::min(residual, bound), 2);
      if (residual > bound) rows.row(j) *= std::sqrt(bound / residual);
    }
    ++rows_;
  }

  /// RMS of the residuals as they are, without weights, of the pass before the last update; empty after one.
  const JointVector& residual() const { return residual_; }

 private:
  Eigen::VectorXd theta_;
  JointVector scale_;
  JointVector residual_;
  JointVector squares_;  ///< sums of squared residuals of this pass
  JointVector clipped_;  ///< sums of clipped squared residuals of this pass
  long rows_ = 0;
};

}  // namespace

Identification identify(const RobotModel& model, const std::vector<std::string>& logs,
                        const LogColumns& columns, const IdentifyOptions& options,
                        const std::atomic<bool>& stop) {
  Identification found;
  found.base = base_parameters(model);
  const ParameterVector file_theta = theta_of(model.chain);
  const Eigen::VectorXd prior = found.base.map * file_theta;
  Reweighting reweighting(model.n());
  const int passes = options.robust ? std::max(2, options.passes) : 1;
  for (int pass = 0; pass < passes && !stop; ++pass) {
    Regression regression(model.n(), found.base.rank());
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(model.n());
    long rows_seen = 0;
    found.samples = 0;
    for (std::size_t i = 0; i < logs.size() && !stop; ++i) {
      LogFile log(logs[i], columns);
      RowStream stream(model, found.base, log, options.rows);
      regression.begin_log();
      Eigen::MatrixXd rows;
      long of_this_log = 0;
      while (!stop && stream.next(rows)) {
        squares += rows.rightCols<1>().cwiseAbs2();
        ++of_this_log;
        if (pass > 0) reweighting.weigh(rows);
        regression.add(rows);
        if (options.progress) options.progress(pass, i, found.samples + stream.samples());
      }
      found.samples += stream.samples();
      rows_seen += of_this_log;
      if (!stop) stream.check_velocities();
      if (of_this_log == 0 && !stop) {
        throw InputError(fmt::format(
            "{}: {} samples of {:.4g} s are shorter than the filters' window at a cutoff of {} Hz; "
            "log longer or raise --cutoff",
            logs[i], stream.samples(), log.period(), options.rows.cutoff));
      }
    }
    if (stop) break;
    if (rows_seen * model.n() <= found.base.rank()) {
      throw InputError(fmt::format("{} rows for {} base parameters: log longer", rows_seen * model.n(),
                                   found.base.rank()));
    }
    found.estimate = regression.solve(prior);
    if (!found.estimate.theta.allFinite() || !found.estimate.deviation().allFinite()) {
      throw InputError(fmt::format(
          "{} samples give no finite estimate: do their columns and units fit the arm?", found.samples));
    }
    reweighting.update(found.estimate);
    found.torque_rms = (squares / static_cast<double>(rows_seen)).cwiseSqrt();
  }
  if (reweighting.residual().size() > 0) found.estimate.torque_residual = reweighting.residual();
  found.interrupted = stop;
  if (found.interrupted) return found;
  const PhysicalFit fit = physical_fit(found.base, found.estimate, file_theta);
  found.theta = fit.theta;
  found.made_physical = fit.changed;
  return found;
}

}  // namespace armtune

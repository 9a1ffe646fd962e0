#include "tuner/identification/identify.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armtune/error.hpp"
#include "tuner/identification/log_extremes.hpp"
#include "tuner/identification/torque_moments.hpp"

namespace armtune::internal {
namespace {

/// Huber's constant. With it, the estimate has 95 % of the efficiency of least squares on normal errors.
/// Huber, Robust Statistics, 1981.
constexpr double kHuber = 1.345;

/// E[min(|z|, kHuber)^2] of a standard normal z: the ratio of the mean clipped square to the variance.
constexpr double kClippedVariance = 0.7102;

/// Weights of the iteratively reweighted least squares. Keeps the estimate and every joint's scale from one
/// pass to the next. The scales come from clipped residuals, so that neither outliers nor their weights
/// change them (Huber's proposal 2).
class Reweighting {
 public:
  explicit Reweighting(int joints) : clipped_(JointVector::Zero(joints)) {}

  /// Stores the estimate of a pass, and computes the scales for the next pass.
  void update(const Estimate& estimate) {
    scale_ = rows_ == 0
                 ? JointVector(estimate.torque_residual)
                 : JointVector((clipped_ / (kClippedVariance * static_cast<double>(rows_))).cwiseSqrt());
    theta_ = estimate.theta;
    clipped_.setZero();
    rows_ = 0;
  }

  /// Multiplies each row by the square root of Huber's weight for its residual.
  void weigh(Eigen::MatrixXd& rows) {
    const Eigen::Index rank = theta_.size();
    for (Eigen::Index j = 0; j < rows.rows(); ++j) {
      const double residual = std::abs(rows(j, rank) - rows.row(j).head(rank).dot(theta_));
      const double bound = kHuber * scale_[j];
      clipped_[j] += std::pow(std::min(residual, bound), 2);
      if (residual > bound) rows.row(j) *= std::sqrt(bound / residual);
    }
    ++rows_;
  }

 private:
  Eigen::VectorXd theta_;
  JointVector scale_;
  JointVector clipped_;  ///< sums of clipped squared residuals of this pass
  long rows_ = 0;
};

/// Selects the rows that are left out of the fit: every fifth second.
class HoldOut {
 public:
  HoldOut(bool on, double row_period) : on_(on), rows_(std::max(1L, std::lround(1.0 / row_period))) {}

  bool contains(long row) const { return on_ && row / rows_ % 5 == 4; }

 private:
  bool on_;
  long rows_;
};

std::string logs_name(const std::vector<std::string>& logs) {
  return logs.size() == 1 ? logs.front() : fmt::format("{} and {} more", logs.front(), logs.size() - 1);
}

/// Reads all logs, once or more often, and fits theta_base to them.
class Passes {
 public:
  Passes(const RobotModel& model, const std::vector<std::string>& logs, const LogColumns& columns,
         const IdentifyOptions& options, const std::atomic<bool>& stop)
      : model_(model),
        logs_(logs),
        columns_(columns),
        options_(options),
        stop_(stop),
        base_(base_parameters(model)),
        prior_{base_.map * theta_of(model.chain), group_sizes(base_, parameter_sizes(model))},
        reweighting_(model.n()),
        fitted_(model.n(), base_.rank()),
        held_out_(model.n(), base_.rank()) {}

  Estimate run() {
    const int passes = options_.robust ? std::max(2, options_.passes) : 1;
    Estimate estimate;
    for (int pass = 0; pass < passes && !stop_; ++pass) {
      Regression regression(model_.n(), base_.rank());
      samples_ = 0;
      for (std::size_t i = 0; i < logs_.size() && !stop_; ++i) read_log(pass, i, regression);
      if (stop_) break;
      if (pass == 0) check_first_pass();
      estimate = regression.solve(prior_);
      if (!estimate.theta.allFinite() || !estimate.covariance.allFinite()) {
        throw InputError(
            InputPlace{logs_.front()},
            fmt::format("{} samples give no finite estimate; check the columns and their units", samples_));
      }
      reweighting_.update(estimate);
    }
    return estimate;
  }

  const BaseParameters& base() const { return base_; }
  const TorqueMoments& fitted() const { return fitted_; }
  const TorqueMoments& held_out() const { return held_out_; }
  const LogInstants& instants() const { return instants_; }
  long samples() const { return samples_; }
  const std::vector<std::string>& hashes() const { return hashes_; }

 private:
  void read_log(int pass, std::size_t i, Regression& regression) {
    LogFile log(logs_[i], columns_);
    LogInstants unused;
    RowStream stream(model_, base_, log, options_.rows, pass == 0 ? instants_ : unused);
    const HoldOut hold_out(options_.hold_out, stream.row_period());
    regression.begin_log();
    Eigen::MatrixXd rows;
    long count = 0;
    bool gap = false;
    while (!stop_ && stream.next(rows)) {
      const bool out = hold_out.contains(count++);
      // The rows have no weights in the first pass, so each counts once and equally here.
      if (pass == 0) (out ? held_out_ : fitted_).add(rows);
      if (!out) {
        if (gap) regression.begin_log();
        if (pass > 0) reweighting_.weigh(rows);
        regression.add(rows);
      }
      gap = out;
      if (options_.progress) options_.progress(pass, i, samples_ + stream.samples());
    }
    samples_ += stream.samples();
    if (stop_) return;
    if (pass == 0) hashes_.push_back(log.hash());
    if (log.hash() != hashes_[i])
      throw InputError(InputPlace{logs_[i]}, "changed while it was read; use a log that is complete");
    stream.check_velocities();
    if (count == 0) {
      throw InputError(
          InputPlace{logs_[i]},
          fmt::format("{} samples with a period of {:.4g} s are too few for the filters at a cutoff of "
                      "{} Hz; log longer or raise --cutoff",
                      stream.samples(), log.period(), options_.rows.cutoff))
          .with_value(std::to_string(stream.samples()), "enough samples for the filters");
    }
  }

  void check_first_pass() const {
    if (fitted_.count() * model_.n() <= base_.rank()) {
      throw InputError(InputPlace{logs_.front()},
                       fmt::format("{} equations are too few to identify {} base parameters; log longer",
                                   fitted_.count() * model_.n(), base_.rank()))
          .with_value(std::to_string(fitted_.count() * model_.n()),
                      fmt::format("more than {} equations", base_.rank()));
    }
    check_motion(model_, instants_.kept(), logs_name(logs_));
    check_units(model_, instants_.kept(), logs_name(logs_));
  }

  const RobotModel& model_;
  const std::vector<std::string>& logs_;
  const LogColumns& columns_;
  const IdentifyOptions& options_;
  const std::atomic<bool>& stop_;
  BaseParameters base_;
  WeakPrior prior_;
  Reweighting reweighting_;
  TorqueMoments fitted_;
  TorqueMoments held_out_;
  LogInstants instants_;
  std::vector<std::string> hashes_;
  long samples_ = 0;
};

/// Returns the physically possible theta that is nearest to the estimate. Throws InputError with the place
/// `logs` if the estimate determines none.
PhysicalMinimum fit_theta(const Identification& found, const ParameterVector& prior,
                          const std::string& logs) {
  try {
    return physical_fit(found.base, found.estimate, prior);
  } catch (const InputError& e) {
    throw InputError(InputPlace{logs}, e.what());
  }
}

Unexplained unexplained(const TorqueMoments& moments, const BaseParameters& base,
                        const ParameterVector& theta, const ParameterVector& file_theta) {
  return {moments.count(), moments.torque_rms(), moments.residual_rms(base.map * theta),
          moments.residual_rms(base.map * file_theta), moments.predicted_rms(base.map * file_theta)};
}

}  // namespace

Identification identify(const RobotModel& model, const std::vector<std::string>& logs,
                        const LogColumns& columns, const IdentifyOptions& options,
                        const std::atomic<bool>& stop) {
  Passes passes(model, logs, columns, options, stop);
  Identification found;
  found.estimate = passes.run();
  found.base = passes.base();
  found.samples = passes.samples();
  found.log_hashes = passes.hashes();
  found.interrupted = stop;
  if (found.interrupted) return found;
  const ParameterVector file_theta = theta_of(model.chain);
  const PhysicalMinimum fit = fit_theta(found, file_theta, logs_name(logs));
  found.theta = fit.theta;
  found.made_physical = fit.changed;
  found.fitted = unexplained(passes.fitted(), found.base, found.theta, file_theta);
  found.held_out = unexplained(passes.held_out(), found.base, found.theta, file_theta);
  found.torque_noise = passes.instants().torque_noise();
  found.comparison = compare_with_robot_file(model, passes.instants().kept(), found.torque_noise);
  if (!found.comparison.mistake) check_positions(model, passes.instants().kept(), logs_name(logs));
  return found;
}

}  // namespace armtune::internal

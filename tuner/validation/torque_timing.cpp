#include "tuner/validation/torque_timing.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/robot/friction.hpp"

namespace armtune::internal {
namespace {

constexpr double kLongestTorqueDelay = 0.3;  ///< [s]
constexpr double kShortestConstant = 0.005;  ///< [s]
constexpr double kLongestConstant = 0.5;     ///< [s]
constexpr double kConstantStep = 1.25;       ///< factor between time constants that are tried
/// Instants for which a filter that starts at rest is left to settle, in time constants.
constexpr double kSettling = 4.0;
/// Residuals below this share of a joint's RMS torque are noise.
constexpr double kTimingNoise = 1e-3;
/// Columns of the regression: 1, predicted torque, direction of friction, velocity, acceleration.
constexpr int kTimingTerms = 5;
using TimingMoment = Eigen::Matrix<double, kTimingTerms + 1, kTimingTerms + 1>;

/// Returns the regression's columns of a joint, without the offset: M x 4.
Eigen::MatrixXd model_columns(const WideTorques& wide, Eigen::Index joint) {
  Eigen::MatrixXd columns(wide.qd.rows(), kTimingTerms - 1);
  columns.col(0) = wide.predicted.col(joint);
  columns.col(1) = wide.qd.col(joint).unaryExpr([](double qd) { return coulomb_direction(qd); });
  columns.col(2) = wide.qd.col(joint);
  columns.col(3) = wide.qdd.col(joint);
  return columns;
}

/// Passes every column through T y' + y = x, discretised exactly for x that is constant over a step.
void filter_columns(Eigen::MatrixXd& columns, double period, double time_constant) {
  const double keep = std::exp(-period / time_constant);
  for (Eigen::Index i = 1; i < columns.rows(); ++i) {
    const Eigen::RowVectorXd mean = columns.row(i);
    columns.row(i) = keep * columns.row(i - 1) + (1.0 - keep) * mean;
  }
}

/// Sums y y^T, y = (1, columns, torque), of rows begin .. end - 1 of the torque, with the columns `shift`
/// rows before.
void add_rows(const Eigen::MatrixXd& columns, const Eigen::VectorXd& torque, Eigen::Index begin,
              Eigen::Index end, Eigen::Index shift, TimingMoment& moment) {
  Eigen::Matrix<double, kTimingTerms + 1, 1> y;
  for (Eigen::Index i = begin; i < end; ++i) {
    y << 1.0, columns.row(i - shift).transpose(), torque[i];
    moment.noalias() += y * y.transpose();
  }
}

/// Returns the mean square of what the columns leave of the torque.
double left_of(const TimingMoment& sums) {
  const double count = std::max(1.0, sums(0, 0));
  const TimingMoment moment = sums / count;
  const Eigen::Matrix<double, kTimingTerms, 1> scale =
      moment.diagonal().head<kTimingTerms>().cwiseMax(1e-30).cwiseSqrt().cwiseInverse();
  Eigen::Matrix<double, kTimingTerms, kTimingTerms> H =
      scale.asDiagonal() * moment.topLeftCorner<kTimingTerms, kTimingTerms>() * scale.asDiagonal();
  H.diagonal().array() += 1e-9;
  const Eigen::Matrix<double, kTimingTerms, 1> b =
      scale.cwiseProduct(moment.block<kTimingTerms, 1>(0, kTimingTerms));
  const double torque = moment(kTimingTerms, kTimingTerms);
  return std::max(torque - b.dot(H.ldlt().solve(b)), 0.0) + kTimingNoise * kTimingNoise * torque + 1e-30;
}

/// Computes the logarithm of the geometric mean of the joints' residual RMS for candidates.
class TimingCost {
 public:
  explicit TimingCost(const TorqueRows& rows) : rows_(rows) {}

  double of_delay(Eigen::Index shift, Eigen::Index longest) const {
    return mean([&](const WideTorques& wide, Eigen::Index j, TimingMoment& moment) {
      add_rows(model_columns(wide, j), wide.measured.col(j), longest, wide.qd.rows() - longest, shift,
               moment);
    });
  }
  /// time_constant: 0 for no filter. from: settling time that is left out [s].
  double of_filter(double time_constant, double from) const {
    return mean([&](const WideTorques& wide, Eigen::Index j, TimingMoment& moment) {
      Eigen::MatrixXd columns = model_columns(wide, j);
      if (time_constant > 0.0) filter_columns(columns, wide.period, time_constant);
      const auto begin = static_cast<Eigen::Index>(from / wide.period);
      add_rows(columns, wide.measured.col(j), begin, wide.qd.rows(), 0, moment);
    });
  }

 private:
  template <typename Add>
  double mean(const Add& add) const {
    const auto n = static_cast<Eigen::Index>(rows_.joint.size());
    double sum = 0.0;
    for (Eigen::Index j = 0; j < n; ++j) {
      TimingMoment moment = TimingMoment::Zero();
      for (const WideTorques& wide : rows_.wide) add(wide, j, moment);
      sum += 0.5 * std::log(left_of(moment));
    }
    return sum / static_cast<double>(n);
  }

  const TorqueRows& rows_;
};

}  // namespace

TorqueTiming torque_timing(const TorqueRows& rows) {
  TorqueTiming found;
  const TimingCost cost(rows);
  const double period = rows.wide.front().period;
  const auto longest = static_cast<Eigen::Index>(std::lround(kLongestTorqueDelay / period));
  const auto delay_cost = [&](Eigen::Index shift) { return cost.of_delay(shift, longest + 1); };
  const double now = delay_cost(0);
  Eigen::Index best = 0;
  double least = now;
  for (Eigen::Index shift = -longest; shift <= longest; ++shift) {
    const double value = delay_cost(shift);
    if (value < least) {
      least = value;
      best = shift;
    }
  }
  // Near its minimum the mean square is a parabola of the delay.
  const auto square = [&](Eigen::Index shift) { return std::exp(2.0 * (delay_cost(shift) - least)); };
  const double before = square(best - 1);
  const double after = square(best + 1);
  const double peak = std::clamp(0.5 * (before - after) / std::max(1e-12, before - 2.0 + after), -0.5, 0.5);
  found.delay = (static_cast<double>(best) + peak) * period;
  found.delay_gain = std::exp(least - now);

  for (double constant = kShortestConstant; constant <= kLongestConstant; constant *= kConstantStep) {
    const double gain =
        std::exp(cost.of_filter(constant, kSettling * constant) - cost.of_filter(0.0, kSettling * constant));
    if (gain < found.filter_gain) {
      found.filter_gain = gain;
      found.time_constant = constant;
    }
  }
  return found;
}

}  // namespace armtune::internal

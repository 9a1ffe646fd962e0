#include "tuner/validation/torque_residuals.hpp"

#include <algorithm>
#include <cmath>

#include "tuner/identification/torque_moments.hpp"

namespace armtune::internal {
namespace {

double root_mean_square(double squares, long count) {
  return std::sqrt(squares / static_cast<double>(std::max(1L, count)));
}

/// Returns the residual of a joint at every row.
Eigen::VectorXd residual_at(const Eigen::MatrixXd& rows) {
  return rows.col(kMeasuredTorque) - rows.col(kPredictedTorque);
}

GravityPhase gravity_phase(const TorqueRows& rows, std::size_t joint, double slow) {
  GravityPhase phase;
  double residual = 0.0;
  double torque = 0.0;
  for (Eigen::Index i = 0; i < rows.count(); ++i) {
    if (std::any_of(rows.joint.begin(), rows.joint.end(),
                    [&](const Eigen::MatrixXd& other) { return std::abs(other(i, kJointVelocity)) > slow; }))
      continue;
    ++phase.rows;
    const Eigen::MatrixXd& own = rows.joint[joint];
    residual += std::pow(own(i, kMeasuredTorque) - own(i, kPredictedTorque), 2);
    torque += std::pow(own(i, kMeasuredTorque), 2);
  }
  phase.rms = root_mean_square(residual, phase.rows);
  phase.torque_rms = root_mean_square(torque, phase.rows);
  return phase;
}

/// Returns the mean residual over the instants from `from` on, in steps of `step`, that move in `direction`
/// faster than the threshold. Nothing if there are none.
std::optional<double> mean_beside(const WideTorques& wide, Eigen::Index joint, Eigen::Index from, int step,
                                  double direction, const ValidationThresholds& thresholds) {
  const long most = std::lround(thresholds.reversal_window / wide.period);
  double sum = 0.0;
  long count = 0;
  for (long k = 0; k < most; ++k) {
    const Eigen::Index i = from + step * k;
    if (i < 0 || i >= wide.qd.rows() || wide.qd(i, joint) * direction < 0.0) break;
    if (wide.qd(i, joint) * direction < thresholds.reversal_speed) continue;
    sum += wide.measured(i, joint) - wide.predicted(i, joint);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

ReversalPhase reversal_phase(const TorqueRows& rows, Eigen::Index joint,
                             const ValidationThresholds& thresholds) {
  std::vector<double> steps;
  for (const WideTorques& wide : rows.wide) {
    for (Eigen::Index i = 1; i < wide.qd.rows(); ++i) {
      if (wide.qd(i - 1, joint) * wide.qd(i, joint) >= 0.0) continue;
      const double direction = wide.qd(i, joint) > 0.0 ? 1.0 : -1.0;
      const auto after = mean_beside(wide, joint, i, 1, direction, thresholds);
      const auto before = mean_beside(wide, joint, i - 1, -1, -direction, thresholds);
      if (after && before) steps.push_back(direction * (*after - *before));
    }
  }
  ReversalPhase phase;
  phase.count = static_cast<long>(steps.size());
  if (steps.empty()) return phase;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  phase.half_step = 0.5 * *middle;
  return phase;
}

InertiaPhase inertia_phase(const Eigen::MatrixXd& rows) {
  const Eigen::VectorXd residual = residual_at(rows).array() - residual_at(rows).mean();
  const Eigen::VectorXd qdd = rows.col(kJointAcceleration).array() - rows.col(kJointAcceleration).mean();
  const double product = residual.dot(qdd);
  InertiaPhase phase;
  if (!(qdd.squaredNorm() > 0.0) || !(residual.squaredNorm() > 0.0)) return phase;
  phase.correlation = product / (qdd.norm() * residual.norm());
  phase.slope = product / qdd.squaredNorm();
  return phase;
}

}  // namespace

TorqueResiduals torque_residuals(const TorqueRows& rows, const ValidationThresholds& thresholds) {
  const auto n = static_cast<int>(rows.joint.size());
  // The unfitted model is a regression with one column, its prediction, and the parameter 1.
  TorqueMoments moments(n, 1);
  Eigen::MatrixXd at(n, 2);
  for (Eigen::Index i = 0; i < rows.count(); ++i) {
    for (int j = 0; j < n; ++j) {
      const Eigen::MatrixXd& own = rows.joint[static_cast<std::size_t>(j)];
      at.row(j) << own(i, kPredictedTorque), own(i, kMeasuredTorque);
    }
    moments.add(at);
  }
  const Eigen::VectorXd unchanged = Eigen::VectorXd::Ones(1);
  const Eigen::VectorXd rms = moments.residual_rms(unchanged);
  const Eigen::VectorXd torque = moments.torque_rms();
  const Eigen::VectorXd predicted = moments.predicted_rms(unchanged);
  const Eigen::VectorXd explained = moments.explained(unchanged);
  TorqueResiduals out;
  out.rows = moments.count();
  for (int j = 0; j < n; ++j) {
    JointResidual joint;
    joint.rms = rms[j];
    joint.torque_rms = torque[j];
    joint.predicted_rms = predicted[j];
    joint.explained = explained[j];
    joint.gravity = gravity_phase(rows, static_cast<std::size_t>(j), thresholds.slow);
    joint.reversals = reversal_phase(rows, j, thresholds);
    joint.inertia = inertia_phase(rows.joint[static_cast<std::size_t>(j)]);
    out.joint.push_back(joint);
  }
  return out;
}

std::vector<bool> matching_joints(const RobotModel& model, const TorqueResiduals& residuals,
                                  const ValidationThresholds& thresholds) {
  std::vector<bool> matches;
  const JointVector effort = model.effort_limits();
  for (std::size_t j = 0; j < residuals.joint.size(); ++j) {
    const JointResidual& joint = residuals.joint[j];
    matches.push_back(joint.explained >= thresholds.explained ||
                      joint.rms <= thresholds.negligible * effort[static_cast<Eigen::Index>(j)]);
  }
  return matches;
}

}  // namespace armtune::internal

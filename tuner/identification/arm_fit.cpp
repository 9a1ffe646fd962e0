#include "tuner/identification/arm_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/robot/slotine_li.hpp"

namespace armtune::internal {
namespace {

/// A joint whose whole torque is unexplained costs as much as this many links that each differ by 100 % from
/// those of the robot file.
constexpr double kTorqueWeight = 20.0;
/// Friction and rotor inertia are often missing in robot files, so their changes cost next to nothing. The
/// small weight makes the minimum unique.
constexpr double kJointWeight = 1e-6;
/// A torque below this share of the effort limit may be sensor noise, or the friction of a joint at rest.
constexpr double kNoiseShare = 0.005;
/// Weight of links that must not change: a link that is 1 % off costs as much as a joint whose whole torque
/// is unexplained.
constexpr double kFixed = 1e4 * kTorqueWeight;
/// This accuracy suffices to compare readings with each other.
constexpr PhysicalCone::Accuracy kAccuracy{.iterations = 1000, .tolerance = 1e-6};

}  // namespace

ArmMoments arm_moments(const Chain& chain, const std::vector<LogInstant>& instants) {
  const auto n = static_cast<std::size_t>(chain.n);
  const Eigen::Index p = parameter_count(chain);
  ArmMoments moments;
  moments.YtY.assign(n, Eigen::MatrixXd::Zero(p, p));
  moments.YtT.assign(n, std::vector<Eigen::VectorXd>(n, Eigen::VectorXd::Zero(p)));
  moments.torque_squares = Eigen::VectorXd::Zero(chain.n);
  const double weight = 1.0 / static_cast<double>(std::max<std::size_t>(1, instants.size()));
  Poses poses;
  SlotineLi motion;
  Regressor Y;
  for (const LogInstant& at : instants) {
    forward_kinematics(chain, at.q, poses);
    slotine_li_forward(chain, poses, at.qd, at.qd, at.qdd, motion);
    slotine_li_regressor(chain, poses, motion, Y);
    for (std::size_t j = 0; j < n; ++j) {
      const Eigen::VectorXd row = Y.row(static_cast<Eigen::Index>(j)).transpose();
      moments.YtY[j].selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
      for (std::size_t k = 0; k < n; ++k)
        moments.YtT[j][k] += weight * at.torque[static_cast<Eigen::Index>(k)] * row;
    }
    moments.torque_squares += weight * at.torque.cwiseAbs2();
  }
  for (Eigen::MatrixXd& square : moments.YtY) {
    const Eigen::MatrixXd whole = square.selfadjointView<Eigen::Lower>();
    square = whole;
  }
  return moments;
}

TorqueReading TorqueReading::as_logged(int joints) {
  TorqueReading reading;
  reading.column.resize(static_cast<std::size_t>(joints));
  std::iota(reading.column.begin(), reading.column.end(), 0);
  reading.factor = JointVector::Ones(joints);
  return reading;
}

ArmFitter::ArmFitter(const RobotModel& model, const JointVector& noise)
    : prior_(theta_of(model.chain)),
      noise_(noise),
      least_torque_(kNoiseShare * model.effort_limits()),
      cone_(prior_) {
  const Eigen::Index joints = static_cast<Eigen::Index>(model.n()) * kJointParameters;
  link_metric_ = cone_.metric();
  link_metric_.bottomRightCorner(joints, joints).setZero();
  joint_metric_ = cone_.metric() - link_metric_;
}

ArmFit ArmFitter::fit(const ArmMoments& moments, const TorqueReading& reading) const {
  return fit(moments, reading, 1.0);
}

ArmFit ArmFitter::fit_joints_only(const ArmMoments& moments, const TorqueReading& reading) const {
  return fit(moments, reading, kFixed);
}

ArmFit ArmFitter::fit(const ArmMoments& moments, const TorqueReading& reading, double link_weight) const {
  const auto n = static_cast<Eigen::Index>(reading.column.size());
  Eigen::MatrixXd Q = link_weight * link_metric_ + kJointWeight * joint_metric_;
  Eigen::VectorXd c = Q * prior_;
  const auto factor = [&](Eigen::Index j) { return reading.factor[j] * reading.scale; };
  const auto column = [&](Eigen::Index j) {
    return static_cast<std::size_t>(reading.column[static_cast<std::size_t>(j)]);
  };
  JointVector torque_squares(n);
  JointVector squares(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const auto joint = static_cast<std::size_t>(j);
    torque_squares[j] = factor(j) * factor(j) * moments.torque_squares[static_cast<Eigen::Index>(column(j))];
    const double expected = prior_.dot(moments.YtY[joint] * prior_);
    squares[j] = std::max({least_torque_[j] * least_torque_[j], torque_squares[j], expected});
    Q += kTorqueWeight / squares[j] * moments.YtY[joint];
    c += kTorqueWeight / squares[j] * factor(j) * moments.YtT[joint][column(j)];
  }
  const ParameterVector theta = cone_.minimum(Q, c, kAccuracy).theta;

  ArmFit fit;
  fit.residual.resize(n);
  fit.unexplained.resize(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const auto joint = static_cast<std::size_t>(j);
    const double noise = factor(j) * noise_[static_cast<Eigen::Index>(column(j))];
    const double left = theta.dot(moments.YtY[joint] * theta) -
                        2.0 * factor(j) * moments.YtT[joint][column(j)].dot(theta) + torque_squares[j] -
                        noise * noise;
    fit.residual[j] = std::sqrt(std::max(0.0, left));
    fit.unexplained[j] = fit.residual[j] / std::sqrt(squares[j]);
  }
  const Eigen::VectorXd off = theta - prior_;
  fit.cost = kTorqueWeight * fit.unexplained.squaredNorm() + off.dot(link_metric_ * off);
  return fit;
}

}  // namespace armtune::internal

#include "tuner/calibration/start_states.hpp"

#include <Eigen/QR>

#include "core/robot/dynamics.hpp"

namespace armtune::internal {
namespace {

constexpr double kHalfWindow = 0.05;  ///< [s]
/// Widths of the priors: wide enough for what a polynomial misses, small against the motion in a window.
constexpr double kPositionNoises = 20.0;  ///< of the encoder noise
constexpr double kVelocityShare = 0.02;   ///< of the velocity limit
constexpr double kIntegralShare = 0.2;    ///< of the effort limit

}  // namespace

StartState logged_start(const JointLog& log, const LogWindow& window, const ShootingArm& arm,
                        CommandKind kind, const StepCommands& commands, bool only_after) {
  const double begin = log.time[static_cast<std::size_t>(window.first)];
  const auto near = [&](Eigen::Index i) {
    return std::abs(log.time[static_cast<std::size_t>(i)] - begin) <= kHalfWindow;
  };
  Eigen::Index first = window.first;
  Eigen::Index last = window.first;
  while (!only_after && first > 0 && near(first - 1)) --first;
  while (last + 1 < window.first + window.count && near(last + 1)) ++last;
  Eigen::MatrixXd powers(last - first + 1, 4);
  for (Eigen::Index i = first; i <= last; ++i) {
    const double x = (log.time[static_cast<std::size_t>(i)] - begin) / kHalfWindow;
    powers.row(i - first) << 1.0, x, x * x, x * x * x;
  }
  const Eigen::MatrixXd fit = powers.colPivHouseholderQr().solve(log.q.middleRows(first, last - first + 1));
  StartState state;
  state.q = fit.row(0);
  state.qd = fit.row(1) / kHalfWindow;
  state.integral = JointVector::Zero(state.q.size());
  if (kind == CommandKind::kTorque) return state;
  const JointVector qdd = 2.0 * fit.row(2) / (kHalfWindow * kHalfWindow);
  Poses poses;
  forward_kinematics(arm.model.chain, JointVector(state.q + arm.offset), poses);
  inverse_dynamics(arm.model.chain, poses, state.qd, qdd, state.integral);
  if (arm.model.compensates_gravity) {
    JointVector weight;
    gravity_torque(arm.model.chain, poses, weight);
    state.integral -= weight;
  }
  JointVector wanted = commands.feed.row(0);
  if (commands.position.size() > 0)
    wanted += arm.model.drive_position_gain.cwiseProduct(JointVector(commands.position.row(0)) -
                                                         JointVector(fit.row(0)));
  state.integral -= arm.model.drive_velocity_gain.cwiseProduct(wanted - state.qd);
  return state;
}

StartState start_deviations(const RobotModel& model, const Eigen::VectorXd& encoder_noise) {
  return {kPositionNoises * encoder_noise, kVelocityShare * model.velocity_limits(),
          kIntegralShare * model.effort_limits()};
}

}  // namespace armtune::internal

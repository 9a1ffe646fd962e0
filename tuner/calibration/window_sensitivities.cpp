#include "tuner/calibration/window_sensitivities.hpp"

namespace armtune::internal {
namespace {

/// Step of the differences, in standard deviations of the priors: far above rounding, and small enough for
/// the curvature of the motion.
constexpr double kDifference = 1e-3;

}  // namespace

WindowModel::WindowModel(const RobotModel& model, const ShootingArm& arm, const MotionCommands& commands,
                         std::vector<CalibrationParameter> parameters, const StartState& deviations)
    : kind_(commands.kind),
      nominal_(arm),
      parameters_(std::move(parameters)),
      deviations_(deviations),
      start_size_((commands.kind == CommandKind::kTorque ? 2 : 3) * model.n()),
      shooting_(model, commands) {}

ShotWindow WindowModel::window(const JointLog& log, const CommandSignal& signal, const LogWindow& samples,
                               const Eigen::VectorXd& z, bool only_after) const {
  const ShootingArm arm = arm_at(nominal_, parameters_, z);
  const StepCommands commands = shooting_.step_commands(signal, log, samples, arm.delay);
  return {&log, &signal, samples, logged_start(log, samples, arm, kind_, commands, only_after),
          Eigen::VectorXd::Zero(start_size_)};
}

StartState WindowModel::start_of(const ShotWindow& window, const Eigen::VectorXd& deviation) const {
  const int n = joints();
  StartState start = window.start;
  start.q += deviations_.q.cwiseProduct(JointVector(deviation.head(n)));
  start.qd += deviations_.qd.cwiseProduct(JointVector(deviation.segment(n, n)));
  if (start_size_ > 2 * n)
    start.integral += deviations_.integral.cwiseProduct(JointVector(deviation.tail(n)));
  return start;
}

Eigen::VectorXd WindowModel::residual(const ShotWindow& window, const Eigen::VectorXd& z) {
  const ShootingArm arm = arm_at(nominal_, parameters_, z);
  const StepCommands commands =
      shooting_.step_commands(*window.signal, *window.log, window.samples, arm.delay);
  const StartState start = start_of(window, window.deviation);
  const Shot shot{&arm, &start, &commands};
  const Eigen::MatrixXd logged =
      window.log->q.middleRows(window.samples.first, window.samples.count).transpose();
  return shooting_.simulate(*window.log, window.samples, {&shot, 1}) - logged.reshaped();
}

Sensitivities WindowModel::sensitivities(const ShotWindow& window, const Eigen::VectorXd& z,
                                         bool by_parameters) {
  const auto p = by_parameters ? static_cast<Eigen::Index>(parameters_.size()) : 0;
  const Eigen::Index m = start_size_;
  std::vector<ShootingArm> arms{arm_at(nominal_, parameters_, z)};
  std::vector<StartState> starts{start_of(window, window.deviation)};
  const auto commands_at = [&](double delay) {
    return shooting_.step_commands(*window.signal, *window.log, window.samples, delay);
  };
  std::vector<StepCommands> commands{commands_at(arms[0].delay)};
  arms.reserve(static_cast<std::size_t>(p + 1));
  starts.reserve(static_cast<std::size_t>(m + 1));
  commands.reserve(2);
  std::vector<Shot> shots{{arms.data(), starts.data(), commands.data()}};
  for (Eigen::Index i = 0; i < p; ++i) {
    Eigen::VectorXd moved = z;
    moved[i] += kDifference;
    arms.push_back(arm_at(nominal_, parameters_, moved));
    const bool delays = parameters_[static_cast<std::size_t>(i)].kind == ParameterKind::kDelay;
    if (delays) commands.push_back(commands_at(arms.back().delay));
    shots.push_back({&arms.back(), starts.data(), delays ? &commands.back() : commands.data()});
  }
  for (Eigen::Index i = 0; i < m; ++i) {
    Eigen::VectorXd moved = window.deviation;
    moved[i] += kDifference;
    starts.push_back(start_of(window, moved));
    shots.push_back({arms.data(), &starts.back(), commands.data()});
  }
  const Eigen::MatrixXd predicted = shooting_.simulate(*window.log, window.samples, shots);
  const Eigen::MatrixXd logged =
      window.log->q.middleRows(window.samples.first, window.samples.count).transpose();
  Sensitivities found;
  found.residual = predicted.col(0) - logged.reshaped();
  found.by_parameters = (predicted.middleCols(1, p).colwise() - predicted.col(0)) / kDifference;
  found.by_start = (predicted.rightCols(m).colwise() - predicted.col(0)) / kDifference;
  return found;
}

}  // namespace armtune::internal

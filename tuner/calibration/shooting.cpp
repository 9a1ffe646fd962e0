#include "tuner/calibration/shooting.hpp"

#include <algorithm>
#include <cmath>

#include "core/control/laws/joint_drives.hpp"
#include "core/robot/dynamics.hpp"
#include "sim/lanes/chain_numbers.hpp"
#include "sim/plant/flush_denormals.hpp"
#include "tuner/validation/motion_windows.hpp"

namespace armtune::internal {
namespace {

constexpr double kLongestStep = 2e-3;  ///< of an arm without drives [s]

std::array<double, kMostChainNumbers> numbers_in(const Chain& chain) {
  std::array<double, kMostChainNumbers> numbers{};
  auto* next = numbers.data();
  for_each_number(chain, [&](double x) { *next++ = x; });
  return numbers;
}

LaneKind lanes_for(const Chain& chain, double step) {
  LaneKind kind;
  kind.n = chain.n;
  kind.motion = chain.motion;
  kind.control_period = step;
  kind.law = ArmLawKind::kJointPd;  // never called: the torques come from the log or from the drives
  return kind;
}

}  // namespace

/// A version of the arm in a lane.
struct Shooting::Lane {
  const Shot* shot = nullptr;
  std::optional<VelocityDrives> drives;
  std::optional<DriveOutput> output;
  JointVector effort;
  JointVector q, qd, last_q, last_qd, tau, wanted, weight;
  Poses poses;

  /// Returns the logged position at a share x of the last step: the cubic polynomial through both states.
  JointVector reading(double x, double step) const {
    const double y = 1.0 - x;
    const JointVector between = y * y * (1.0 + 2.0 * x) * last_q + x * x * (1.0 + 2.0 * y) * q +
                                step * x * y * (y * last_qd - x * qd) - shot->arm->offset;
    JointVector reading = between;
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const double start = shot->start->q[j];
      const bool near = std::abs(between[j] - start) < kFar;  // false for NaN
      if (!near) reading[j] = start + kFar;
    }
    return reading;
  }
};

Shooting::Shooting(const RobotModel& nominal, const MotionCommands& commands)
    : nominal_(shooting_arm(nominal).model), kind_(commands.kind), servo_(commands.servo) {
  const bool drives = commands.kind != CommandKind::kTorque;
  holds_weight_ = drives ? nominal.compensates_gravity : commands.robot_adds_weight;
  const double period = median_step(commands.time);
  step_ = period / (drives ? armtune::internal::steps_in(period, drive_frequency(nominal, 0.0))
                           : std::ceil(period / kLongestStep - 1e-9));
  arms_ = make_arm_lanes(lanes_for(nominal_.chain, step_), most_lanes(best_processor()), best_processor());
  lanes_.resize(static_cast<std::size_t>(arms_->lanes()));
  const JointVector zero = JointVector::Zero(nominal.n());
  for (int l = 0; l < arms_->lanes(); ++l) {
    place(l, nominal_.chain, zero, zero);
    arms_->sense(l, {.q = zero.data(), .qd = zero.data(), .obstacles = nullptr, .obstacle_count = 0});
  }
  arms_->measure();  // the first step of lanes begins with the poses of a measurement
  arms_->observe(true);
  arms_->step();
}

/// Makes an arm the one of a lane. The lanes' controllers are never called, so their numbers do not matter.
void Shooting::place(int lane, const Chain& chain, const JointVector& q, const JointVector& qd) {
  const auto numbers = numbers_in(chain);
  const ParameterVector theta = ParameterVector::Zero((kLinkParameters + kJointParameters) * chain.n);
  const JointVector zero = JointVector::Zero(chain.n);
  const double* const own[] = {zero.data(), zero.data()};
  arms_->start(lane, {.control_chain = numbers.data(),
                      .plant_chain = numbers.data(),
                      .damping = {},
                      .law = {.theta = theta.data(), .own = own},
                      .centering_middle = zero.data(),
                      .centering_rate = zero.data(),
                      .theta_true = theta.data(),
                      .q = q.data(),
                      .qd = qd.data()});
}

Shooting::~Shooting() = default;

Eigen::Index Shooting::steps_in(const JointLog& log, const LogWindow& window) const {
  const double length = log.time[static_cast<std::size_t>(window.first + window.count - 1)] -
                        log.time[static_cast<std::size_t>(window.first)];
  return static_cast<Eigen::Index>(std::ceil(length / step_ - 1e-6)) + 1;
}

StepCommands Shooting::step_commands(const CommandSignal& signal, const JointLog& log,
                                     const LogWindow& window, double delay) const {
  const double begin = log.time[static_cast<std::size_t>(window.first)];
  const Eigen::Index steps = steps_in(log, window);
  if (kind_ != CommandKind::kPosition) return {signal.means(begin, step_, steps, delay), {}};
  if (!servo_) {
    // The drives move from one position to the next in a cycle, as in cyclic synchronous position mode.
    const Eigen::MatrixXd path = signal.interpolated(begin, step_, steps + 1, delay + signal.period());
    return {(path.bottomRows(steps) - path.topRows(steps)) / step_, path.topRows(steps)};
  }
  const auto warm_up = static_cast<Eigen::Index>(kServoWarmUp / step_);
  const Eigen::MatrixXd commanded =
      signal.means(begin - static_cast<double>(warm_up) * step_, step_, warm_up + steps, delay);
  PositionServo servo(nominal_, *servo_, step_);
  servo.start(commanded.row(0));
  StepCommands found{Eigen::MatrixXd(steps, nominal_.n()), Eigen::MatrixXd(steps, nominal_.n())};
  for (Eigen::Index i = 0; i < warm_up + steps; ++i) {
    const JointVector from = servo.position();
    servo.step(commanded.row(i));
    if (i < warm_up) continue;
    found.feed.row(i - warm_up) = (servo.position() - from) / step_;
    found.position.row(i - warm_up) = from;
  }
  return found;
}

/// Puts a shot into a lane.
void Shooting::start(int lane, const Shot& shot) {
  Lane& at = lanes_[static_cast<std::size_t>(lane)];
  const RobotModel& model = shot.arm->model;
  at.shot = &shot;
  at.q = shot.start->q + shot.arm->offset;
  at.qd = shot.start->qd;
  at.effort = model.effort_limits();
  if (kind_ != CommandKind::kTorque) {
    at.drives.emplace(model);
    at.drives->hold(shot.start->integral);
    at.output.emplace(model, step_);
    at.output->start(shot.start->integral);
  }
  place(lane, model.chain, at.q, at.qd);
}

/// Computes the torque of a lane in a step.
void Shooting::push(int lane, Eigen::Index step) {
  Lane& at = lanes_[static_cast<std::size_t>(lane)];
  const ShootingArm& arm = *at.shot->arm;
  const StepCommands& commands = *at.shot->commands;
  at.wanted = commands.feed.row(step);
  if (at.drives) {
    if (commands.position.size() > 0)
      at.wanted += arm.model.drive_position_gain.cwiseProduct(JointVector(commands.position.row(step)) -
                                                              (at.q - arm.offset));
    at.drives->torque(at.wanted, at.qd, step_, at.tau);
  } else {
    at.tau = arm.torque_factor.cwiseProduct(at.wanted);
  }
  if (holds_weight_) {  // with the robot's own model and positions
    at.wanted = at.q - arm.offset;
    forward_kinematics(nominal_.chain, at.wanted, at.poses);
    gravity_torque(nominal_.chain, at.poses, at.weight);
    at.tau += at.weight;
  }
  if (at.output) at.output->pass(at.tau);
  at.tau = at.tau.cwiseMax(-at.effort).cwiseMin(at.effort);
  arms_->push(lane, at.tau.data());
}

Eigen::MatrixXd Shooting::simulate(const JointLog& log, const LogWindow& window,
                                   std::span<const Shot> shots) {
  const FlushDenormals flush;
  const int n = nominal_.n();
  const auto width = static_cast<std::size_t>(arms_->lanes());
  const Eigen::Index steps = steps_in(log, window);
  const double begin = log.time[static_cast<std::size_t>(window.first)];
  Eigen::MatrixXd predicted(window.count * n, static_cast<Eigen::Index>(shots.size()));
  for (std::size_t from = 0; from < shots.size(); from += width) {
    const std::size_t used = std::min(width, shots.size() - from);
    for (std::size_t l = 0; l < width; ++l) start(static_cast<int>(l), shots[from + std::min(l, used - 1)]);
    Eigen::Index sample = 0;
    for (Eigen::Index k = 0; k < steps && sample < window.count; ++k) {
      for (std::size_t l = 0; l < used; ++l) {
        lanes_[l].last_q = lanes_[l].q;
        lanes_[l].last_qd = lanes_[l].qd;
        push(static_cast<int>(l), k);
      }
      arms_->step();
      for (std::size_t l = 0; l < used; ++l)
        arms_->moved(static_cast<int>(l), lanes_[l].q.data(), lanes_[l].qd.data());
      for (; sample < window.count; ++sample) {
        const double x = (log.time[static_cast<std::size_t>(window.first + sample)] - begin) / step_ -
                         static_cast<double>(k);
        if (x > 1.0 - 1e-6 && k + 1 < steps) break;
        for (std::size_t l = 0; l < used; ++l)
          predicted.block(sample * n, static_cast<Eigen::Index>(from + l), n, 1) =
              lanes_[l].reading(x, step_);
      }
    }
  }
  return predicted;
}

}  // namespace armtune::internal

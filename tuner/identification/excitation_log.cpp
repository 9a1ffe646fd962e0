#include "tuner/identification/excitation_log.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "armtune/error.hpp"
#include "core/common/delay_line.hpp"
#include "core/control/joint_space_law.hpp"
#include "core/control/laws/joint_drives.hpp"
#include "core/robot/dynamics.hpp"
#include "core/robot/slotine_li.hpp"
#include "sim/csv/cell.hpp"
#include "sim/plant/flush_denormals.hpp"
#include "sim/plant/plant.hpp"
#include "sim/plant/sensors.hpp"

namespace armtune::internal {
namespace {

constexpr double kWayToCenter = 3.0;  ///< duration of the motion to the centre [s]
/// If the arm is farther than this from the trajectory, it does not follow it [rad, m].
constexpr double kLost = 0.5;
/// Makes the random numbers of the torque noise differ from those of the other sensors.
constexpr std::uint64_t kTorqueStream = 0x746f72717565;

/// The control law that follows the trajectory: tau = Y theta - Kd S, with joint space references.
class Follower {
 public:
  Follower(const RobotModel& model, const JointVector& center, const ExcitationLogOptions& options)
      : model_(model), theta_(theta_of(model.chain)), limits_(model.effort_limits()) {
    JointMatrix M;
    forward_kinematics(model.chain, center, poses_);
    mass_matrix(model.chain, poses_, M);
    Kd_ = options.bandwidth * (M.diagonal() + model.chain.rotor_inertia);
    Kp_ = JointVector::Constant(model.n(), options.stiffness);
  }

  JointVector torque(const MotionPoint<JointVector>& desired, const JointState& measured) {
    joint_space_references(desired, Kp_, measured.q, measured.qd, reference_);
    forward_kinematics(model_.chain, measured.q, poses_);
    slotine_li_forward(model_.chain, poses_, measured.qd, reference_.velocity, reference_.acceleration,
                       motion_);
    slotine_li_torque(model_.chain, poses_, motion_, theta_, torque_);
    torque_ -= Kd_.cwiseProduct(measured.qd - reference_.velocity);
    return torque_.cwiseMax(-limits_).cwiseMin(limits_);
  }

 private:
  const RobotModel& model_;
  ParameterVector theta_;
  JointVector limits_, Kp_, Kd_, torque_;
  JointReference reference_;
  Poses poses_;
  SlotineLi motion_;
};

void check_following(const RobotModel& model, double error, double time) {
  if (error <= kLost) return;
  throw InputError(
      InputPlace{model.source},
      fmt::format("the simulated arm is {:.3g} rad or m off the trajectory at {:.3f} s; its parameters "
                  "differ too much from the robot file, or the effort limits are too low",
                  error, time))
      .with_value(fmt::format("{:.3g}", error), fmt::format("at most {} rad or m", kLost));
}

}  // namespace

ExcitationLog simulate_excitation(const Scenario& scenario, const Excitation& excitation,
                                  const ExcitationLogOptions& options, const std::atomic<bool>& stop) {
  const FlushDenormals flush;
  Scenario bare = scenario;
  if (!options.payload) bare.plant.payload = {};
  const RobotModel& model = *scenario.robot;
  const RobotModel plant_arm = plant_model(bare);
  const auto plant = make_simbody_plant(plant_arm, options.stepper);
  const double period = scenario.control_period;
  const int steps = steps_in(period, scenario.plant.rate);
  Sensors sensors(scenario.plant.position_noise, scenario.plant.velocity_noise, scenario.seed);
  DelayLine delay(model.n(), scenario.plant.torque_delay_periods);
  std::mt19937_64 generator(scenario.seed ^ kTorqueStream);
  std::normal_distribution<double> normal;
  Follower follower(model, excitation.center, options);
  const JointVector velocity_limits = model.velocity_limits();
  const JointVector effort_limits = model.effort_limits();

  plant->set_state(scenario.start_position, JointVector::Zero(model.n()));
  ExcitationLog log;
  const long before = std::lround(kWayToCenter / period);
  const long periods = before + std::lround(excitation.duration / period);
  log.samples.reserve(static_cast<std::size_t>(periods - before + 1));
  JointState measured;
  JointVector last = JointVector::Zero(model.n());
  for (long k = 0; k <= periods; ++k) {
    const double time = static_cast<double>(k - before) * period;
    const MotionPoint<JointVector> desired =
        k < before
            ? joint_trajectory(scenario.start_position, excitation.center, kWayToCenter, time + kWayToCenter)
            : excitation.at(time);
    const double error = (plant->q() - desired.position).cwiseAbs().maxCoeff();
    check_following(model, error, time);
    sensors.measure(plant->q(), plant->qd(), measured);
    const JointVector acting = delay.pass(follower.torque(desired, measured));
    if (k >= before) {
      log.tracking_error = std::max(log.tracking_error, error);
      log.velocity_ratio =
          std::max(log.velocity_ratio, plant->qd().cwiseQuotient(velocity_limits).cwiseAbs().maxCoeff());
      log.saturated = log.saturated || (acting.cwiseAbs().array() >= effort_limits.array()).any();
      JointVector torque = 0.5 * (last + acting);
      if (options.torque_noise > 0.0) {
        for (double& x : torque) x += options.torque_noise * normal(generator);
      }
      log.samples.push_back({time, measured.q, measured.qd, torque});
    }
    last = acting;
    if (stop) {
      log.interrupted = true;
      break;
    }
    for (int step = 0; step < steps; ++step) plant->step(acting, period / steps);
  }
  return log;
}

std::string log_csv(const RobotModel& model, const ExcitationLog& log) {
  const LogColumns columns = default_log_columns(model);
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}", columns.time.name);
  for (std::size_t j = 0; j < columns.position.size(); ++j) {
    fmt::format_to(out, ",{},{},{}", columns.position[j].name, columns.velocity[j].name,
                   columns.torque[j].name);
  }
  fmt::format_to(out, "\n");
  for (const LogSample& sample : log.samples) {
    fmt::format_to(out, "{}", cell(sample.time));
    for (Eigen::Index j = 0; j < sample.q.size(); ++j) {
      fmt::format_to(out, ",{},{},{}", cell(sample.q[j]), cell(sample.qd[j]), cell(sample.torque[j]));
    }
    fmt::format_to(out, "\n");
  }
  return fmt::to_string(text);
}

}  // namespace armtune::internal

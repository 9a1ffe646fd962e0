#pragma once
// Arms that differ from their robot file in what calibration fits, and logs of their motion under three kinds
// of commands. A log has noisy encoders and the commands. Some of its samples are lost, and it has no
// torques.

#include <cmath>
#include <random>

#include "core/common/delay_line.hpp"
#include "core/control/laws/first_gains.hpp"
#include "core/control/laws/joint_drives.hpp"
#include "core/robot/dynamics.hpp"
#include "sim/plant/plant.hpp"
#include "tuner/calibration/calibrate.hpp"

namespace armtune::internal::test {

/// The arm of a robot file, and the one that the logs show.
struct HiddenArm {
  RobotModel model;
  ShootingArm truth;
  double payload_mass = 0.0;
  Vec3 payload_center = Vec3::Zero();
  double tilt_x = 0.0, tilt_y = 0.0;
};

struct HiddenRecording {
  CommandKind kind = CommandKind::kTorque;
  unsigned seed = 1;             ///< of motion and noise
  double rate = 500.0;           ///< of control, encoders and commands [Hz]
  double duration = 20.0;        ///< [s]
  double position_noise = 5e-5;  ///< standard deviation [rad, m]
  double velocity_noise = 1e-3;  ///< in what the controller sees [rad/s, m/s]
  double lost = 0.05;            ///< share of the samples that are not in the log
};

/// Returns the value of a parameter of the hidden arm.
inline double true_value(const HiddenArm& arm, const CalibrationParameter& p) {
  const RobotModel& m = arm.truth.model;
  switch (p.kind) {
    case ParameterKind::kViscousFriction:
      return m.chain.viscous_friction[p.joint];
    case ParameterKind::kCoulombFriction:
      return m.chain.coulomb_friction[p.joint];
    case ParameterKind::kRotorInertia:
      return m.chain.rotor_inertia[p.joint];
    case ParameterKind::kVelocityGain:
      return m.drive_velocity_gain[p.joint];
    case ParameterKind::kIntegralGain:
      return m.drive_velocity_integral[p.joint];
    case ParameterKind::kPositionGain:
      return m.drive_position_gain[p.joint];
    case ParameterKind::kTorqueFactor:
      return arm.truth.torque_factor[p.joint];
    case ParameterKind::kDelay:
      return arm.truth.delay;
    case ParameterKind::kPayloadMass:
      return arm.payload_mass;
    case ParameterKind::kPayloadCenterX:
      return arm.payload_center.x();
    case ParameterKind::kPayloadCenterY:
      return arm.payload_center.y();
    case ParameterKind::kPayloadCenterZ:
      return arm.payload_center.z();
    case ParameterKind::kTiltX:
      return arm.tilt_x;
    case ParameterKind::kTiltY:
      return arm.tilt_y;
    case ParameterKind::kEncoderOffset:
      return arm.truth.offset[p.joint];
  }
  return 0.0;
}

/// Draws an arm. The robot file of `model` gets friction: 2 % of the effort limits.
inline HiddenArm hidden_arm(RobotModel model, unsigned seed, double rate = 500.0) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const auto factor = [&](double deviation) { return std::exp(deviation * normal(generator)); };
  HiddenArm arm;
  const int n = model.n();
  model.chain.coulomb_friction = 0.02 * model.effort_limits();
  model.chain.viscous_friction = 0.01 * model.effort_limits();
  arm.model = model;
  arm.truth = shooting_arm(model);
  RobotModel& m = arm.truth.model;
  for (int j = 0; j < n; ++j) {
    m.chain.coulomb_friction[j] *= factor(0.5);
    m.chain.viscous_friction[j] *= factor(0.5);
    m.chain.rotor_inertia[j] *= factor(0.4);
    m.drive_velocity_gain[j] *= factor(0.3);
    m.drive_velocity_integral[j] *= factor(0.3);
    m.drive_position_gain[j] *= factor(0.3);
    arm.truth.offset[j] = 0.004 * normal(generator);
  }
  arm.truth.delay = std::floor(1.0 + 4.0 * uniform(generator)) / rate;
  arm.payload_mass = 0.3 + 2.0 * uniform(generator);
  const Vec3 center(0.1 * (uniform(generator) - 0.5), 0.1 * (uniform(generator) - 0.5),
                    0.03 + 0.1 * uniform(generator));
  arm.payload_center = center;
  m = with_payload(m, {arm.payload_mass, center});
  arm.tilt_x = 0.01 * normal(generator);
  arm.tilt_y = 0.01 * normal(generator);
  const Vec3 tilt(arm.tilt_x, arm.tilt_y, 0.0);
  m.chain.gravity = Eigen::AngleAxisd(-tilt.norm(), tilt.normalized()) * m.chain.gravity;
  return arm;
}

/// A smooth random motion inside the limits: per joint a sum of five sines about a centre.
class HiddenMotion {
 public:
  HiddenMotion(const RobotModel& model, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform;
    for (int j = 0; j < model.n(); ++j) {
      const JointLimits& limits = model.joints[static_cast<std::size_t>(j)].limits;
      const double half = limits.has_position ? 0.5 * (limits.upper - limits.lower) : M_PI;
      const double middle = limits.has_position ? 0.5 * (limits.upper + limits.lower) : 0.0;
      const double size = std::min({0.8, 0.7 * half, 0.25 * limits.velocity});
      center_.push_back(middle + 0.2 * (2.0 * uniform(generator) - 1.0) * half);
      for (int k = 0; k < kSines; ++k) {
        frequency_.push_back(2.0 * M_PI * (0.08 + 0.2 * k + 0.16 * uniform(generator)));
        amplitude_.push_back(size * (0.4 + 0.6 * uniform(generator)) / (1.0 + k));
        phase_.push_back(2.0 * M_PI * uniform(generator));
      }
    }
  }

  void at(double t, JointVector& q, JointVector& qd) const {
    const auto n = static_cast<Eigen::Index>(center_.size());
    q.setZero(n);
    qd.setZero(n);
    for (Eigen::Index j = 0; j < n; ++j) {
      q[j] = center_[static_cast<std::size_t>(j)];
      for (int k = 0; k < kSines; ++k) {
        const auto i = static_cast<std::size_t>(j * kSines + k);
        q[j] += amplitude_[i] * std::sin(frequency_[i] * t + phase_[i]);
        qd[j] += amplitude_[i] * frequency_[i] * std::cos(frequency_[i] * t + phase_[i]);
      }
    }
  }

 private:
  static constexpr int kSines = 5;
  std::vector<double> center_, frequency_, amplitude_, phase_;
};

/// Simulates the hidden arm under a controller: PD with the robot file's gravity torque (commands are
/// torques), the law of a joint_trajectory_controller with a velocity interface, or streamed positions.
inline CommandedLog record(const HiddenArm& arm, const HiddenRecording& how) {
  const int n = arm.model.n();
  const double period = 1.0 / how.rate;
  const double lead_in = 1.5;  // the log begins in motion
  std::mt19937 generator(how.seed + 7777);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const HiddenMotion motion(arm.model, how.seed);
  const std::unique_ptr<Plant> plant = make_native_plant(arm.truth.model, Stepper::kMidpoint);
  JointVector reference, rate;
  motion.at(0.0, reference, rate);
  plant->set_state(reference + arm.truth.offset, rate);
  const int delay = static_cast<int>(std::lround(arm.truth.delay * how.rate));
  const JointVector inertia = joint_inertia(arm.model, reference);
  const JointVector P = 400.0 * inertia;
  const JointVector D = 30.0 * inertia;
  const JointVector effort = arm.model.effort_limits();
  CommandedLog made;
  made.commands.kind = how.kind;
  if (how.kind == CommandKind::kPosition) made.commands.servo = ServoGains{300.0, 0.1};
  std::optional<JointDrives> drives;
  const DriveTiming timing{kDriveFrequency, delay};
  if (how.kind == CommandKind::kVelocity) drives.emplace(arm.truth.model, period, timing);
  if (how.kind == CommandKind::kPosition)
    drives.emplace(arm.truth.model, period, timing, *made.commands.servo, kDrivePositionGain);
  DelayLine line(n, delay);
  Poses poses;
  JointVector weight, tau, command;
  std::vector<JointVector> logged, commanded;
  made.log.source = "hidden arm";
  const auto samples = static_cast<int>((lead_in + how.duration) * how.rate);
  for (int k = 0; k < samples; ++k) {
    const double t = k * period;
    JointState seen{plant->q() - arm.truth.offset, plant->qd()};
    for (int j = 0; j < n; ++j) {
      seen.q[j] += how.position_noise * normal(generator);
      seen.qd[j] += how.velocity_noise * normal(generator);
    }
    motion.at(t, reference, rate);
    if (how.kind == CommandKind::kTorque) {
      forward_kinematics(arm.model.chain, seen.q, poses);
      gravity_torque(arm.model.chain, poses, weight);
      command = weight + P.cwiseProduct(reference - seen.q) + D.cwiseProduct(rate - seen.qd);
      if (k == 0) line.fill(command);
    } else {
      command = reference;
      if (how.kind == CommandKind::kVelocity) command = rate + 4.0 * (reference - seen.q);
    }
    if (t >= lead_in && uniform(generator) >= how.lost) {
      made.log.time.push_back(t - lead_in);
      logged.push_back(seen.q);
      commanded.push_back(command);
    }
    if (!drives) {
      tau = arm.truth.torque_factor.cwiseProduct(line.pass(command)).cwiseMax(-effort).cwiseMin(effort);
      plant->step(tau, period);
      continue;
    }
    forward_kinematics(arm.truth.model.chain, plant->q(), poses);
    gravity_torque(arm.truth.model.chain, poses, weight);
    for (int s = 0; s < drives->steps(); ++s) {
      const JointState now{plant->q() - arm.truth.offset, plant->qd()};
      if (s == 0) drives->begin(command, now, weight);
      drives->torque(now, tau);
      plant->step(tau.cwiseMax(-effort).cwiseMin(effort), period / drives->steps());
    }
  }
  made.commands.time = made.log.time;
  made.log.q.resize(static_cast<Eigen::Index>(logged.size()), n);
  made.commands.value.resize(made.log.q.rows(), n);
  for (std::size_t i = 0; i < logged.size(); ++i) {
    made.log.q.row(static_cast<Eigen::Index>(i)) = logged[i].transpose();
    made.commands.value.row(static_cast<Eigen::Index>(i)) = commanded[i].transpose();
  }
  return made;
}

}  // namespace armtune::internal::test

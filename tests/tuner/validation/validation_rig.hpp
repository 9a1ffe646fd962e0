#pragma once
// Logs of arms that differ from their robot file in a known way, with the noise of real sensors.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/robot/dynamics.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/states.hpp"
#include "tuner/validation/torque_validation.hpp"

namespace armtune::internal::test {

/// How a log is recorded.
struct Recording {
  unsigned seed = 1;
  double rate = 250.0;           ///< [Hz]
  double duration = 20.0;        ///< [s]
  double position_noise = 1e-5;  ///< standard deviation [rad, m]
  double velocity_noise = 1e-3;  ///< [rad/s, m/s]
  double torque_noise = 2e-3;    ///< as a share of the effort limit
  double torque_delay = 0.0;     ///< time by which the torques are late [s]
  double velocity_delay = 0.0;   ///< time by which the velocities are late [s]
  bool velocities = true;
};

/// A smooth random motion inside the limits: per joint a sum of five sines about a centre.
class SmoothMotion {
 public:
  SmoothMotion(const RobotModel& model, unsigned seed) {
    std::mt19937 generator(seed);
    for (int j = 0; j < model.n(); ++j) {
      const JointLimits& limits = model.joints[static_cast<std::size_t>(j)].limits;
      const double half = limits.has_position ? 0.5 * (limits.upper - limits.lower) : M_PI;
      const double middle = limits.has_position ? 0.5 * (limits.upper + limits.lower) : 0.0;
      const double size = std::min({0.8, 0.7 * half, 0.25 * limits.velocity});
      center_.push_back(middle + random_number(generator, -0.2, 0.2) * half);
      for (int k = 0; k < kSines; ++k) {
        frequency_.push_back(2.0 * M_PI * (0.08 + 0.1 * k + random_number(generator, 0.0, 0.08)));
        amplitude_.push_back(size * random_number(generator, 0.4, 1.0) / (1.0 + k));
        phase_.push_back(random_number(generator, 0.0, 2.0 * M_PI));
      }
    }
  }

  void at(double t, JointVector& q, JointVector& qd, JointVector& qdd) const {
    const auto n = static_cast<Eigen::Index>(center_.size());
    for (JointVector* x : {&q, &qd, &qdd}) x->setZero(n);
    for (Eigen::Index j = 0; j < n; ++j) {
      q[j] = center_[static_cast<std::size_t>(j)];
      for (int k = 0; k < kSines; ++k) {
        const auto i = static_cast<std::size_t>(j * kSines + k);
        const double w = frequency_[i];
        q[j] += amplitude_[i] * std::sin(w * t + phase_[i]);
        qd[j] += amplitude_[i] * w * std::cos(w * t + phase_[i]);
        qdd[j] -= amplitude_[i] * w * w * std::sin(w * t + phase_[i]);
      }
    }
  }

 private:
  static constexpr int kSines = 5;
  std::vector<double> center_, frequency_, amplitude_, phase_;
};

/// Records the motion of `arm`, whose limits are those of `model`.
inline JointLog recorded(const RobotModel& model, const Chain& arm, const Recording& how = {}) {
  const SmoothMotion motion(model, how.seed);
  std::mt19937 generator(how.seed + 1000);
  std::normal_distribution<double> normal;
  const auto samples = static_cast<Eigen::Index>(how.rate * how.duration);
  const int n = model.n();
  JointLog log;
  log.source = "recorded";
  log.q.resize(samples, n);
  log.torque.resize(samples, n);
  if (how.velocities) log.qd.resize(samples, n);
  JointVector q, qd, qdd, torque;
  Poses poses;
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / how.rate;
    log.time.push_back(t);
    motion.at(t - how.torque_delay, q, qd, qdd);
    forward_kinematics(arm, q, poses);
    inverse_dynamics(arm, poses, qd, qdd, torque);
    for (int j = 0; j < n; ++j)
      log.torque(i, j) = torque[j] + how.torque_noise * normal(generator) *
                                         model.joints[static_cast<std::size_t>(j)].limits.effort;
    if (how.velocities) {
      motion.at(t - how.velocity_delay, q, qd, qdd);
      for (int j = 0; j < n; ++j) log.qd(i, j) = qd[j] + how.velocity_noise * normal(generator);
    }
    motion.at(t, q, qd, qdd);
    for (int j = 0; j < n; ++j) log.q(i, j) = q[j] + how.position_noise * normal(generator);
  }
  return log;
}

/// The bundled arms that the laws are tested on, with friction and rotor inertia in the model.
inline RobotModel validation_arm(const std::string& name) {
  RobotModel model = *load_robot(name);
  for (int j = 0; j < model.n(); ++j) {
    const double effort = model.joints[static_cast<std::size_t>(j)].limits.effort;
    model.chain.coulomb_friction[j] = 0.02 * effort;
    model.chain.viscous_friction[j] = 0.01 * effort;
  }
  return model;
}

inline Misfit misfit_of(const RobotModel& model, const JointLog& log) {
  return misfit_causes(model, torque_rows(model, joint_motion(model, log)));
}

/// Returns the only cause of a kind for a joint, or fails.
inline MisfitCause cause_of(const Misfit& misfit, CauseKind kind, int joint) {
  for (const MisfitCause& cause : misfit.causes) {
    if (cause.kind == kind && cause.joint == joint) return cause;
  }
  ADD_FAILURE() << "cause " << static_cast<int>(kind) << " of joint " << joint << " was not found";
  return {};
}

inline bool has_finding(const std::vector<LogFinding>& findings, LogFindingKind kind, int joint = -1) {
  for (const LogFinding& finding : findings) {
    if (finding.kind == kind && (joint < 0 || finding.joint == joint)) return true;
  }
  return false;
}

inline std::vector<LogFinding> findings_of(const RobotModel& model, const JointLog& log) {
  return validate_torques(model, log).findings;
}

}  // namespace armtune::internal::test

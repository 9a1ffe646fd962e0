#pragma once
// Logs of simulated arms that follow commands, as they would be recorded without noise.

#include <functional>

#include "core/control/laws/joint_drives.hpp"
#include "sim/plant/plant.hpp"
#include "tests/tuner/validation/validation_rig.hpp"
#include "tuner/validation/motion_validation.hpp"

namespace armtune::internal::test {

struct CommandedLog {
  JointLog log;  ///< without torques
  MotionCommands commands;
  std::vector<JointVector> first_torque;  ///< that acted at the beginning of each period
};

/// Time between samples and between commands, and steps of the simulated arm in it.
inline constexpr double kLogPeriod = 0.004;
inline constexpr int kPlantSteps = 4;
/// The servo of the simulated position interface.
inline constexpr ServoGains kLogServo{300.0, 0.1};

/// Computes the torque of the step `k` of a period of log sample `i`, and the command of that sample (step
/// 0).
using TorqueSource =
    std::function<JointVector(Eigen::Index i, int k, const JointState& state, JointVector& command)>;

/// Moves an arm from the start of a smooth motion and records it.
inline CommandedLog record_motion(const RobotModel& arm, const SmoothMotion& motion, double duration,
                                  CommandKind kind, const TorqueSource& source) {
  CommandedLog out;
  out.log.source = "recorded";
  const auto samples = static_cast<Eigen::Index>(duration / kLogPeriod);
  for (Eigen::MatrixXd* x : {&out.log.q, &out.log.qd, &out.commands.value}) x->resize(samples, arm.n());
  out.commands.kind = kind;
  const std::unique_ptr<Plant> plant = make_native_plant(arm, Stepper::kMidpoint);
  JointState state;
  JointVector qdd, command, torque;
  motion.at(0.0, state.q, state.qd, qdd);
  plant->set_state(state.q, state.qd);
  for (Eigen::Index i = 0; i < samples; ++i) {
    out.log.time.push_back(static_cast<double>(i) * kLogPeriod);
    out.log.q.row(i) = plant->q();
    out.log.qd.row(i) = plant->qd();
    for (int k = 0; k < kPlantSteps; ++k) {
      state = {plant->q(), plant->qd()};
      torque = source(i, k, state, command);
      if (k == 0) {
        out.commands.value.row(i) = command;
        out.first_torque.push_back(torque);
      }
      plant->step(torque, kLogPeriod / kPlantSteps);
    }
  }
  out.commands.time = out.log.time;
  return out;
}

/// An arm under torque commands: inverse dynamics of the model along the motion, and a PD on the errors.
inline CommandedLog moved_by_torques(const RobotModel& model, const RobotModel& arm, double duration = 20.0) {
  const SmoothMotion motion(model, 1);
  JointVector held;
  return record_motion(arm, motion, duration, CommandKind::kTorque,
                       [&](Eigen::Index i, int k, const JointState& state, JointVector& command) {
                         if (k > 0) return held;
                         JointVector q, qd, qdd;
                         motion.at(static_cast<double>(i) * kLogPeriod, q, qd, qdd);
                         qdd += 100.0 * (q - state.q) + 20.0 * (qd - state.qd);
                         const Poses poses = poses_at(model.chain, state.q);
                         inverse_dynamics(model.chain, poses, qd, qdd, command);
                         const JointVector effort = arm.effort_limits();
                         command = command.cwiseMax(-effort).cwiseMin(effort);
                         return held = command;
                       });
}

/// An arm whose drives follow velocity or position commands.
inline CommandedLog moved_by_drives(const RobotModel& model, const RobotModel& arm, CommandKind kind,
                                    double duration = 20.0) {
  const SmoothMotion motion(model, 1);
  const DriveTiming timing{kPlantSteps / kLogPeriod, 0};
  JointDrives drives = kind == CommandKind::kVelocity
                           ? JointDrives(arm, kLogPeriod, timing)
                           : JointDrives(arm, kLogPeriod, timing, kLogServo, kDrivePositionGain);
  const JointVector effort = arm.effort_limits();
  CommandedLog out = record_motion(arm, motion, duration, kind,
                                   [&](Eigen::Index i, int k, const JointState& state, JointVector& command) {
                                     if (k == 0) {
                                       JointVector q, qd, qdd, weight;
                                       motion.at(static_cast<double>(i) * kLogPeriod, q, qd, qdd);
                                       command = kind == CommandKind::kVelocity ? qd : q;
                                       gravity_torque(arm.chain, poses_at(arm.chain, state.q), weight);
                                       drives.begin(command, state, weight);
                                     }
                                     JointVector torque;
                                     drives.torque(state, torque);
                                     return JointVector(torque.cwiseMax(-effort).cwiseMin(effort));
                                   });
  if (kind == CommandKind::kPosition) out.commands.servo = kLogServo;
  return out;
}

}  // namespace armtune::internal::test

#pragma once
// The complete controller: state machine, references of the active state, adaptive torque law
//   tau = -Kd S + Y theta (+ repulsion), saturated at the effort limits (equation 6).

#include <memory>
#include <span>

#include "core/control/adaptation.hpp"
#include "core/control/cartesian_law.hpp"
#include "core/control/gains.hpp"
#include "core/control/gaze_control.hpp"
#include "core/control/state_machine.hpp"
#include "core/control/task_goal.hpp"
#include "core/robot/robot_model.hpp"
#include "core/trajectory/harmonic_path.hpp"
#include "core/trajectory/joint_spline.hpp"
#include "core/trajectory/return_trajectory.hpp"

namespace armtune {

/// What the controller measures: n joint positions [rad, m] and velocities.
struct JointState {
  JointVector q;
  JointVector qd;
};

/// What the controller knows of its surroundings in one period, base frame.
struct Scene {
  const HarmonicPath* path = nullptr;  ///< the tool's path, on the simulation's own time
  MotionPoint<Vec3> target{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< the active gaze target [m]
  std::span<const Vec3> obstacles;                                     ///< obstacle centres [m]
  /// Joint motion to begin with, on the simulation's own time; null: leaveSingularity. The same in every
  /// period.
  const JointSpline* plan = nullptr;
};

/// Everything a recorder wants to see of one period.
struct ControlOutput {
  JointVector torque;     ///< what goes to the joints, inside the effort limits [N m, N]
  JointVector commanded;  ///< before saturation
  bool saturated = false;
  ControlState state = ControlState::kLeaveSingularity;
  bool slerping = false;
  MotionPoint<Vec3> desired;         ///< linear reference (the tool's own position in avoidObstacles)
  OrientationPoint desired_gaze;     ///< orientation reference; identity before a state tracks one
  CartesianErrors errors;            ///< as the law saw them; zero in states that track joints
  MotionPoint<JointVector> planned;  ///< qd, qd', qd'' of followPlan; empty if it never was
  JointReference reference;          ///< qr', qr''
  JointVector S;                     ///< q' - qr'
  double manipulability = 0.0;
  bool damped = false;
  double obstacle_distance = 0.0;  ///< [m], infinite without obstacles
  double pace = 1.0;               ///< sigma of the velocity governor: rate at which interpolations go on
};

class Controller {
 public:
  /// gains must be valid for the model (see validate). theta (13 n): start of the adaptation. period: control
  /// period [s].
  Controller(std::shared_ptr<const RobotModel> model, const Gains& gains, const ParameterVector& theta,
             double period);
  Controller(const Controller&) = delete;  // the inverse refers to this object's Jacobian
  Controller& operator=(const Controller&) = delete;

  /// One control period. Allocates nothing. The reference is valid until the next call.
  const ControlOutput& update(const JointState& measured, const Scene& scene, double time);

  const ParameterVector& theta() const { return adaptation_.theta(); }
  const Gains& gains() const { return gains_; }

 private:
  void enter_state(const Scene& scene, double time);
  void follow_joint_trajectory(const JointState& measured, const Scene& scene, double time);
  void follow_plan(const JointState& measured, const Scene& scene, double time);
  void follow_task(const JointState& measured, const Scene& scene, double time);
  MotionPoint<Vec3> desired_motion(const Scene& scene, double time) const;
  std::optional<GazeControl::SpeedBound> speed_bound() const;
  void keep_pace(const Scene& scene, double time);
  void torque(const JointState& measured, const Scene& scene);
  void adapt();

  std::shared_ptr<const RobotModel> model_;
  Gains gains_;
  JointVector goal_;  ///< joint_space_goal [rad, m]
  JointVector effort_limits_;
  JointVector velocity_limits_;
  JointVector velocity_bound_;  ///< of the governor
  InverseDamping damping_;
  double period_;

  bool started_ = false;
  JointVector q_start_;
  GazeControl gaze_;
  Adaptation adaptation_;
  Quintic<Vec3> return_{
      {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, 1.0};
  double return_start_ = 0.0;
  double lag_ = 0.0;  ///< interpolations run on time - lag_ [s]: zero unless the governor slows them
  TaskGoal task_goal_;
  Vec6 integral_ = Vec6::Zero();

  Poses poses_;
  Jacobian J_;
  Jacobian J_dot_;
  Vec6 twist_ = Vec6::Zero();  ///< measured (v_0T, w_0T)
  TaskInverse inverse_;
  SlotineLi motion_;
  JointVector Kd_;  ///< of the active law
  JointVector scratch_;
  ControlOutput out_;
};

}  // namespace armtune

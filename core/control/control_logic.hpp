#pragma once
// Makes the decisions of a controller in every control period: its state, the motion that it tracks, its
// gains, by how much references that are too fast are slowed down, and the limits of its torques. The
// decisions are made for each arm separately. The numerical work between them is done elsewhere: for one arm
// in core/control/laws/controller.hpp, and for several arms at once in sim/lanes.

#include <memory>
#include <optional>

#include "core/control/control_output.hpp"
#include "core/control/gains.hpp"
#include "core/control/gaze_control.hpp"
#include "core/control/roll_centering.hpp"
#include "core/control/task_goal.hpp"
#include "core/robot/robot_model.hpp"
#include "core/trajectory/return_trajectory.hpp"

namespace armtune::internal {

/// The quantities of the measured arm that every period needs.
struct ArmView {
  Mat3 R_0T = Mat3::Identity();
  Vec3 p_0T = Vec3::Zero();
  Vec6 twist = Vec6::Zero();  ///< (v_0T, w_0T)
  double manipulability = 0.0;
  bool damped = false;
  double obstacle_distance = 0.0;  ///< [m], infinite without obstacles
  /// The complete measured arm. If null, it is computed from the joints when a decision needs it.
  const MeasuredArm* whole = nullptr;
};

class ControlLogic {
 public:
  /// gains must be valid for the model (see validate). period: control period [s]. mask: the components of
  /// the tool's motion that the task prescribes.
  ControlLogic(std::shared_ptr<const RobotModel> model, const Gains& gains, double period,
               TaskMask mask = TaskMask::kPose);

  /// First step of a period: decides the state and the motion to track. Returns true if the caller must still
  /// compute the joint reference from `task_reference()`, false if it is already in the output.
  bool decide(const JointState& measured, const ArmView& arm, const Scene& scene, double time);
  const TaskReference& task_reference() const { return task_reference_; }

  /// Second step, after the joint reference is in the output: slows this reference down to velocities that
  /// the joints can follow.
  void keep_pace(const Scene& scene, double time);
  /// True if keep_pace acts in this period. If false, keep_pace does not need the joint reference.
  bool keeps_pace() const;

  /// Returns Kd of the active state (n) [N m s/rad].
  const JointVector& Kd() const { return Kd_; }

  /// Third step, after the law's torque is in ControlOutput::commanded: adds the repulsion of obstacles and
  /// the torque of the velocity barrier, and applies the effort limits.
  void limit_torque(const JointState& measured, const ArmView& arm, const Scene& scene);
  /// Last step: advances the integral of the pose error, unless a joint is saturated or a slerp is under way.
  /// Returns true if the law may adapt its model now.
  bool conclude();

  const ControlOutput& output() const { return out_; }
  ControlOutput& output() { return out_; }
  const Gains& gains() const { return gains_; }
  const InverseDamping& damping() const { return damping_; }
  TaskMask mask() const { return mask_; }
  const JointCentering& centering() const { return centering_; }
  const RobotModel& model() const { return *model_; }
  double period() const { return period_; }

 private:
  const MeasuredArm& whole(const JointState& measured, const ArmView& arm);
  void enter_state(const JointState& measured, const ArmView& arm, const Scene& scene, double time);
  void follow_joint_trajectory(const JointState& measured, const ArmView& arm, const Scene& scene,
                               double time);
  void follow_plan(const JointState& measured, const ArmView& arm, const Scene& scene, double time);
  void follow_task(const JointState& measured, const ArmView& arm, const Scene& scene, double time);
  ToolAim aim(const Scene& scene) const;
  MotionPoint<Vec3> desired_motion(const ArmView& arm, const Scene& scene, double time) const;

  std::shared_ptr<const RobotModel> model_;
  Gains gains_;
  JointVector goal_;  ///< joint_space_goal [rad, m]
  JointVector effort_limits_;
  JointVector velocity_limits_;
  JointVector velocity_bound_;  ///< bound of the governor [rad/s, m/s]
  InverseDamping damping_;
  TaskMask mask_;
  JointCentering centering_;
  RollCentering roll_;
  double period_;

  bool started_ = false;
  JointVector q_start_;
  GazeControl gaze_;
  Quintic<Vec3> return_{
      {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, 1.0};
  double return_start_ = 0.0;
  double lag_ = 0.0;  ///< interpolations use time - lag_ [s]; lag_ is zero until the governor slows them
  TaskGoal task_goal_;
  Vec6 integral_ = Vec6::Zero();
  TaskReference task_reference_;
  JointVector Kd_;
  JointVector bypassing_;  ///< torque that does not come from the reference
  MeasuredArm spare_;      ///< used if an ArmView has no `whole`
  bool spare_is_now_ = false;
  ControlOutput out_;
};

}  // namespace armtune::internal

#pragma once
// What a control period decides: the state, what it tracks, its gains, pace and limits. The arithmetic
// between the decisions is the same whatever they are, so it can be done for one arm or for several side by
// side; what is decided for one arm concerns no other.

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

/// The measured arm as every period looks at it.
struct ArmView {
  Mat3 R_0T = Mat3::Identity();
  Vec3 p_0T = Vec3::Zero();
  Vec6 twist = Vec6::Zero();  ///< (v_0T, w_0T)
  double manipulability = 0.0;
  bool damped = false;
  double obstacle_distance = 0.0;  ///< [m], infinite without obstacles
  /// The whole of it; null: computed from the joints where a decision needs it.
  const MeasuredArm* whole = nullptr;
};

class ControlLogic {
 public:
  /// gains must be valid for the model (see validate). period: control period [s]. mask: the part of the
  /// tool's motion that is the task.
  ControlLogic(std::shared_ptr<const RobotModel> model, const Gains& gains, double period,
               TaskMask mask = TaskMask::kPose);

  /// First in a period: its state and what that tracks. True: the joint reference is what `task_reference()`
  /// resolves to; otherwise it is in the output already.
  bool decide(const JointState& measured, const ArmView& arm, const Scene& scene, double time);
  const TaskReference& task_reference() const { return task_reference_; }

  /// Then, with the joint reference in the output: it slows down to what the joints can do.
  void keep_pace(const Scene& scene, double time);
  /// False: keep_pace does nothing in this period, and nobody here needs the joint reference.
  bool keeps_pace() const;

  /// Of the active law (n) [N m s/rad].
  const JointVector& Kd() const { return Kd_; }

  /// Then, with the law's torque as the commanded one in the output: repulsion, barrier, effort limits.
  void limit_torque(const JointState& measured, const ArmView& arm, const Scene& scene);
  /// Last: the integral goes on. True: so does what the law learns.
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
  JointVector velocity_bound_;  ///< of the governor
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
  double lag_ = 0.0;  ///< interpolations run on time - lag_ [s]: zero unless the governor slows them
  TaskGoal task_goal_;
  Vec6 integral_ = Vec6::Zero();
  TaskReference task_reference_;
  JointVector Kd_;
  JointVector bypassing_;  ///< torque that does not come from the reference
  MeasuredArm spare_;      ///< where an ArmView has no whole
  bool spare_is_now_ = false;
  ControlOutput out_;
};

}  // namespace armtune::internal

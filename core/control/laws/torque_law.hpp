#pragma once
// A torque law is the part of a controller that computes joint torques from the measured arm and the
// references. All controllers share the rest: the states, the references, pointing at a target (gaze),
// returns to the path, obstacle avoidance, the velocity governor and the limits
// (core/control/control_logic.hpp).

#include "core/control/control_output.hpp"
#include "core/control/gains.hpp"
#include "core/control/laws/joint_drives.hpp"
#include "core/control/measured_arm.hpp"
#include "core/control/task_mask.hpp"
#include "core/robot/robot_model.hpp"
#include "core/robot/slotine_li.hpp"

namespace armtune::internal {

/// The data that a law is constructed from. model and gains outlive the law. theta does not outlive the law
/// and must be copied; the constructor of TorqueLaw does this.
struct LawSetup {
  const RobotModel& model;
  const Gains& gains;
  const ParameterVector& theta;  ///< (13 n), of the controller's model of the arm (core/robot/theta.hpp)
  double period;                 ///< control period [s]
  TaskMask mask;
  DriveTiming drives = {};  ///< used by laws that command velocities or positions
};

/// The inputs of a law in one control period.
struct LawInput {
  const JointState& measured;    ///< q, q' (n) [rad, m; /s]
  const MeasuredArm& arm;        ///< poses, J, its inverse; J' in states that track the tool
  const ControlOutput& control;  ///< state, errors, qr', qr'' and S = q' - qr' (n)
  const JointVector& Kd;         ///< of the active state (n) [N m s/rad]: joint_space_gains_d in states that
                                 ///< track joints and for laws without task_space_gains_d
  const Scene& scene;            ///< its plan is used in states that follow a joint motion
  double time;                   ///< [s]
};

class TorqueLaw {
 public:
  explicit TorqueLaw(const LawSetup& setup) : chain_(setup.model.chain), theta_(setup.theta) {}
  TorqueLaw(const TorqueLaw&) = delete;
  TorqueLaw& operator=(const TorqueLaw&) = delete;
  virtual ~TorqueLaw() = default;

  /// Computes the torques (n) [N m, N]. The repulsion of obstacles, the velocity barrier and the effort
  /// limits are applied to them afterwards. Allocates nothing.
  virtual void torque(const LawInput& in, JointVector& tau) = 0;
  /// Returns the drives of a robot that takes velocities or positions; null if the law commands torques. If
  /// there are drives, torque() begins a control period of them and returns the torques of their first
  /// period. The caller computes those of their other periods.
  virtual JointDrives* drives() { return nullptr; }
  /// Is called at the end of every period. learning: true if no joint was saturated and adaptation is wanted.
  virtual void conclude(bool /*learning*/) {}

  /// Returns the parameters of the law's present model of the arm (13 n).
  virtual const ParameterVector& theta() const { return theta_; }
  /// True if every torque contains -Kd S.
  virtual bool contains_Kd() const { return false; }
  /// Returns the motion of the bodies that belongs to q', qr' and qr'' of the last period. The regressor Y is
  /// computed from it. Null if the law has no regressor.
  virtual const SlotineLi* references_motion() const { return nullptr; }

 protected:
  /// Computes M(q) a + C(q, q') v + g(q) + friction(q') (n) of the arm that theta describes.
  void model_torque(const MeasuredArm& arm, const JointVector& qd, const JointVector& v, const JointVector& a,
                    JointVector& tau) {
    slotine_li_forward(chain_, arm.poses, qd, v, a, motion_);
    slotine_li_torque(chain_, arm.poses, motion_, theta_, tau);
  }

  const Chain& chain_;
  ParameterVector theta_;
  SlotineLi motion_;
};

}  // namespace armtune::internal

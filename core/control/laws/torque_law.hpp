#pragma once
// What makes a controller: from where the arm is, and what states and references ask of it, to joint torques.
// States, references, gaze, returns, obstacles, the governor and the limits are those of every controller
// (core/control/control_logic.hpp).

#include "core/control/control_output.hpp"
#include "core/control/gains.hpp"
#include "core/control/measured_arm.hpp"
#include "core/control/task_mask.hpp"
#include "core/robot/robot_model.hpp"
#include "core/robot/slotine_li.hpp"

namespace armtune::internal {

/// What a law is made from. model and gains outlive it; theta does not: it is to be copied, as TorqueLaw
/// does.
struct LawSetup {
  const RobotModel& model;
  const Gains& gains;
  const ParameterVector& theta;  ///< (13 n), what the controller takes the arm for (core/robot/theta.hpp)
  double period;                 ///< of control [s]
  TaskMask mask;
};

/// One control period as a law sees it.
struct LawInput {
  const JointState& measured;    ///< q, q' (n) [rad, m; /s]
  const MeasuredArm& arm;        ///< poses, J, its inverse; J' in states that track the tool
  const ControlOutput& control;  ///< state, errors, qr', qr'' and S = q' - qr' (n)
  const JointVector& Kd;         ///< of the active state (n) [N m s/rad]: joint_space_gains_d in states that
                                 ///< track joints and for laws without task_space_gains_d
  const Scene& scene;            ///< its plan, where a joint motion is followed
  double time;                   ///< [s]
};

class TorqueLaw {
 public:
  explicit TorqueLaw(const LawSetup& setup)
      : chain_(setup.model.chain), theta_(setup.theta), rest_(JointVector::Zero(setup.model.n())) {}
  TorqueLaw(const TorqueLaw&) = delete;
  TorqueLaw& operator=(const TorqueLaw&) = delete;
  virtual ~TorqueLaw() = default;

  /// The torques (n) [N m, N] before repulsion, velocity barrier and effort limits. Allocates nothing.
  virtual void torque(const LawInput& in, JointVector& tau) = 0;
  /// The period is over. learning: no joint was saturated, and adaptation is wanted.
  virtual void conclude(bool /*learning*/) {}

  /// What the law takes the arm for now (13 n).
  virtual const ParameterVector& theta() const { return theta_; }
  /// Returns true if every torque contains -Kd S.
  virtual bool contains_Kd() const { return false; }
  /// Y of the last period's q', qr', qr'', if the law has it.
  virtual const SlotineLi* references_motion() const { return nullptr; }

 protected:
  /// M(q) a + C(q, q') v + g(q) + friction(q') (n) of the arm that theta describes.
  void model_torque(const MeasuredArm& arm, const JointVector& qd, const JointVector& v, const JointVector& a,
                    JointVector& tau) {
    slotine_li_forward(chain_, arm.poses, qd, v, a, motion_);
    slotine_li_torque(chain_, arm.poses, motion_, theta_, tau);
  }
  /// g(q) (n) of the arm that theta describes.
  void gravity_torque(const MeasuredArm& arm, JointVector& tau) {
    model_torque(arm, rest_, rest_, rest_, tau);
  }

  const Chain& chain_;
  ParameterVector theta_;
  SlotineLi motion_;

 private:
  JointVector rest_;  ///< zeros
};

}  // namespace armtune::internal

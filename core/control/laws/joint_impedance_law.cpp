#include "core/control/laws/joint_impedance_law.hpp"

#include "core/control/laws/desired_joints.hpp"
#include "core/control/laws/first_gains.hpp"
#include "core/robot/theta.hpp"

namespace armtune::internal {
namespace {

class JointImpedanceLaw final : public TorqueLaw {
 public:
  explicit JointImpedanceLaw(const LawSetup& setup)
      : TorqueLaw(setup),
        k_(own(setup.gains, "joint_impedance_k")),
        d_(own(setup.gains, "joint_impedance_d")),
        coriolis_factor_(own(setup.gains, "joint_impedance_coriolis_factor")[0]),
        filter_(own(setup.gains, "joint_impedance_filter")[0]),
        largest_step_(own(setup.gains, "joint_impedance_torque_rate")[0] * setup.period),
        without_friction_(setup.theta),
        desired_(setup.model.n(), setup.period) {
    const int n = setup.model.n();
    for (JointVector* x : {&rest_, &velocity_, &last_}) x->setZero(n);
    for (int i = 0; i < n; ++i) without_friction_.segment<2>(joint_parameter_index(n, i) + 1).setZero();
  }

  void torque(const LawInput& in, JointVector& tau) override {
    const MotionPoint<JointVector> desired = desired_.next(in);
    const JointVector &q = in.measured.q, &qd = in.measured.qd;
    velocity_ = filter_ * velocity_ + (1.0 - filter_) * qd;
    command_ = k_.cwiseProduct(desired.position - q) + d_.cwiseProduct(desired.velocity - velocity_);
    rigid_torque(in.arm, rest_, tau);
    if (coriolis_factor_ != 0.0) {
      rigid_torque(in.arm, qd, moving_);
      command_ += coriolis_factor_ * (moving_ - tau);
    }
    if (largest_step_ > 0.0)
      command_ = last_ + (command_ - last_).cwiseMax(-largest_step_).cwiseMin(largest_step_);
    last_ = command_;
    tau += command_;
  }

 private:
  /// Computes C(q, v) v + g(q) (n) of the model without friction.
  void rigid_torque(const MeasuredArm& arm, const JointVector& v, JointVector& tau) {
    slotine_li_forward(chain_, arm.poses, v, v, rest_, motion_);
    slotine_li_torque(chain_, arm.poses, motion_, without_friction_, tau);
  }

  JointVector k_, d_;
  double coriolis_factor_;
  double filter_;        ///< share of the last filtered velocity in the next
  double largest_step_;  ///< of the command in a period [N m, N]; 0: any
  ParameterVector without_friction_;
  DesiredJoints desired_;
  JointVector rest_;            ///< zeros
  JointVector velocity_;        ///< filtered q'
  JointVector command_, last_;  ///< without gravity
  JointVector moving_;
};

}  // namespace

ControllerKind joint_impedance_controller() {
  constexpr auto kJoints = GainShape::kJoints;
  constexpr auto kScalar = GainShape::kScalar;
  GainField filter = not_tuned(own_gain(kScalar, "joint_impedance_filter", "",
                                        "share of the last filtered joint velocity in the next; 0: the "
                                        "velocity is not filtered",
                                        0.01));
  filter.below = 1.0;
  return {
      kJointImpedance,
      "joint impedance: g(q) + k (qd - q) + d (qd' - q') for each joint along a joint trajectory, as in the "
      "examples for Franka's arms",
      {},
      {own_gain(kJoints, "joint_impedance_k", "N m/rad", "stiffness k of each joint", 100.0),
       own_gain(kJoints, "joint_impedance_d", "N m s/rad", "damping d of each joint", 10.0),
       not_tuned(own_gain(kScalar, "joint_impedance_coriolis_factor", "",
                          "factor of the Coriolis and centrifugal torques that the controller adds", 1.0)),
       filter,
       not_tuned(own_gain(kScalar, "joint_impedance_torque_rate", "N m/s",
                          "largest change of each commanded torque per second; 0: no limit", 0.0))},
      [](const LawSetup& setup) { return std::make_unique<JointImpedanceLaw>(setup); },
      [](const RobotModel& robot, const JointVector& q, Gains& gains) {
        critically_damped(robot, q, own(gains, "joint_impedance_k"), own(gains, "joint_impedance_d"));
        without_velocity_limits(gains);
      }};
}

}  // namespace armtune::internal

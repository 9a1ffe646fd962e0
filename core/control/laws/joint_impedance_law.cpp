#include "core/control/laws/joint_impedance_law.hpp"

#include "core/control/laws/desired_joints.hpp"
#include "core/control/laws/first_gains.hpp"
#include "core/control/laws/rigid_torque.hpp"
#include "core/control/laws/torque_rate.hpp"

namespace armtune::internal {
namespace {

class JointImpedanceLaw final : public TorqueLaw {
 public:
  explicit JointImpedanceLaw(const LawSetup& setup)
      : TorqueLaw(setup),
        k_(own(setup.gains, "joint_impedance_k")),
        d_(own(setup.gains, "joint_impedance_d") +
           2.0 * own(setup.gains, "joint_impedance_damping_ratio").cwiseProduct(k_.cwiseSqrt())),
        velocity_factor_(own(setup.gains, "joint_impedance_velocity_factor")[0]),
        coriolis_factor_(own(setup.gains, "joint_impedance_coriolis_factor")[0]),
        filter_(own(setup.gains, "joint_impedance_filter")[0]),
        rate_(setup.model.n(), own(setup.gains, "joint_impedance_torque_rate")[0], setup.period),
        rigid_(setup.model.chain, setup.theta),
        desired_(setup.model.n(), setup.period),
        velocity_(JointVector::Zero(setup.model.n())) {}

  void torque(const LawInput& in, JointVector& tau) override {
    const MotionPoint<JointVector> desired = desired_.next(in);
    const JointVector &q = in.measured.q, &qd = in.measured.qd;
    velocity_ = filter_ * velocity_ + (1.0 - filter_) * qd;
    command_ = k_.cwiseProduct(desired.position - q) +
               d_.cwiseProduct(velocity_factor_ * desired.velocity - velocity_);
    rigid_.at_rest(in.arm, tau);
    if (coriolis_factor_ != 0.0) {
      rigid_.moving(in.arm, qd, moving_);
      command_ += coriolis_factor_ * (moving_ - tau);
    }
    rate_.limit(command_);
    tau += command_;
  }

 private:
  JointVector k_, d_;
  double velocity_factor_, coriolis_factor_;
  double filter_;  ///< share of the last filtered velocity in the next
  TorqueRate rate_;
  RigidTorque rigid_;
  DesiredJoints desired_;
  JointVector velocity_;  ///< filtered q'
  JointVector command_;   ///< without gravity
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
  GainField ratio =
      root_in_loop(own_gain(kJoints, "joint_impedance_damping_ratio", "",
                            "damping ratio r of each joint: adds 2 r sqrt(k) to its damping d", 0.0));
  ratio.search = SearchRange::kNone;  // most controllers have none
  return {
      kJointImpedance,
      "joint impedance: g(q) + k (qd - q) + d (qd' - q') for each joint along a joint trajectory, as in the "
      "examples for Franka's arms",
      {},
      {bounded(own_gain(kJoints, "joint_impedance_k", "N m/rad", "stiffness k of each joint", 100.0)),
       own_gain(kJoints, "joint_impedance_d", "N m s/rad", "damping d of each joint", 10.0), ratio,
       not_tuned(own_gain(
           kScalar, "joint_impedance_velocity_factor", "",
           "share c of the desired velocity in the damping torque d (c qd' - q'); 1: damps the velocity "
           "error, 0: the whole velocity",
           1.0)),
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

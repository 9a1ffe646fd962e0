#include "core/control/laws/cartesian_impedance_law.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "core/control/laws/first_gains.hpp"
#include "core/control/laws/rigid_torque.hpp"
#include "core/control/laws/torque_rate.hpp"
#include "core/trajectory/rotation.hpp"

namespace armtune::internal {
namespace {

/// Damping of the pseudo-inverse for the null space: the square of 0.2, as in the source (see the header).
constexpr double kNullSpaceDamping = 0.04;
/// The law has no integral, so the stiffness alone resists errors of the model.
constexpr double kFirstStiffRate = 40.0;  // 1/s

class CartesianImpedanceLaw final : public TorqueLaw {
 public:
  explicit CartesianImpedanceLaw(const LawSetup& setup)
      : TorqueLaw(setup),
        K_(own(setup.gains, "cartesian_impedance_k")),
        D_(own(setup.gains, "cartesian_impedance_damping") +
           2.0 * own(setup.gains, "cartesian_impedance_damping_ratio").cwiseProduct(K_.cwiseSqrt())),
        nullspace_k_(own(setup.gains, "cartesian_impedance_nullspace_k")[0]),
        filter_(own(setup.gains, "cartesian_impedance_filter")[0]),
        rate_(setup.model.n(), own(setup.gains, "cartesian_impedance_torque_rate")[0], setup.period),
        rigid_(setup.model.chain, setup.theta) {}

  void torque(const LawInput& in, JointVector& tau) override {
    const ControlOutput& control = in.control;
    const JointVector &q = in.measured.q, &qd = in.measured.qd;
    rigid_.at_rest(in.arm, tau);
    if (tracks_joints(control.state)) {
      model_torque(in.arm, qd, control.reference.velocity, control.reference.acceleration, command_);
      command_ -= in.Kd.cwiseProduct(control.S) + tau;
      rate_.follow(command_);
      tracks_tool_ = false;
    } else {
      if (!tracks_tool_) begin(in);
      follow(in);
      take_task(in.arm);
      free_ = nullspace_k_ * (posture_ - q) - 2.0 * std::sqrt(nullspace_k_) * qd;
      command_ = free_ - J_.transpose() * solver_.solve(J_ * free_);
      const Vec6 force = K_.cwiseProduct(in.arm.inverse.of_task(error_)) +
                         D_.cwiseProduct(in.arm.inverse.of_task(in.arm.twist));
      rigid_.moving(in.arm, qd, moving_);
      command_ += moving_ - tau - J_.transpose() * force;
      rate_.limit(command_);
    }
    tau += command_;
  }

 private:
  void begin(const LawInput& in) {
    posture_ = in.measured.q;
    position_ = in.arm.poses.p_0T;
    orientation_ = in.arm.poses.R_0T;
    tracks_tool_ = true;
  }

  /// Filters the desired pose and computes the tool's error e from it.
  void follow(const LawInput& in) {
    const Vec6& error = in.control.errors.pose;
    const Eigen::Quaterniond measured(in.arm.poses.R_0T);
    const Eigen::Quaterniond desired = rotation_exp(-error.tail<3>()) * measured;
    position_ = filter_ * position_ + (1.0 - filter_) * (in.arm.poses.p_0T - error.head<3>());
    orientation_ = orientation_.slerp(1.0 - filter_, desired);
    const Eigen::Quaterniond turn = orientation_ * measured.conjugate();
    error_.head<3>() = in.arm.poses.p_0T - position_;
    error_.tail<3>() = (turn.w() < 0.0 ? 1.0 : -1.0) * turn.vec();
  }

  /// Computes the task's Jacobian, and factorises J J^T + 0.04.
  void take_task(const MeasuredArm& arm) {
    J_.resize(6, arm.J.cols());
    for (Eigen::Index i = 0; i < J_.cols(); ++i) J_.col(i) = arm.inverse.of_task(arm.J.col(i));
    Eigen::Matrix<double, 6, 6> A = J_.lazyProduct(J_.transpose());
    A.diagonal().array() += kNullSpaceDamping;
    solver_.compute(A);
  }

  Vec6 K_, D_;
  double nullspace_k_;
  double filter_;  ///< share of the last desired pose in the next
  TorqueRate rate_;
  RigidTorque rigid_;
  bool tracks_tool_ = false;
  JointVector posture_;
  Vec3 position_ = Vec3::Zero();
  Eigen::Quaterniond orientation_ = Eigen::Quaterniond::Identity();
  Vec6 error_ = Vec6::Zero();
  Jacobian J_;
  Eigen::LLT<Eigen::Matrix<double, 6, 6>> solver_;
  JointVector command_;  ///< without gravity
  JointVector free_, moving_;
};

/// Sets critically damped gains for each axis of the task, with both poles at kFirstStiffRate. The rotational
/// stiffness acts with half of its value.
void first_impedance(const RobotModel& robot, const JointVector& q, Gains& gains) {
  const Vec6 inertia = task_inertia(robot, q);
  JointVector& K = own(gains, "cartesian_impedance_k");
  JointVector& ratio = own(gains, "cartesian_impedance_damping_ratio");
  for (int axis = 0; axis < 6; ++axis) {
    const double share = axis < 3 ? 1.0 : 0.5;
    K[axis] = kFirstStiffRate * kFirstStiffRate * inertia[axis] / share;
    ratio[axis] = std::sqrt(share * inertia[axis]);
  }
  // With up to six joints no motion is free, but the damped projector would let part of the torque through.
  if (robot.n() <= 6) own(gains, "cartesian_impedance_nullspace_k")[0] = 0.0;
  without_velocity_limits(gains);
}

}  // namespace

ControllerKind cartesian_impedance_controller() {
  constexpr auto kTask = GainShape::kTask;
  constexpr auto kScalar = GainShape::kScalar;
  GainField filter = not_tuned(own_gain(kScalar, "cartesian_impedance_filter", "",
                                        "share of the last filtered desired pose in the next; 0: the desired "
                                        "pose is not filtered",
                                        0.0));
  filter.below = 1.0;
  GainField damping =
      own_gain(kTask, "cartesian_impedance_damping", "N s/m, N m s",
               "damping d of each axis of the task that does not follow from K; to give all damping as "
               "numbers, set the ratio to 0",
               0.0);
  damping.search = SearchRange::kNone;  // most controllers have none
  return {kCartesianImpedance,
          "Cartesian impedance without feed-forward: g(q) + C q' - J^T (K e + D x') and a null space, as in "
          "the examples for Franka's arms",
          {},
          {bounded(own_gain(kTask, "cartesian_impedance_k", "N/m, N m",
                            "stiffness K of each axis of the task; rotations act on sin(angle / 2)", 200.0)),
           root_in_loop(own_gain(kTask, "cartesian_impedance_damping_ratio", "",
                                 "damping ratio r of each axis of the task, D = d + 2 r sqrt(K)", 1.0)),
           damping,
           not_tuned(own_gain(kScalar, "cartesian_impedance_nullspace_k", "N m/rad",
                              "stiffness k of the joint motion that the task leaves free, towards the joint "
                              "positions at the start; its damping is 2 sqrt(k)",
                              10.0)),
           filter,
           not_tuned(own_gain(kScalar, "cartesian_impedance_torque_rate", "N m/s",
                              "largest change of each commanded torque per second; 0: no limit", 0.0))},
          [](const LawSetup& setup) { return std::make_unique<CartesianImpedanceLaw>(setup); },
          first_impedance};
}

}  // namespace armtune::internal

#pragma once
// The interface of control laws that are templates over their scalar type T. They compute one arm with
// T = double, or W arms at once with T = Pack<W> (core/common/pack.hpp). The torques of every arm are
// bit-identical in both cases. Where code for one arm would branch, such a law computes both results and
// selects one of them for each arm (core/common/select.hpp).

#include <memory>

#include "core/common/select.hpp"
#include "core/control/joint_space_law.hpp"
#include "core/control/laws/lane_access.hpp"
#include "core/control/laws/planned_joints.hpp"
#include "core/control/measured_arm.hpp"
#include "core/robot/slotine_li.hpp"

namespace armtune::internal {

/// The laws that exist as such templates.
enum class ArmLawKind {
  kAdaptive,
  kComputedTorque,
  kJointPd,
  kImpedance,
  kJointTrajectory,
  kJointImpedance,
  kCartesianImpedance,
  kJointTrajectoryVelocity,
  kPositionStreaming
};

/// True if the law commands velocities or positions, which the robot's drives follow (joint_drives.hpp).
constexpr bool commands_drives(ArmLawKind kind) {
  return kind == ArmLawKind::kJointTrajectoryVelocity || kind == ArmLawKind::kPositionStreaming;
}

struct JtcNumbers;

/// The inputs of such a law in one control period.
template <typename T>
struct LawPeriodT {
  const ChainT<T>& chain;
  const MeasuredArmT<T>& arm;  ///< its J' is valid only for arms that do not track joints
  const JointVectorT<T>& q;    ///< measured (n)
  const JointVectorT<T>& qd;   ///< measured (n)
  const JointReferenceT<T>& reference;
  const JointVectorT<T>& S;    ///< q' - qr' (n)
  const JointVectorT<T>& Kd;   ///< Kd of the active state (n)
  const Vec6T<T>& pose_error;  ///< dx, for arms that do not track joints
  const PlannedJointsT<T>& planned;
  MaskT<T> tracks_joints;  ///< true if the reference is a joint motion
  MaskT<T> yields;         ///< true if an obstacle's repulsion moves the arm
  T dt;                    ///< control period [s]
};

/// The start values of an arm's law: model parameters and gains.
struct LawNumbers {
  const double* theta;       ///< 13 n
  const double* const* own;  ///< values of each gain that only this kind of controller has
  double adaptation_gain = 0.0;
  double adaptation_leakage = 0.0;  ///< [1/s]
  double inertia_leakage = 0.0;     ///< [1/s]
  double filter_share = 0.0;        ///< filter_share() of the adaptation's filter; 0: no filter
  /// Null unless the controller is ROS's joint_trajectory_controller.
  const JtcNumbers* joint_trajectory = nullptr;
};

template <typename T>
class ArmLawT : protected LaneAccessT<T> {
 public:
  ArmLawT() = default;
  ArmLawT(const ArmLawT&) = delete;
  ArmLawT& operator=(const ArmLawT&) = delete;
  virtual ~ArmLawT() = default;

  /// Starts the law of one arm. lane: the arm's place in T (0 for a single arm).
  virtual void start(int lane, const LawNumbers& numbers) = 0;
  /// Sets tau (n): the torques, or the command of the drives if commands_drives() is true. Allocates nothing.
  virtual void torque(const LawPeriodT<T>& at, JointVectorT<T>& tau) = 0;
  /// Computes the torque (n) that holds the weight of the arm that theta() describes. Drives need it. Laws
  /// without a fixed model of the arm do nothing here. Allocates nothing.
  virtual void weigh(const LawPeriodT<T>& /*at*/, JointVectorT<T>& /*weight*/) {}
  /// Is called at the end of every period, after torque(). learning: true for arms that may adapt now,
  /// because no joint is saturated and adaptation is wanted.
  virtual void conclude(const LawPeriodT<T>& /*at*/, const MaskT<T>& /*learning*/) {}
  /// Returns the parameters of the law's present model of the arm (13 n).
  virtual ParameterVectorT<T>& theta() = 0;
  /// Returns the motion of the bodies that belongs to q', qr' and qr'' of the last period. The regressor Y is
  /// computed from it. Null if the law has no regressor.
  virtual const SlotineLiT<T>* references_motion() const { return nullptr; }
};

/// Makes a law for arms of n joints. It is defined in make_arm_law.hpp.
template <typename T>
std::unique_ptr<ArmLawT<T>> make_arm_law(ArmLawKind kind, int n);

}  // namespace armtune::internal

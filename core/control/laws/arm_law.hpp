#pragma once
// A control law written once, for one arm (T = double) and for several side by side (T = Pack<W>): every
// arm's torques are, to the bit, those of the arm alone. What is a branch for one arm is a choice between
// results here (core/common/select.hpp).

#include <memory>
#include <type_traits>

#include "core/common/select.hpp"
#include "core/control/joint_space_law.hpp"
#include "core/control/measured_arm.hpp"
#include "core/robot/slotine_li.hpp"

namespace armtune::internal {

/// The laws that are written in this way.
enum class ArmLawKind { kAdaptive, kComputedTorque, kJointPd, kImpedance };

/// One control period as such a law sees it.
template <typename T>
struct LawPeriodT {
  const ChainT<T>& chain;
  const MeasuredArmT<T>& arm;  ///< where J' counts, only in arms that do not track joints
  const JointVectorT<T>& q;    ///< measured (n)
  const JointVectorT<T>& qd;   ///< measured (n)
  const JointReferenceT<T>& reference;
  const JointVectorT<T>& S;    ///< q' - qr' (n)
  const JointVectorT<T>& Kd;   ///< of the active state (n)
  const Vec6T<T>& pose_error;  ///< dx, of arms that do not track joints
  MaskT<T> tracks_joints;      ///< the reference is a joint motion
  MaskT<T> yields;             ///< the arm is to be moved by an obstacle's repulsion
  T dt;                        ///< control period [s]
};

/// What an arm's law starts from.
struct LawNumbers {
  const double* theta;       ///< 13 n
  const double* const* own;  ///< of each of the controller's own gains its numbers
  double adaptation_gain = 0.0;
  double adaptation_leakage = 0.0;  ///< [1/s]
  double inertia_leakage = 0.0;     ///< [1/s]
  double filter_share = 0.0;        ///< of the adaptation's filter; 0: none
};

template <typename T>
class ArmLawT {
 public:
  ArmLawT() = default;
  ArmLawT(const ArmLawT&) = delete;
  ArmLawT& operator=(const ArmLawT&) = delete;
  virtual ~ArmLawT() = default;

  /// Lets the arm in a lane begin (lane 0 of one arm).
  virtual void start(int lane, const LawNumbers& numbers) = 0;
  /// Sets tau (n). Allocates nothing.
  virtual void torque(const LawPeriodT<T>& at, JointVectorT<T>& tau) = 0;
  /// The period of the last torque() is over. learning: no joint was saturated, and adaptation is wanted.
  virtual void conclude(const LawPeriodT<T>& /*at*/, const MaskT<T>& /*learning*/) {}
  /// What the law takes the arm for now (13 n).
  virtual ParameterVectorT<T>& theta() = 0;
  /// Y of the last period's q', qr', qr'', if the law has it.
  virtual const SlotineLiT<T>* references_motion() const { return nullptr; }

 protected:
  static void put([[maybe_unused]] int lane, double value, T& to) {
    if constexpr (std::is_same_v<T, double>) {
      to = value;
    } else {
      to.set(lane, value);
    }
  }
  template <typename Vector>
  static void put_all(int lane, const double* from, Vector& to) {
    for (Eigen::Index i = 0; i < to.size(); ++i) put(lane, from[i], to[i]);
  }
  static MaskT<T> both(const MaskT<T>& a, const MaskT<T>& b) {
    if constexpr (std::is_same_v<MaskT<T>, bool>) {
      return a && b;
    } else {
      return a & b;
    }
  }
  static MaskT<T> either(const MaskT<T>& a, const MaskT<T>& b) {
    if constexpr (std::is_same_v<MaskT<T>, bool>) {
      return a || b;
    } else {
      return a | b;
    }
  }
  static MaskT<T> no(const MaskT<T>& a) {
    if constexpr (std::is_same_v<MaskT<T>, bool>) {
      return !a;
    } else {
      return ~a;
    }
  }
};

/// A law for arms of n joints.
template <typename T>
std::unique_ptr<ArmLawT<T>> make_arm_law(ArmLawKind kind, int n);

}  // namespace armtune::internal

#pragma once
// Control laws that are written once, for one arm (T = double) and for several side by side (T = Pack<W>).
// The torques of every arm are bit-identical to those of the arm alone. What is a branch for one arm is a
// choice between results for several (core/common/select.hpp).

#include <memory>
#include <type_traits>

#include "core/common/select.hpp"
#include "core/control/joint_space_law.hpp"
#include "core/control/measured_arm.hpp"
#include "core/robot/slotine_li.hpp"

namespace armtune::internal {

/// The laws that are written in this form.
enum class ArmLawKind { kAdaptive, kComputedTorque, kJointPd, kImpedance };

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
  MaskT<T> tracks_joints;      ///< true if the reference is a joint motion
  MaskT<T> yields;             ///< true if an obstacle's repulsion moves the arm
  T dt;                        ///< control period [s]
};

/// The values that an arm's law starts with.
struct LawNumbers {
  const double* theta;       ///< 13 n
  const double* const* own;  ///< values of each of the controller's own gains
  double adaptation_gain = 0.0;
  double adaptation_leakage = 0.0;  ///< [1/s]
  double inertia_leakage = 0.0;     ///< [1/s]
  double filter_share = 0.0;        ///< share of the adaptation's filter (filter_share()); 0: no filter
};

template <typename T>
class ArmLawT {
 public:
  ArmLawT() = default;
  ArmLawT(const ArmLawT&) = delete;
  ArmLawT& operator=(const ArmLawT&) = delete;
  virtual ~ArmLawT() = default;

  /// Starts the arm in a lane (lane 0 for a single arm).
  virtual void start(int lane, const LawNumbers& numbers) = 0;
  /// Sets tau (n). Allocates nothing.
  virtual void torque(const LawPeriodT<T>& at, JointVectorT<T>& tau) = 0;
  /// Is called at the end of the period of the last torque(). learning: true for arms without a saturated
  /// joint whose adaptation is wanted.
  virtual void conclude(const LawPeriodT<T>& /*at*/, const MaskT<T>& /*learning*/) {}
  /// Returns the parameters of the law's present model of the arm (13 n).
  virtual ParameterVectorT<T>& theta() = 0;
  /// Returns the motion of the last period's q', qr', qr'', from which Y follows; null if the law has none.
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

/// Makes a law for arms of n joints.
template <typename T>
std::unique_ptr<ArmLawT<T>> make_arm_law(ArmLawKind kind, int n);

}  // namespace armtune::internal

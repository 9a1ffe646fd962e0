#pragma once
// Friction over one step of integration, linearly implicit where it is stiff.
//
// An explicit step of h multiplies a velocity that only friction changes by 1 - h c / d + ..., where c is the
// slope of the friction law and d the inertia that the joint moves. This grows without bound once h c / d
// exceeds 2, which light links without rotor inertia reach at once: at rest the smoothed Coulomb part alone
// has c = 20 Fc. Here each evaluation k of an explicit Runge-Kutta rule, at the velocity v, solves
//
//   (M + D + G) k = torque - C v - g - f(v) - (2 / h) G (v0 - v),    v0: velocity at the start of the step,
//
// for the friction c (v0 + h k / 2) of the middle of the step instead of f(v) = c v, if G = h c / 2. This is
// a W-method (Steihaug and Wolfbrandt 1979; Hairer and Wanner, Solving Ordinary Differential Equations II,
// section IV.7). Its consequences:
//   - Any diagonal G of size h keeps second order, because the two terms with G differ by O(h^2). G = 0
//     keeps the rule's own order. G is 0 where friction is not stiff, and h c / 2 where it is.
//   - Then M + D + G >= h c / 2, so that no step of friction alone overshoots, whatever the arm.
//   - Beyond h c = 2 d the inertia d + G is raised to h c, so that friction alone stops the joint within the
//     step. Smaller would let the velocity change its sign in every step and hardly decay.
//   - c = Fv + Fc / max(|v|, 0.05) is no less than the secant f(v) / v. The slope f'(v) would not do: at high
//     speed it is zero, and a step that takes away h Fc / d of velocity would then throw the joint back.

#include <cmath>

#include "core/common/select.hpp"
#include "core/robot/chain.hpp"
#include "core/robot/friction.hpp"

namespace armtune {

/// What a joint's friction adds to the equation of motion of the joint.
template <typename T>
struct AddedByFriction {
  T inertia;  ///< [kg m^2, kg]
  T force;    ///< [N m, N]
};

/// Friction at an instant: the torque f(q') alone, which the dynamics subtract by themselves.
struct InstantFriction {
  template <typename T>
  void add(const ChainT<T>& /*chain*/, Eigen::Index /*i*/, const T& /*qd*/, T& /*inertia*/,
           T& /*force*/) const {}
};

/// Friction over a step of h.
template <typename T>
class FrictionStep {
 public:
  /// h [s]; start: q' (n) at the beginning of the step, which must outlive this.
  FrictionStep(const T& h, const JointVectorT<T>& start) : h_(h), rate_(T(2.0) / h), start_(start) {}

  /// Returns what the friction of joint i adds at its velocity qd. inertia: d, that of the joint with those
  /// behind it free, rotor included: the pivot of M + D eliminated from the last joint on.
  AddedByFriction<T> added(const ChainT<T>& chain, Eigen::Index i, const T& qd, const T& inertia) const {
    using std::abs;
    const T speed = abs(qd);
    const T slowest(kCoulombVelocity);
    const T c =
        chain.viscous_friction[i] + chain.coulomb_friction[i] / select(speed > slowest, speed, slowest);
    const T hc = h_ * c;
    // Friction is not stiff up to `least`. While the joints before it give way as well, the joint moves less
    // than d: down to d / 8 in each direction of straight chains of equal rods, but no less than its rotor.
    const T rotor = T(kOfRotor) * chain.rotor_inertia[i];
    const T share = T(kOfInertia) * inertia;
    const T coupled = select(share > rotor, share, rotor);
    const T alone = T(0.5) * inertia;
    const T least = select(coupled > alone, alone, coupled);
    // G is 0 up to h c = least, h c / 2 from twice that on, and continuous.
    const T half = T(0.5) * hc;
    const T excess = select(hc > least, hc - least, T(0.0));
    const T G = select(excess > half, half, excess);
    const T stopping = hc - inertia;
    return {select(stopping > G, stopping, G), -(rate_ * G) * (start_[i] - qd)};
  }

  /// Adds it.
  void add(const ChainT<T>& chain, Eigen::Index i, const T& qd, T& inertia, T& force) const {
    const AddedByFriction<T> friction = added(chain, i, qd, inertia);
    inertia += friction.inertia;
    force += friction.force;
  }

 private:
  /// h c relative to the rotor inertia: an explicit midpoint step is stable up to 2 of the whole inertia.
  static constexpr double kOfRotor = 1.75;
  /// h c relative to d: half of the eighth that is left at least.
  static constexpr double kOfInertia = 0.0625;

  T h_, rate_;
  const JointVectorT<T>& start_;
};

}  // namespace armtune

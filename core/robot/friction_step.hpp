#pragma once
// Joint friction over one time step of the integration: linearly implicit where friction is stiff, explicit
// elsewhere.
//
// If only friction acts, an explicit step of h multiplies the velocity by about 1 - h c / d, where c is the
// slope of the friction law and d the inertia that the joint moves. The step is unstable once h c / d
// exceeds 2. Light links without rotor inertia reach this at rest, where the smoothed Coulomb part alone has
// a slope of 20 Fc. Therefore each evaluation k of a Runge-Kutta rule, at the velocity v, solves the equation
// below. M is the mass matrix, D the rotors' inertia, f the friction, and G a diagonal matrix.
//
//   (M + D + G) k = torque - C v - g - f(v) - (2 / h) G (v0 - v),    v0: velocity at the start of the step.
//
// With G = h c / 2 and f(v) = c v this is friction in the middle of the step, c (v0 + h k / 2). It is a
// W-method (Steihaug and Wolfbrandt 1979; Hairer and Wanner, Solving Ordinary Differential Equations II,
// section IV.7), with these choices:
//   - G is 0 where friction is not stiff. The rule is then bit-identical to the explicit one, and has the
//     same order.
//   - Where friction is stiff, G is h c / 2. A Runge-Kutta rule then has second order, and the semi-implicit
//     Euler rule first order, because G k and (2 / h) G (v - v0) differ by O(h^2). A step of
//     friction alone gains no energy, because h c is at most twice M + D + G.
//   - Beyond h c = 2 d the inertia d + G is raised to h c, so that friction alone stops the joint within the
//     step. With an inertia below h c the velocity would change its sign in every step and hardly decay.
//   - c = Fv + Fc / max(|v|, 0.05) is at least the secant slope f(v) / v. The derivative f'(v) cannot replace
//     it, because its Coulomb part vanishes at high speed. A step would then subtract the velocity h Fc / d
//     explicitly, which can reverse the motion of a joint.

#include <cmath>

#include "core/common/select.hpp"
#include "core/robot/chain.hpp"
#include "core/robot/friction.hpp"

namespace armtune::internal {

/// The terms that a joint's friction adds to the left side (inertia) and the right side (force) of its
/// equation of motion.
template <typename T>
struct AddedByFriction {
  T inertia;  ///< [kg m^2, kg]
  T force;    ///< [N m, N]
};

/// Friction at one instant, for q'' without a time step. It adds no terms, because the dynamics already
/// subtract the friction torque f(q').
struct InstantFriction {
  template <typename T>
  void add(const ChainT<T>& /*chain*/, Eigen::Index /*i*/, const T& /*qd*/, T& /*inertia*/,
           T& /*force*/) const {}
};

/// Friction over a time step h, as derived at the head of this file.
template <typename T>
class FrictionStep {
 public:
  /// h: length of the step [s]. start: q' (n) at the beginning of the step; this vector must outlive the
  /// object.
  FrictionStep(const T& h, const JointVectorT<T>& start) : h_(h), rate_(T(2.0) / h), start_(start) {}

  /// Returns the terms of the friction of joint i at its velocity qd. inertia: d, the inertia that the joint
  /// moves while the joints after it are free and those before it are held, including its rotor. This is the
  /// articulated inertia. It is also the pivot of joint i if M + D is factorised from the last joint to the
  /// first.
  AddedByFriction<T> added(const ChainT<T>& chain, Eigen::Index i, const T& qd, const T& inertia) const {
    using std::abs;
    const T speed = abs(qd);
    const T slowest(kCoulombVelocity);
    const T c =
        chain.viscous_friction[i] + chain.coulomb_friction[i] / select(speed > slowest, speed, slowest);
    const T hc = h_ * c;
    // Friction counts as stiff if h c exceeds `least`. If the joints before joint i move too, joint i moves
    // less inertia than d, but no less than its rotor. In a chain of equal rods with parallel axes and
    // friction in every joint, this inertia is d divided by 5 (two rods), 16 (four rods) or 33 (seven rods).
    const T rotor = T(kOfRotor) * chain.rotor_inertia[i];
    const T share = T(kOfInertia) * inertia;
    const T coupled = select(share > rotor, share, rotor);
    const T alone = T(0.5) * inertia;
    const T least = select(coupled > alone, alone, coupled);
    // G is 0 up to h c = least, and h c / 2 from h c = 2 least on. In between it rises without a jump.
    const T half = T(0.5) * hc;
    const T excess = select(hc > least, hc - least, T(0.0));
    const T G = select(excess > half, half, excess);
    const T stopping = hc - inertia;
    return {select(stopping > G, stopping, G), -(rate_ * G) * (start_[i] - qd)};
  }

  /// Adds the terms of `added` to the inertia and the force of joint i.
  void add(const ChainT<T>& chain, Eigen::Index i, const T& qd, T& inertia, T& force) const {
    const AddedByFriction<T> friction = added(chain, i, qd, inertia);
    inertia += friction.inertia;
    force += friction.force;
  }

 private:
  /// Value of h c above which friction counts as stiff, as a factor on the rotor inertia. An explicit step is
  /// stable up to 2.
  static constexpr double kOfRotor = 1.75;
  /// The same value as a factor on d. It follows from the 33 of seven rods in `added`: about 2 / 33.
  static constexpr double kOfInertia = 1.0 / 16.0;

  T h_, rate_;
  const JointVectorT<T>& start_;
};

}  // namespace armtune::internal

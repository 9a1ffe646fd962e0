#pragma once
// Integrates the motion q'' = f(q, q') of the simulated arm over one control period, with a fixed step or
// with the engine's own integrator.

#include <array>
#include <string>

#include "core/common/types.hpp"

namespace armtune::internal {

enum class Stepper {
  kMidpoint,           ///< explicit midpoint rule, two evaluations of f per step; the default
  kSemiImplicitEuler,  ///< first order, one evaluation of f per step
  kRungeKutta4,        ///< fourth order, four evaluations of f per step
  kReference           ///< the engine's own error-controlled Runge-Kutta-Merson, accuracy 1e-10
};

inline constexpr std::array kSteppers = {Stepper::kMidpoint, Stepper::kSemiImplicitEuler,
                                         Stepper::kRungeKutta4, Stepper::kReference};

constexpr const char* name(Stepper stepper) {
  switch (stepper) {
    case Stepper::kMidpoint:
      return "midpoint";
    case Stepper::kSemiImplicitEuler:
      return "semi_implicit_euler";
    case Stepper::kRungeKutta4:
      return "rk4";
    case Stepper::kReference:
      return "reference";
  }
  return "";
}

/// Returns the stepper of that name. Throws InputError that lists the valid names.
Stepper stepper_from_name(const std::string& text);

/// The workspace of a step, so that no step allocates.
template <typename T>
struct StepWorkspaceT {
  JointVectorT<T> q, qd, k1, k2, k3, k4;
};
using StepWorkspace = StepWorkspaceT<double>;

/// Advances q and qd (n) by one step of h [s]. f(q, qd, qdd) writes the accelerations to qdd. In the plants,
/// f treats stiff friction implicitly (core/robot/friction_step.hpp). For this, f may use the qd at the start
/// of the step, because qd changes only after the last call of f. Must not be called with
/// Stepper::kReference.
template <typename T, typename Accelerations>
void integrate(Stepper stepper, const T& h, Accelerations&& f, JointVectorT<T>& q, JointVectorT<T>& qd,
               StepWorkspaceT<T>& w) {
  const T half = T(0.5) * h;
  switch (stepper) {
    case Stepper::kSemiImplicitEuler:
      f(q, qd, w.k1);
      qd += h * w.k1;
      q += h * qd;
      return;
    case Stepper::kRungeKutta4: {
      f(q, qd, w.k1);
      w.q = q + half * qd;
      w.qd = qd + half * w.k1;
      f(w.q, w.qd, w.k2);
      w.q = q + half * qd + (half * half) * w.k1;
      w.qd = qd + half * w.k2;
      f(w.q, w.qd, w.k3);
      w.q = q + h * qd + (half * h) * w.k2;
      w.qd = qd + h * w.k3;
      f(w.q, w.qd, w.k4);
      q += h * qd + (h * h / T(6.0)) * (w.k1 + w.k2 + w.k3);
      qd += (h / T(6.0)) * (w.k1 + T(2.0) * w.k2 + T(2.0) * w.k3 + w.k4);
      return;
    }
    case Stepper::kMidpoint:
    case Stepper::kReference:
      f(q, qd, w.k1);
      w.q = q + half * qd;
      w.qd = qd + half * w.k1;
      f(w.q, w.qd, w.k2);
      q += h * w.qd;
      qd += h * w.k2;
      return;
  }
}

}  // namespace armtune::internal

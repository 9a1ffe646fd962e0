#pragma once
// The interface of the plant, that is, of the simulated arm. It is independent of the physics engine, so that
// a further engine needs only one more file. Each thread needs its own Plant.

#include <memory>

#include "core/robot/kinematics.hpp"
#include "core/robot/robot_model.hpp"
#include "sim/plant/engine.hpp"
#include "sim/plant/stepper.hpp"

namespace armtune::internal {

class Plant {
 public:
  Plant() = default;
  Plant(const Plant&) = delete;
  Plant& operator=(const Plant&) = delete;
  virtual ~Plant() = default;

  /// Restarts the plant at q [rad, m] and q' (n each).
  virtual void set_state(const JointVector& q, const JointVector& qd) = 0;
  virtual const JointVector& q() const = 0;
  virtual const JointVector& qd() const = 0;

  /// Advances the state by dt [s] under a constant torque (n) [N m, N]. Friction and rotor inertia come from
  /// the model. poses: poses of the model at the current q if they were computed already, else null.
  void step(const JointVector& torque, double dt, const Poses* poses = nullptr) {
    advance(torque, dt, poses);
  }

  /// Computes q'' (n) at any state from the equation of motion
  ///
  ///   (M + D) q'' + C q' + g = torque - Fv q' - Fc tanh(q'/0.05).
  ///
  /// M: inertia matrix of the links; D: rotor inertia; C q': Coriolis and centrifugal torque; g: gravity
  /// torque; Fv, Fc: viscous and Coulomb friction.
  virtual void accelerations(const JointVector& q, const JointVector& qd, const JointVector& torque,
                             JointVector& qdd) = 0;

 protected:
  virtual void advance(const JointVector& torque, double dt, const Poses* poses) = 0;
};

/// Creates the arm in Simbody. Throws InputError if Simbody refuses the model.
std::unique_ptr<Plant> make_simbody_plant(const RobotModel& model, Stepper stepper);

/// Creates the arm in armtune's own dynamics (core). Throws InputError for the stepper `reference`, which
/// only Simbody has.
std::unique_ptr<Plant> make_native_plant(const RobotModel& model, Stepper stepper);

/// Creates the arm in the given engine. Throws InputError as the two functions above do.
std::unique_ptr<Plant> make_plant(const RobotModel& model, Stepper stepper, Engine engine);

}  // namespace armtune::internal

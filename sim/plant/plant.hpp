#pragma once
// The simulated arm behind one interface: no engine's types here, so that an engine is exchanged by writing
// one file. One Plant per thread.

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

  /// Starts anew at q [rad, m] and q' (n each).
  virtual void set_state(const JointVector& q, const JointVector& qd) = 0;
  virtual const JointVector& q() const = 0;
  virtual const JointVector& qd() const = 0;

  /// Advances by dt [s] with the torque (n) [N m, N] held. Friction and rotor inertia follow from the model.
  /// poses: of the model at q, if somebody has computed them already.
  void step(const JointVector& torque, double dt, const Poses* poses = nullptr) {
    advance(torque, dt, poses);
  }

  /// q'' at any state: (M + D) q'' + C q' + g = torque - Fv q' - Fc tanh(q'/0.05).
  virtual void accelerations(const JointVector& q, const JointVector& qd, const JointVector& torque,
                             JointVector& qdd) = 0;

 protected:
  virtual void advance(const JointVector& torque, double dt, const Poses* poses) = 0;
};

/// The arm in Simbody. Throws InputError if Simbody refuses the model.
std::unique_ptr<Plant> make_simbody_plant(const RobotModel& model, Stepper stepper);

/// The arm in core's dynamics. Throws InputError for the stepper `reference`, which is Simbody's.
std::unique_ptr<Plant> make_native_plant(const RobotModel& model, Stepper stepper);

/// Either of the two.
std::unique_ptr<Plant> make_plant(const RobotModel& model, Stepper stepper, Engine engine);

}  // namespace armtune::internal

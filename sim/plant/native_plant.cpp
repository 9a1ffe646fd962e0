// Simulates the arm by core's own dynamics. Except for rounding, the motion is the same as that of a Simbody
// plant with the same model and stepper.

#include "armtune/error.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "sim/plant/stepped_plant.hpp"

namespace armtune::internal {
namespace {

class NativePlant final : public SteppedPlant {
 public:
  NativePlant(const RobotModel& model, Stepper stepper)
      : SteppedPlant(model.n(), stepper), chain_(model.chain) {}

  void accelerations(const JointVector& q, const JointVector& qd, const JointVector& torque,
                     JointVector& qdd) override {
    body_poses(chain_, q, poses_);
    forward_dynamics(chain_, poses_, qd, torque, dynamics_, qdd);
  }

 protected:
  void evaluate(const Poses* poses, const JointVector& q, const JointVector& qd, const JointVector& torque,
                const FrictionStep<double>& friction, JointVector& qdd) override {
    if (poses == nullptr) body_poses(chain_, q, poses_);
    forward_dynamics(chain_, poses == nullptr ? poses_ : *poses, qd, torque, friction, dynamics_, qdd);
  }

 private:
  Chain chain_;
  Poses poses_;
  ForwardDynamics dynamics_;
};

}  // namespace

std::unique_ptr<Plant> make_native_plant(const RobotModel& model, Stepper stepper) {
  if (stepper == Stepper::kReference) {
    throw InputError(InputPlace{model.source, 0, "stepper"},
                     "the stepper 'reference' needs Simbody; use engine simbody, or the stepper rk4")
        .with_value("reference", "engine simbody, or the stepper rk4");
  }
  return std::make_unique<NativePlant>(model, stepper);
}

std::unique_ptr<Plant> make_plant(const RobotModel& model, Stepper stepper, Engine engine) {
  return engine == Engine::kNative ? make_native_plant(model, stepper) : make_simbody_plant(model, stepper);
}

}  // namespace armtune::internal

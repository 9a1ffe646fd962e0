#include "core/control/laws/computed_torque_law.hpp"

#include "core/control/laws/arm_torque_law.hpp"
#include "core/control/laws/first_gains.hpp"

namespace armtune::internal {
namespace {

/// This law does not learn the errors of the model, so the feedback alone corrects their effect.
constexpr double kStiffRate = 60.0;  // 1/s

}  // namespace

ControllerKind computed_torque_controller() {
  return {
      "computed_torque",
      "computed torque in Cartesian space: inverse dynamics at q'' = J+ (xr'' - D (x' - xr') - J' q')",
      {"task_space_gains_p", "task_space_gains_i", "interpolation_gain_scale"},
      {own_gain(GainShape::kTask, "computed_torque_d", "1/s",
                "D on the velocity error, for each axis of the task", kStiffRate),
       own_gain(GainShape::kScalar, "computed_torque_joint_d", "1/s",
                "damping of the joint motion that the task leaves free; in the states leaveSingularity and "
                "followPlan, of all joint motion",
                kStiffRate)},
      [](const LawSetup& setup) { return make_torque_law(ArmLawKind::kComputedTorque, setup); },
      {},
      false,
      ArmLawKind::kComputedTorque};
}

}  // namespace armtune::internal

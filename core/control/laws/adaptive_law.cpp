#include "core/control/laws/adaptive_law.hpp"

#include "core/control/laws/arm_torque_law.hpp"

namespace armtune::internal {

ControllerKind adaptive_controller() {
  return {"adaptive",
          "adaptive Cartesian PID: Y theta - Kd S, with theta adapted online (Slotine and Li)",
          {"task_space_gains_p", "task_space_gains_i", "task_space_gains_d", "interpolation_gain_scale",
           "adaptation_gain", "adapt_while_avoiding", "adaptation_leakage", "adaptation_inertia_leakage",
           "adaptation_filter", "adaptation_projection"},
          {},
          [](const LawSetup& setup) { return make_torque_law(ArmLawKind::kAdaptive, setup); },
          {},
          true,
          ArmLawKind::kAdaptive};
}

}  // namespace armtune::internal

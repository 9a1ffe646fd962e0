#pragma once
// Cartesian impedance: to a disturbance the tool behaves like a spring and a damper along its motion,
//   tau = Y theta - J^T (K dx + D J S) - B S.
// Y theta is taken along the desired motion: qr' = J+ xd' and its qr'', since Kp and Ki of the references are
// zero. The arm's own inertia is felt at the tool, not shaped. J S = x' - xd' for an arm away from
// singularities, and B damps what the task leaves free. (Hogan, Impedance control, 1985; Ott, Cartesian
// impedance control of redundant and flexible-joint robots, 2008.)

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

ControllerKind impedance_controller();

}  // namespace armtune::internal

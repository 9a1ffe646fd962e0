#pragma once
// Cartesian impedance: the tool meets what disturbs it as a spring and a damper on its way,
//   tau = Y theta - J^T (K dx + D J S) - B S,
// Y theta along the desired motion: qr' = J+ xd' and qr'' of it, as Kp and Ki of the references are zero.
// The arm's own inertia is felt at the tool, not shaped; J S = x' - xd' of an arm away from singularities,
// and B damps what the task leaves free. (Hogan, Impedance control, 1985; Ott, Cartesian impedance control of
// redundant and flexible-joint robots, 2008.)

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

ControllerKind impedance_controller();

}  // namespace armtune::internal

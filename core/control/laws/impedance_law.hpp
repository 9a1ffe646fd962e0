#pragma once
// The built-in controller `impedance`. When the tool is disturbed, it behaves like a spring (K) and a damper
// (D) that are attached to its desired motion:
//   tau = Y theta - J^T (K dx + D J S) - B S.
// dx is the pose error. The model's torque Y theta is taken along the desired motion, with qr' = J+ xd' and
// its qr'', since Kp and Ki of the references are zero. The law does not change the arm's own inertia, which
// is felt at the tool. J S = x' - xd' for an arm away from singularities, and B damps what the task leaves
// free. (Hogan, Impedance control, 1985; Ott, Cartesian impedance control of redundant and flexible-joint
// robots, 2008.)

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

ControllerKind impedance_controller();

}  // namespace armtune::internal

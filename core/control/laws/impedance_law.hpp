#pragma once
// The built-in controller `impedance`. When the tool is disturbed, it behaves like a spring (K) and a damper
// (D) that are attached to its desired motion:
//   tau = Y theta - J^T (K dx + D J S) - B S.
// dx is the pose error, and S = q' - qr'. Kp and Ki of the references are zero, so qr' = J+ xd', and the
// model's torque Y theta is computed along the desired motion. Away from singularities J S = x' - xd'. The
// joint dampers B also damp the motion that the task leaves free. The law does not shape the inertia: at the
// tool, the arm's own inertia is felt. (Hogan, Impedance control, 1985; Ott, Cartesian impedance control of
// redundant and flexible-joint robots, 2008.)

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

ControllerKind impedance_controller();

}  // namespace armtune::internal

#pragma once
// The built-in controller `computed_torque`: computed torque in Cartesian space. The torque is the inverse
// dynamics of a joint acceleration a,
//   tau = M(q) a + C(q, q') q' + g(q) + friction(q').
// a is chosen so that the velocity error s = x' - xr' of the task decays:
//   J a + J' q' = xr'' - D s,   which gives   s' = -D s.
// With e = dx this is the equation e'' + (D + Kp) e' + (Ki + D Kp) e + D Ki int(e) = 0. The errors, Kp and Ki
// are the same as for the other laws, and D replaces their joint space Kd. (Luh, Walker and Paul,
// Resolved-acceleration control of mechanical manipulators, 1980.)
//
// The law uses a = qr'' - J+ (D J S + J' S) - d (S - J+ J S), with S = q' - qr'. This a fulfils the equation
// above, since J qr'' = xr'' - J' qr'. The last term, with the gain d, damps the joint motion that the task
// leaves free. If a matrix E selects fewer task components, E s decays instead of s. If E turns with the
// tool, E' s is a part of the derivative of E s (core/control/task_resolution.hpp). In states that track
// joints, a = qr'' - d S.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

ControllerKind computed_torque_controller();

}  // namespace armtune::internal

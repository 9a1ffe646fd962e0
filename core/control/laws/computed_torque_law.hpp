#pragma once
// The built-in controller `computed_torque`: computed torque in Cartesian space. The torque is the inverse
// dynamics of an acceleration a under which the task's errors obey a linear differential equation:
//   tau = M(q) a + C(q, q') q' + g(q) + friction(q'),   J a + J' q' = xr'' - D s,   s = x' - xr',
// so that s' = -D s. With e = dx this is e'' + (D + Kp) e' + (Ki + D Kp) e + D Ki int(e) = 0. The errors, Kp
// and Ki are those of the other laws, and D takes the place of a joint space Kd. (Luh, Walker and Paul,
// Resolved-acceleration control of mechanical manipulators, 1980.)
//
// a = qr'' - J+ (D J S + J' S) - d (S - J+ J S) fulfils this, as J qr'' = xr'' - J' qr', and damps with d the
// motion that the task leaves free. If a matrix E selects fewer task components, E s decays instead of s. If
// E turns with the tool, E' s belongs to the derivative of E s (core/control/task_resolution.hpp). In states
// that track joints, a = qr'' - d S.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

ControllerKind computed_torque_controller();

}  // namespace armtune::internal

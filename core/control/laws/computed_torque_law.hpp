#pragma once
// Computed torque in Cartesian space: the model is inverted along an acceleration that makes the task's
// errors a linear system,
//   tau = M(q) a + C(q, q') q' + g(q) + friction(q'),   J a + J' q' = xr'' - D s,   s = x' - xr',
// so that s' = -D s: with e = dx it is e'' + (D + Kp) e' + (Ki + D Kp) e + D Ki int(e) = 0, the same errors
// (and Kp, Ki) as those of the other laws, and D in place of a joint space Kd. (Luh, Walker and Paul,
// Resolved-acceleration control of mechanical manipulators, 1980.)
//
// a = qr'' - J+ (D J S + J' S) - d (S - J+ J S) gives that, as J qr'' = xr'' - J' qr', and damps with d what
// the task leaves free. Of a task with fewer components it is E s that dies, and where E turns with the tool
// E' s belongs to its derivative (core/control/task_resolution.hpp). States that track joints: a = qr'' - d
// S.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

ControllerKind computed_torque_controller();

}  // namespace armtune::internal

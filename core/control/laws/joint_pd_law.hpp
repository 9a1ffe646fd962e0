#pragma once
// The built-in controller `joint_pd`: joint PD with gravity compensation, which most arms have built in. The
// joint reference q_ref is integrated from the reference velocity qr':
//   q_ref' = qr',   tau = g(q) + P (q_ref - q) + D (qr' - q').
// qr' contains the task's Kp and Ki, as for the other laws. (Takegaki and Arimoto, A new feedback method for
// dynamic control of manipulators, 1981.)

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

ControllerKind joint_pd_controller();

}  // namespace armtune::internal

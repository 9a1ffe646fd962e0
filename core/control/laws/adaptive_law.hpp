#pragma once
// The adaptive law (equations 5 and 6):  tau = Y theta - Kd S, theta <- theta - gamma Y^T S dt.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

ControllerKind adaptive_controller();

}  // namespace armtune::internal

#pragma once
// The built-in controller `adaptive`. Its law adapts the parameters theta of its arm model online (Slotine
// and Li; equations 5 and 6 in NOTATION.md):  tau = Y theta - Kd S,  theta <- theta - gamma Y^T S dt.

#include "core/control/laws/controller_kind.hpp"

namespace armtune::internal {

ControllerKind adaptive_controller();

}  // namespace armtune::internal

#pragma once
// The text of `armtune controllers`, which lists every controller and its gains from their declarations.

#include <string>

namespace armtune::internal::cli {

/// Returns a list of every gain with its shape, default search range, meaning and unit: first the gains that
/// every controller has, then those of each controller.
std::string controllers_text();

}  // namespace armtune::internal::cli

// Replaces yardstick_option.cpp if armtune is built without the planner.

#include "tuner/cli/yardstick_option.hpp"

namespace armtune::internal::cli {

void add_yardstick_option(CLI::App& /*command*/, bool& wanted) {
  wanted = false;
}

Yardstick yardstick_if(bool /*wanted*/) {
  return {};
}

}  // namespace armtune::internal::cli

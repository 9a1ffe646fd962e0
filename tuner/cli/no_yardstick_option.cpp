// Where armtune is built without the planner.

#include "tuner/cli/yardstick_option.hpp"

namespace armtune::cli {

void add_yardstick_option(CLI::App& /*command*/, bool& wanted) {
  wanted = false;
}

YardstickFiles write_yardstick(const std::string& /*folder*/, const std::vector<Scenario>& /*scenarios*/,
                               const std::function<Gains(const Scenario&)>& /*gains*/) {
  return {};
}

}  // namespace armtune::cli

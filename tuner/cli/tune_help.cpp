#include "tuner/cli/tune_help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/scenario/data_files.hpp"

namespace armtune::internal::cli {

std::string tune_help() {
  return fmt::format(
      "Bundled studies: {}\n\n"
      "These commands list what a study file can name:\n"
      "  armtune metrics      metrics for the objective and constraints\n"
      "  armtune algorithms   search algorithms, and the keys of a study's section 'search'\n"
      "  armtune controllers  controllers and their gains\n\n"
      "Example that tunes gains, then compares them with the published ones:\n"
      "  armtune tune ur10_gaze --max-evaluations 100 --out runs/tuned\n"
      "  armtune compare published runs/tuned --scenarios moving_target\n\n"
      "To tune a ROS controller (if all checks pass, its file with tuned gains is in the run folder):\n"
      "  armtune tune --robot arm.urdf --controllers ros2_controllers.yaml --trajectory moves.csv "
      "--out runs/mine\n",
      fmt::join(bundled_names("studies"), " "));
}

}  // namespace armtune::internal::cli

// Says why no controller of a parameter file can be tuned.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "sim/controller_files/commanded_interfaces.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {
namespace {

std::string commands_of(const RosController& controller) {
  return fmt::format("{}", fmt::join(commanded_interfaces(controller), ", "));
}

bool commands_positions(const RosController& controller) {
  const std::string commands = commands_of(controller);
  return commands == "position" || (!controller.ros2 && commands.starts_with("pos"));
}

/// Returns what can be done about a joint trajectory controller without gains.
std::string advice_for(const RosController& controller) {
  if (commands_positions(controller))
    return "The controller commands positions, which the robot's own loops follow, so it has no gains to "
           "tune. To tune how a robot follows streamed positions, give --controller position_streaming "
           "--rate HZ instead of this file";
  if (are_simulated(commanded_interfaces(controller), controller.ros2))
    return "Give start gains in the file: 'gains: {JOINT: {p: NUMBER, i: NUMBER, d: NUMBER}}'";
  return "armtune simulates such a controller only with gains, and with effort commands alone or velocity "
         "commands alone";
}

}  // namespace

void refuse_file_without_gains(const yaml::Placed& root, const std::string& file, const std::string& name) {
  const std::vector<RosController> all = controllers_without_gains(root, file);
  const auto found = std::find_if(all.begin(), all.end(), [&name](const RosController& controller) {
    return name.empty() || controller.name == name;
  });
  if (found == all.end()) {
    throw InputError(InputPlace{file},
                     fmt::format("found no controller{} that armtune can tune: none has gains for each joint "
                                 "(gains, or k_gains and d_gains). For a controller that armtune does not "
                                 "know, bind its numbers with a map of gains, see docs/file_formats.md",
                                 name.empty() ? "" : " '" + name + "'"))
        .with_value(name, "");
  }
  const std::string commands = commands_of(*found);
  std::vector<std::string> names;
  for (const RosController& controller : all) {
    if (name.empty() ? commands_of(controller) == commands : &controller == &*found)
      names.push_back(controller.name);
  }
  throw InputError(
      at_line(file, found->parameters->line, found->name),
      fmt::format("no gains are given for the joint trajectory controller{} {}{}. {}",
                  names.size() > 1 ? "s" : "", fmt::join(names, ", "),
                  commands.empty() ? "" : fmt::format(" (commands: {})", commands), advice_for(*found)))
      .with_value(commands, commands_positions(*found) ? "effort or velocity" : "gains");
}

}  // namespace armtune::internal

#include "sim/controller_files/parameter_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "sim/controller_files/gain_map.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

std::optional<ParameterFile> read_parameter_file(const std::string& path, const std::string& node,
                                                 std::optional<RosDistro> distro,
                                                 const std::vector<std::string>& joints) {
  std::string text = read_input_file(path, yaml::kMaxBytes, "a YAML file");
  if (is_gain_map(text, path)) {
    if (!node.empty())
      throw InputError(
          InputPlace{path},
          fmt::format("a node ('{}') cannot be named together with a map of gains; leave it out, because the "
                      "map says where the gains are",
                      node));
    const GainMap map = gain_map(text, path);
    text = read_input_file(map.file, yaml::kMaxBytes, "a YAML file");
    ParameterFile file{map.file, text, with_text(map.controller, text, map.file)};
    if (distro) set_distro(file, *distro);
    return file;
  }
  if (!may_hold_controllers(text)) return std::nullopt;
  const auto all = ros_controllers(text, path);
  if (all.empty()) return std::nullopt;
  RosController controller = chosen_controller(all, path, node, joints);
  ParameterFile file{path, std::move(text), std::move(controller)};
  if (distro) set_distro(file, *distro);
  return file;
}

ParameterFile required_parameter_file(const std::string& path, const std::string& node,
                                      std::optional<RosDistro> distro,
                                      const std::vector<std::string>& joints) {
  if (auto file = read_parameter_file(path, node, distro, joints)) return *std::move(file);
  const std::string text = read_input_file(path, yaml::kMaxBytes, "a YAML file");
  refuse_file_without_gains(yaml::read_placed(text, path), path, node);
}

ParameterFile parameter_file_for(const Gains& gains, const std::string& path, const std::string& node,
                                 const std::vector<std::string>& joints) {
  ParameterFile file = required_parameter_file(path, node, {}, joints);
  if (is_joint_trajectory_controller(gains.controller) && file.controller.layout == GainLayout::kPidByJoint)
    set_distro(file, jtc_distro(gains));
  return file;
}

void set_distro(ParameterFile& file, RosDistro distro) {
  RosController& controller = file.controller;
  const RosRules& rules = rules_of(distro);
  if (controller.layout != GainLayout::kPidByJoint)
    throw InputError(InputPlace{file.path},
                     fmt::format("a distribution of ROS ('{}') can be named only for a joint trajectory "
                                 "controller, which {} is not; remove the option or key that names it",
                                 rules.name, controller.name));
  if (controller.ros2 != rules.ros2)
    throw InputError(
        InputPlace{file.path},
        fmt::format(
            "{} has parameters of ROS {}, but the given distribution is {}; give a distribution of ROS {}",
            controller.name, controller.ros2 ? 2 : 1, rules.title, controller.ros2 ? 2 : 1));
  controller.distro = distro;
}

std::vector<std::string> files_of_gains(const std::string& path) {
  std::vector<std::string> files = {path};
  const std::string text = read_input_file(path, yaml::kMaxBytes, "a YAML file");
  if (!is_gain_map(text, path)) return files;
  std::string numbers = gain_map(text, path).file;
  if (numbers != path) files.push_back(std::move(numbers));
  return files;
}

bool is_parameter_file(const std::string& path) {
  const std::string text = read_input_file(path, yaml::kMaxBytes, "a YAML file");
  if (is_gain_map(text, path)) return true;
  return may_hold_controllers(text) && !ros_controllers(text, path).empty();
}

RosController with_text(const RosController& controller, const std::string& text, const std::string& file) {
  if (controller.layout != GainLayout::kMapped) {
    RosController changed = chosen_controller(ros_controllers(text, file), file, controller.name);
    changed.distro = controller.distro;
    return changed;
  }
  RosController changed = controller;
  changed.all = changed.parameters = yaml::read_placed(text, file);
  return changed;
}

}  // namespace armtune::internal

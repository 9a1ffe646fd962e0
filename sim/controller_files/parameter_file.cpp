#include "sim/controller_files/parameter_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "sim/controller_files/gain_map.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

std::optional<ParameterFile> read_parameter_file(const std::string& path, const std::string& node) {
  std::string text = read_input_file(path, yaml::kMaxBytes, "a YAML file");
  if (is_gain_map(text, path)) {
    if (!node.empty())
      throw InputError(
          InputPlace{path},
          fmt::format("a node ('{}') cannot be named with a map; write the places in the map", node));
    const GainMap map = gain_map(text, path);
    text = read_input_file(map.file, yaml::kMaxBytes, "a YAML file");
    return ParameterFile{map.file, text, with_text(map.controller, text, map.file)};
  }
  if (!may_hold_controllers(text)) return std::nullopt;
  const auto all = ros_controllers(text, path);
  if (all.empty()) return std::nullopt;
  RosController controller = chosen_controller(all, path, node);
  return ParameterFile{path, std::move(text), std::move(controller)};
}

std::vector<std::string> files_of_gains(const std::string& path, const std::string& node) {
  std::vector<std::string> files = {path};
  const auto numbers = read_parameter_file(path, node);
  if (numbers && numbers->path != path) files.push_back(numbers->path);
  return files;
}

bool is_parameter_file(const std::string& path) {
  const std::string text = read_input_file(path, yaml::kMaxBytes, "a YAML file");
  if (is_gain_map(text, path)) return true;
  return may_hold_controllers(text) && !ros_controllers(text, path).empty();
}

RosController with_text(const RosController& controller, const std::string& text, const std::string& file) {
  if (controller.layout != GainLayout::kMapped)
    return chosen_controller(ros_controllers(text, file), file, controller.name);
  RosController changed = controller;
  changed.all = changed.parameters = yaml::read_placed(text, file);
  return changed;
}

}  // namespace armtune::internal

#include "sim/scenario/gains_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/controller_files/parameter_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/yaml/decimal.hpp"
#include "sim/yaml/force_gains.hpp"
#include "sim/yaml/joint_values.hpp"
#include "sim/yaml/map_reader.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kController = "controller";
constexpr std::array kPath = {"circularTrajectoryAnchorPosition", "circularTrajectoryRadius",
                              "circularTrajectoryPeriod"};
// The parameters that `ros2 param dump` writes for every node.
constexpr std::array kOfEveryNode = {"use_sim_time", "qos_overrides", "start_type_description_service"};

/// Returns the map with the fields, which is below all maps that have another map as their only entry.
const yaml::Node& fields_node(const yaml::Node& root) {
  const yaml::Node* node = &root;
  while (node->entries().size() == 1 && node->entries()[0].second.kind() == yaml::Node::Kind::kMap)
    node = &node->entries()[0].second;
  return *node;
}

/// Throws InputError if a ROS 2 parameter file has several nodes.
void refuse_several(const yaml::Node& fields) {
  const auto is_node = [](const auto& entry) {
    return entry.second.kind() == yaml::Node::Kind::kMap && entry.second.find(kRos2Parameters) != nullptr;
  };
  const auto& entries = fields.entries();
  if (std::count_if(entries.begin(), entries.end(), is_node) > 1)
    fields.fail("the file has parameters of several nodes; keep only the controller's node", "one node");
}

std::string value_text(std::span<const double> values, bool is_list) {
  std::vector<std::string> words;
  words.reserve(values.size());
  for (const double value : values) words.push_back(yaml::decimal(value));
  return is_list ? fmt::format("[{}]", fmt::join(words, ", ")) : words.front();
}

/// Returns the text of a list of lists with n numbers each.
std::string rows_text(std::span<const double> values, std::size_t n) {
  std::vector<std::string> rows;
  for (std::size_t first = 0; first < values.size(); first += n)
    rows.push_back(value_text(values.subspan(first, n), true));
  return fmt::format("[{}]", fmt::join(rows, ", "));
}

JointVector own_values(const yaml::Node& node, GainShape shape, const std::vector<std::string>& joints) {
  if (shape == GainShape::kJoints) return yaml::joint_values(node, joints);
  if (shape == GainShape::kTask) return JointVector(Vec6(node.as_numbers(6).data()));
  return JointVector::Constant(1, node.as_number());
}

void read_field(const yaml::Node& node, const GainField& field, const std::vector<std::string>& joints,
                Gains& gains) {
  std::visit(
      [&](auto member) {
        if constexpr (std::is_same_v<decltype(member), OwnGain>) {
          gains.own[member.place] = own_values(node, member.shape, joints);
        } else {
          auto& value = gains.*member;
          using Value = std::remove_cvref_t<decltype(value)>;
          if constexpr (std::is_same_v<Value, double>) {
            value = node.as_number();
          } else if constexpr (std::is_same_v<Value, Vec6>) {
            value = Vec6(node.as_numbers(6).data());
          } else if constexpr (std::is_same_v<Value, JointVector>) {
            value = yaml::joint_values(node, joints);
          } else if constexpr (std::is_same_v<Value, ForceGains>) {
            value = yaml::force_gains(node, joints);
          } else if constexpr (std::is_same_v<Value, bool>) {
            value = node.as_boolean();
          } else {
            const std::string text = node.as_string();
            if (text != "start" && text != "current") node.fail_choice({"start", "current"});
            value = text == "start" ? SlerpReference::kStart : SlerpReference::kCurrent;
          }
        }
      },
      field.member);
}

}  // namespace

Gains load_gains(const std::string& name_or_path, const std::vector<std::string>& joints,
                 const std::string& relative_to, const std::string& node, std::optional<RosDistro> distro) {
  const std::string path = find_data_file("gains", name_or_path, relative_to);
  if (const auto file = read_parameter_file(path, node, distro, joints)) {
    Gains gains = controller_gains(file->controller, file->path, joints);
    validate(gains, joints, file->path);
    return gains;
  }
  if (!node.empty())
    throw InputError(
        InputPlace{path},
        fmt::format(
            "this is not a ROS parameter file with controllers, so no node ('{}') can be named for it; "
            "remove the option or key that names the node",
            node))
        .with_value(node, "a ROS parameter file with controllers");
  if (distro)
    throw InputError(
        InputPlace{path},
        fmt::format(
            "this is not a ROS parameter file, so no distribution of ROS ('{}') can be named for it; remove "
            "the key that names it, and set the gain jtc_distro instead",
            rules_of(*distro).name))
        .with_value(std::string(rules_of(*distro).name), "a ROS parameter file");
  const yaml::Node root = yaml::parse_text(read_input_file(path, yaml::kMaxBytes, "a YAML file"), path);
  const yaml::Node& fields = fields_node(root);
  refuse_several(fields);
  yaml::MapReader map(fields);
  Gains gains;
  if (const yaml::Node* named = map.optional(kController)) {
    try {
      change_controller(gains, named->as_string(), static_cast<int>(joints.size()));
    } catch (const InputError& e) {
      named->fail(e.what(), e.limit());
    }
  }
  for (const GainField& field : fields_of(gains)) {
    const yaml::Node* value = field.required ? &map.required(field.name) : map.optional(field.name);
    if (value != nullptr) read_field(*value, field, joints, gains);
  }
  for (const char* key : kPath) map.ignore(key);
  for (const char* key : kOfEveryNode) map.ignore(key);
  map.finish();
  validate(gains, joints, path);
  return gains;
}

std::string field_text(const Gains& gains, const GainField& field) {
  if (const auto* flag = std::get_if<bool Gains::*>(&field.member)) return gains.**flag ? "true" : "false";
  if (const auto* reference = std::get_if<SlerpReference Gains::*>(&field.member)) {
    return gains.**reference == SlerpReference::kStart ? "start" : "current";
  }
  if (const auto* member = std::get_if<ForceGains Gains::*>(&field.member)) {
    const auto n = static_cast<int>(gains.joint_space_gains_p.size());  // every controller has this gain
    if (is_per_joint(gains.**member, n)) return rows_text(numbers(gains, field), static_cast<std::size_t>(n));
  }
  return value_text(numbers(gains, field), component_names(field, {}).size() != 1);
}

std::vector<std::pair<std::string, std::string>> published_path(const std::string& gains_path) {
  std::vector<std::pair<std::string, std::string>> path;
  if (is_parameter_file(gains_path)) return path;
  const yaml::Node root =
      yaml::parse_text(read_input_file(gains_path, yaml::kMaxBytes, "a YAML file"), gains_path);
  for (const auto& [key, value] : fields_node(root).entries()) {
    if (std::find(kPath.begin(), kPath.end(), key) == kPath.end()) continue;
    const bool is_list = value.kind() == yaml::Node::Kind::kSequence;
    const auto values = is_list ? value.as_numbers() : std::vector<double>{value.as_number()};
    path.emplace_back(key, value_text(values, is_list));
  }
  return path;
}

std::string gains_yaml(const Gains& gains, const std::vector<std::string>& header, const GainsKeys& keys,
                       const std::vector<std::pair<std::string, std::string>>& others) {
  std::string text;
  for (const std::string& line : header) text += yaml::comment(line);
  std::string indent;
  for (const std::string& key : keys) {
    text += fmt::format("{}{}:\n", indent, key);
    indent += "  ";
  }
  const bool is_ros2 = std::find(keys.begin(), keys.end(), kRos2Parameters) != keys.end();
  // Files of the published controller do not name a controller.
  if (gains.controller != Gains().controller)
    text += fmt::format("{}{}: {}\n", indent, kController, gains.controller);
  for (const GainField& field : fields_of(gains)) {
    if (field.is_number() && numbers(gains, field).empty()) continue;
    // ROS 2 has no lists of lists, so that the numbers are written row by row in one list.
    const bool flat = is_ros2 && std::holds_alternative<ForceGains Gains::*>(field.member);
    text += fmt::format("{0}# {1}{2}{3}{4}\n{0}{5}: {6}\n", indent, field.meaning, *field.unit ? " [" : "",
                        field.unit, *field.unit ? "]" : "", field.name,
                        flat ? value_text(numbers(gains, field), true) : field_text(gains, field));
  }
  for (const auto& [key, value] : others) text += fmt::format("{}{}: {}\n", indent, key, value);
  return text;
}

}  // namespace armtune::internal

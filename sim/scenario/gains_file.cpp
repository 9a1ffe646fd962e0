#include "sim/scenario/gains_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/common/error.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/yaml/joint_values.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune {
namespace {

constexpr const char* kNamespace = "simple_effort_ctrl";
constexpr const char* kController = "controller";

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
          } else if constexpr (std::is_same_v<Value, bool>) {
            value = node.as_boolean();
          } else {
            const std::string text = node.as_string();
            if (text != "start" && text != "current")
              node.fail("'" + text + "' is not one of: start, current");
            value = text == "start" ? SlerpReference::kStart : SlerpReference::kCurrent;
          }
        }
      },
      field.member);
}

std::string field_text(const Gains& gains, const GainField& field) {
  if (const auto* flag = std::get_if<bool Gains::*>(&field.member)) return gains.**flag ? "true" : "false";
  if (const auto* reference = std::get_if<SlerpReference Gains::*>(&field.member)) {
    return gains.**reference == SlerpReference::kStart ? "start" : "current";
  }
  const auto values = numbers(gains, field);
  return component_names(field, {}).size() == 1 ? fmt::format("{}", values[0])
                                                : fmt::format("[{}]", fmt::join(values, ", "));
}

}  // namespace

Gains load_gains(const std::string& name_or_path, const std::vector<std::string>& joints,
                 const std::string& relative_to) {
  const std::string path = find_data_file("gains", name_or_path, relative_to);
  const yaml::Node root = yaml::parse_file(path);
  const bool wrapped =
      root.entries().size() == 1 && root.entries()[0].second.kind() == yaml::Node::Kind::kMap;
  yaml::MapReader map(wrapped ? root.entries()[0].second : root);
  Gains gains;
  if (const yaml::Node* node = map.optional(kController)) {
    try {
      become(gains, node->as_string(), static_cast<int>(joints.size()));
    } catch (const InputError& e) {
      node->fail(e.what());
    }
  }
  for (const GainField& field : fields_of(gains)) {
    const yaml::Node* node = field.required ? &map.required(field.name) : map.optional(field.name);
    if (node != nullptr) read_field(*node, field, joints, gains);
  }
  for (const char* key :
       {"circularTrajectoryAnchorPosition", "circularTrajectoryRadius", "circularTrajectoryPeriod"}) {
    map.ignore(key);
  }
  map.finish();
  validate(gains, joints, path);
  return gains;
}

std::string gains_yaml(const Gains& gains, const std::vector<std::string>& header) {
  std::string text;
  for (const std::string& line : header) text += fmt::format("# {}\n", line);
  text += fmt::format("{}:\n", kNamespace);
  // Files of the published controller do not name one.
  if (gains.controller != Gains().controller)
    text += fmt::format("  {}: {}\n", kController, gains.controller);
  for (const GainField& field : fields_of(gains)) {
    if (field.is_number() && numbers(gains, field).empty()) continue;
    text += fmt::format("  # {}{}{}{}\n  {}: {}\n", field.meaning, *field.unit ? " [" : "", field.unit,
                        *field.unit ? "]" : "", field.name, field_text(gains, field));
  }
  return text;
}

}  // namespace armtune

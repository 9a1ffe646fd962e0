#include "sim/scenario/gains_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/control/gain_fields.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/yaml/joint_values.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune {
namespace {

constexpr const char* kNamespace = "simple_effort_ctrl";

void read_field(const yaml::Node& node, const GainField& field, const std::vector<std::string>& joints,
                Gains& gains) {
  std::visit(
      [&](auto member) {
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
          if (text != "start" && text != "current") node.fail("'" + text + "' is not one of: start, current");
          value = text == "start" ? SlerpReference::kStart : SlerpReference::kCurrent;
        }
      },
      field.member);
}

std::string field_text(const Gains& gains, const GainField& field) {
  return std::visit(
      [&](auto member) -> std::string {
        const auto& value = gains.*member;
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, double>) {
          return fmt::format("{}", value);
        } else if constexpr (std::is_same_v<Value, Vec6> || std::is_same_v<Value, JointVector>) {
          return fmt::format("[{}]", fmt::join(value.data(), value.data() + value.size(), ", "));
        } else if constexpr (std::is_same_v<Value, bool>) {
          return value ? "true" : "false";
        } else {
          return value == SlerpReference::kStart ? "start" : "current";
        }
      },
      field.member);
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
  for (const GainField& field : gain_fields()) {
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
  for (const GainField& field : gain_fields()) {
    if (field.is_number() && numbers(gains, field).empty()) continue;
    text += fmt::format("  # {}{}{}{}\n  {}: {}\n", field.meaning, *field.unit ? " [" : "", field.unit,
                        *field.unit ? "]" : "", field.name, field_text(gains, field));
  }
  return text;
}

}  // namespace armtune

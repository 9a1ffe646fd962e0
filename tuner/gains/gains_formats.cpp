#include "tuner/gains/gains_formats.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "sim/scenario/gains_file.hpp"

namespace armtune::internal {
namespace {

/// Throws InputError if the node is not a valid ROS name. A name has letters, digits, _ and, between the
/// parts of a namespace, /.
void refuse_node(const std::string& node) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_allowed = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '/';
  };
  const bool begins_well = !node.empty() && (is_letter(node[0]) || node[0] == '/' || node[0] == '_');
  if (!begins_well || !std::all_of(node.begin(), node.end(), is_allowed)) {
    throw InputError(
        fmt::format("node '{}': not a valid ROS name; use letters, digits, '_' and '/', and do not start "
                    "with a digit",
                    node));
  }
}

std::vector<std::string> header_of(const GainsFile& file) {
  std::vector<std::string> lines;
  for (const auto& [what, words] : file.origin) lines.push_back(fmt::format("{}: {}", what, words));
  lines.emplace_back("order of six task-space numbers: x y z rx ry rz");
  lines.push_back(fmt::format("order of joint numbers: {}", fmt::join(file.joints, " ")));
  return lines;
}

GainsKeys keys_of(const GainsFile& file, GainsFormat format) {
  if (format == GainsFormat::kRos2) return {file.node.empty() ? "/**" : file.node, kRos2Parameters};
  return file.node.empty() ? kPublishedKeys : GainsKeys{file.node};
}

}  // namespace

const std::vector<std::string>& gains_format_names() {
  static const std::vector<std::string> names = {"yaml", "ros1", "ros2"};
  return names;
}

GainsFormat gains_format_from_name(const std::string& name) {
  const auto& names = gains_format_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    const std::string limit = fmt::format("one of: {}", fmt::join(names, ", "));
    throw InputError(fmt::format("'{}' is not a gains format; give {}", name, limit)).with_value(name, limit);
  }
  return static_cast<GainsFormat>(found - names.begin());
}

std::string gains_text(const GainsFile& file, GainsFormat format) {
  if (!file.node.empty()) refuse_node(file.node);
  return gains_yaml(file.gains, header_of(file), keys_of(file, format), file.others);
}

}  // namespace armtune::internal

#include "tuner/report/provenance.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal::report {
namespace {

/// Returns a scalar as it is written in the file.
std::string shown(const yaml::Node& node) {
  if (node.kind() == yaml::Node::Kind::kNull) return {};
  try {
    return node.as_string();
  } catch (const InputError&) {
    return fmt::format("{}", node.as_number());
  }
}

void flatten(const yaml::Node& node, const std::string& path,
             std::vector<std::pair<std::string, std::string>>& entries) {
  for (const auto& [key, value] : node.entries()) {
    const std::string name = path.empty() ? key : fmt::format("{}/{}", path, key);
    if (value.kind() == yaml::Node::Kind::kMap) {
      flatten(value, name, entries);
    } else {
      entries.emplace_back(name, shown(value));
    }
  }
}

}  // namespace

std::vector<std::pair<std::string, std::string>> read_provenance(const std::string& path) {
  std::vector<std::pair<std::string, std::string>> entries;
  flatten(yaml::parse_file(path), "", entries);
  return entries;
}

}  // namespace armtune::internal::report

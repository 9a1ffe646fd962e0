#include "sim/logs/builtin_schema.hpp"

#include <optional>
#include <utility>

#include "sim/logs/builtin_definitions.hpp"
#include "sim/logs/message_definition.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kTime = "builtin_interfaces/Time";
constexpr std::size_t kBoundary = 80;  ///< number of '=' between two definitions

void append(const std::string& type, std::string& schema) {
  if (!schema.empty()) schema += std::string(kBoundary, '=') + "\nMSG: " + type + "\n";
  schema += builtin_definitions(type).front();
}

}  // namespace

BagTopic builtin_topic(std::string name, const std::string& type) {
  std::string schema;
  const DefinitionLookup find = [&schema](const std::string& part) -> std::optional<DefinitionText> {
    const auto known = builtin_definitions(part);
    if (known.empty()) return std::nullopt;
    append(part, schema);
    return DefinitionText{std::string(known.front()), {}};
  };
  build_definition(type, find, InputPlace{.key = name});  // looks every type up once
  // A time is a basic type there. Other readers expect its definition.
  if (schema.find(kTime) != std::string::npos) append(kTime, schema);
  return {std::move(name), type, "cdr", std::move(schema), "ros2msg"};
}

}  // namespace armtune::internal

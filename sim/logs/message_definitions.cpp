#include "sim/logs/message_definitions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/common/message_text.hpp"
#include "sim/logs/builtin_definitions.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

/// True for "PACKAGE/TYPE" of letters, digits and underscores, which cannot lead out of a folder.
bool is_plain_type(const std::string& type) {
  const auto is_name = [](std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
  };
  const std::size_t slash = type.find('/');
  return slash != std::string::npos && is_name(std::string_view(type).substr(0, slash)) &&
         is_name(std::string_view(type).substr(slash + 1));
}

/// Returns the text of FOLDER/PACKAGE/msg/TYPE.msg; nothing if there is no such file.
std::optional<DefinitionText> text_in(const fs::path& folder, const std::string& type) {
  if (folder.empty() || !is_plain_type(type)) return std::nullopt;
  const std::size_t slash = type.find('/');
  const fs::path file = folder / type.substr(0, slash) / "msg" / (type.substr(slash + 1) + ".msg");
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  return DefinitionText{read_input_file(file.string(), kMostDefinitionBytes, "a .msg file"),
                        {file.string(), 1, {}}};
}

}  // namespace

MessageDefinitions::MessageDefinitions(fs::path msg_path) : msg_path_(std::move(msg_path)) {
  std::error_code ignored;
  if (!msg_path_.empty() && !fs::is_directory(msg_path_, ignored)) {
    throw InputError(
        InputPlace{msg_path_.string()},
        InputFault{.problem = "is not a folder", .limit = "a folder with files PACKAGE/msg/TYPE.msg"});
  }
}

std::vector<MessageDefinition> MessageDefinitions::of(const BagTopic& topic, const std::string& file) const {
  const InputPlace place{file, 0, topic.name};
  const std::string type = short_type(topic.type);
  if (topic.schema_encoding == "ros2msg" && !topic.schema.empty())
    return {parse_ros2msg(topic.schema, type, place)};
  std::vector<MessageDefinition> found;
  const auto add = [&](const std::optional<DefinitionText>& own) {
    const DefinitionLookup find = [&](const std::string& name) -> std::optional<DefinitionText> {
      if (name == type) return own;
      if (auto text = text_in(msg_path_, name)) return text;
      const auto builtin = builtin_definitions(name);
      if (builtin.empty()) return std::nullopt;
      return DefinitionText{std::string(builtin.front()), place};
    };
    found.push_back(build_definition(type, find, place));
  };
  if (const auto text = text_in(msg_path_, type)) add(text);
  for (const std::string_view text : builtin_definitions(type)) add(DefinitionText{std::string(text), place});
  if (!found.empty()) return found;
  const std::string why = topic.schema_encoding.empty()
                              ? std::string("the bag holds no schema")
                              : fmt::format("schemas in {} are not read", shown(topic.schema_encoding));
  throw InputError(place, InputFault{.problem = fmt::format(
                                         "topic {} has the type {}, which is not built in, and {}; give the "
                                         "folder with its package by --msg-path",
                                         shown(topic.name), shown(topic.type), why),
                                     .value = topic.type});
}

}  // namespace armtune::internal

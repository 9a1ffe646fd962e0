#include "sim/logs/message_definition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "core/common/input_place.hpp"
#include "core/common/message_text.hpp"
#include "sim/logs/definition_line.hpp"

namespace armtune::internal {
namespace {

/// Builds the types of a definition depth first, so that a type which contains itself is met while it is
/// open.
class DefinitionBuilder {
 public:
  explicit DefinitionBuilder(const DefinitionLookup& find) : find_(find) {}

  /// Returns the index of the type, which is added with all that it contains if it is new.
  std::size_t add(const std::string& name, const InputPlace& place) {
    if (const auto known = indices_.find(name); known != indices_.end()) {
      if (std::find(open_.begin(), open_.end(), name) == open_.end()) return known->second;
      throw InputError(place,
                       InputFault{.problem = fmt::format("the message type {} contains itself", shown(name)),
                                  .value = name});
    }
    check_room(name, place);
    const std::optional<DefinitionText> text = find_(name);
    if (!text) {
      throw InputError(place, InputFault{.problem = fmt::format(
                                             "the message type {} is not known; give the folder with its "
                                             "package by --msg-path",
                                             shown(name)),
                                         .value = name});
    }
    if (text->text.size() > kMostDefinitionBytes) {
      throw InputError(text->place,
                       InputFault{.problem = fmt::format("the definition of {} is too long", shown(name)),
                                  .limit = fmt::format("at most {} MB", kMostDefinitionBytes >> 20U)});
    }
    const std::size_t index = definition_.types.size();
    indices_[name] = index;
    open_.push_back(name);
    definition_.types.push_back({name, {}});
    add_fields(index, *text);
    open_.pop_back();
    return index;
  }

  MessageDefinition definition() && { return std::move(definition_); }

 private:
  void check_room(const std::string& name, const InputPlace& place) const {
    if (open_.size() >= kDeepestType || definition_.types.size() >= kMostMessageTypes) {
      throw InputError(place, InputFault{.problem = fmt::format("the message type {} contains too many types",
                                                                shown(open_.empty() ? name : open_.front())),
                                         .limit = fmt::format("at most {} types, nested {} deep",
                                                              kMostMessageTypes, kDeepestType)});
    }
  }

  void add_fields(std::size_t index, const DefinitionText& text) {
    const std::string name = definition_.types[index].name;
    std::string_view rest = text.text;
    for (long line = 1; !rest.empty(); ++line) {
      const std::string_view content = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(content.size() + 1, rest.size()));
      const bool is_file = text.place.line > 0;
      const InputPlace here = is_file ? at_line(text.place.file, line, text.place.key) : text.place;
      try {
        if (auto declared = parse_definition_line(content)) add_field(index, std::move(*declared), here);
      } catch (const DefinitionFault& error) {
        InputFault fault = error.fault();
        if (!is_file)
          fault.problem =
              fmt::format("line {} of the definition of {}: {}", line, shown(name), fault.problem);
        throw InputError(here, std::move(fault));
      }
    }
    // An empty struct is serialised as one byte (rosidl: structure_needs_at_least_one_member).
    if (definition_.types[index].fields.empty()) {
      definition_.types[index].fields.push_back(
          {.name = "structure_needs_at_least_one_member", .kind = FieldKind::kUint8});
    }
  }

  void add_field(std::size_t index, DeclaredField declared, const InputPlace& place) {
    if (++fields_ > kMostFields) {
      throw DefinitionFault(InputFault{.problem = "the message type has too many fields",
                                       .limit = fmt::format("at most {}", kMostFields)});
    }
    MessageField& field = declared.field;
    if (!names_.insert({{index, field.name}, true}).second)
      throw DefinitionFault(InputFault{
          .problem = fmt::format("two fields have the name {}", shown(field.name)), .value = field.name});
    if (field.kind == FieldKind::kStruct) {
      const std::string type = full_name(declared.type, definition_.types[index].name);
      if (type == "builtin_interfaces/Time") {
        field.kind = FieldKind::kTime;
      } else if (type == "builtin_interfaces/Duration") {
        field.kind = FieldKind::kDuration;
      } else {
        field.type = add(type, place);
      }
    }
    definition_.types[index].fields.push_back(std::move(field));
  }

  /// A type without a package is of the same package as the type that contains it.
  static std::string full_name(const std::string& type, const std::string& container) {
    if (type.find('/') != std::string::npos) return short_type(type);
    if (type == "Header") return "std_msgs/Header";
    return container.substr(0, container.find('/') + 1) + type;
  }

  const DefinitionLookup& find_;
  MessageDefinition definition_;
  std::map<std::string, std::size_t> indices_;
  std::map<std::pair<std::size_t, std::string>, bool> names_;  // of fields, by type
  std::vector<std::string> open_;
  std::size_t fields_ = 0;
};

/// True for a line of at least 80 '=': the boundary of two definitions.
bool is_boundary(std::string_view line) {
  constexpr std::size_t kWidth = 80;
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  return line.size() >= kWidth && line.find_first_not_of('=') == std::string_view::npos;
}

/// Returns the texts of all types in a schema, by name.
std::map<std::string, std::string> texts_of(std::string_view schema, const std::string& type,
                                            const InputPlace& place) {
  constexpr std::string_view kHead = "MSG: ";
  std::map<std::string, std::string> texts;
  std::string* text = &texts[type];
  bool is_head = false;
  while (!schema.empty()) {
    const std::string_view line = schema.substr(0, schema.find('\n'));
    schema.remove_prefix(std::min(line.size() + 1, schema.size()));
    if (is_head) {
      is_head = false;
      if (!line.starts_with(kHead)) {
        throw InputError(
            place,
            InputFault{.problem = fmt::format(
                           "the schema of {} has a line of '=' that is not followed by the name of a type",
                           shown(type)),
                       .value = std::string(line),
                       .limit = "MSG: PACKAGE/TYPE"});
      }
      const std::string_view name = line.substr(kHead.size());
      text = &texts[short_type(std::string(name.substr(0, name.find_last_not_of(" \r\t") + 1)))];
      text->clear();
    } else if (is_boundary(line)) {
      is_head = true;
    } else {
      text->append(line).append("\n");
    }
    if (texts.size() > kMostMessageTypes) {
      throw InputError(
          place, InputFault{.problem = fmt::format("the schema of {} defines too many types", shown(type)),
                            .limit = fmt::format("at most {}", kMostMessageTypes)});
    }
  }
  return texts;
}

}  // namespace

std::string short_type(const std::string& type) {
  const std::size_t first = type.find('/');
  const std::size_t last = type.rfind('/');
  const bool is_long = first != std::string::npos && type.substr(first, last - first) == "/msg";
  return is_long ? type.substr(0, first) + type.substr(last) : type;
}

MessageDefinition build_definition(const std::string& type, const DefinitionLookup& find,
                                   const InputPlace& place) {
  DefinitionBuilder builder(find);
  builder.add(short_type(type), place);
  return std::move(builder).definition();
}

MessageDefinition parse_ros2msg(const std::string& schema, const std::string& type, const InputPlace& place) {
  if (schema.size() > kMostDefinitionBytes) {
    throw InputError(place, InputFault{.problem = fmt::format("the schema of {} is too long", shown(type)),
                                       .limit = fmt::format("at most {} MB", kMostDefinitionBytes >> 20U)});
  }
  const auto texts = texts_of(schema, short_type(type), place);
  const DefinitionLookup find = [&](const std::string& name) -> std::optional<DefinitionText> {
    const auto known = texts.find(name);
    if (known == texts.end()) return std::nullopt;
    return DefinitionText{known->second, place};
  };
  return build_definition(type, find, place);
}

}  // namespace armtune::internal

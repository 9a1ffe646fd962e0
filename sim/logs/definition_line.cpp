#include "sim/logs/definition_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/common/message_text.hpp"

namespace armtune::internal {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";
constexpr std::size_t kLongestName = 128;

constexpr std::array<std::pair<std::string_view, FieldKind>, 15> kKinds = {{
    {"bool", FieldKind::kBool},
    {"byte", FieldKind::kUint8},
    {"char", FieldKind::kUint8},
    {"int8", FieldKind::kInt8},
    {"uint8", FieldKind::kUint8},
    {"int16", FieldKind::kInt16},
    {"uint16", FieldKind::kUint16},
    {"int32", FieldKind::kInt32},
    {"uint32", FieldKind::kUint32},
    {"int64", FieldKind::kInt64},
    {"uint64", FieldKind::kUint64},
    {"float32", FieldKind::kFloat32},
    {"float64", FieldKind::kFloat64},
    {"string", FieldKind::kString},
    {"wstring", FieldKind::kWstring},
}};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_name_character(char c) {
  return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
}

/// True for a name of a field, a package or a type.
bool is_name(std::string_view text) {
  return !text.empty() && text.size() <= kLongestName && (is_letter(text.front()) || text.front() == '_') &&
         std::all_of(text.begin(), text.end(), is_name_character);
}

/// True for "TYPE", "PACKAGE/TYPE" and "PACKAGE/msg/TYPE".
bool is_type_name(std::string_view text) {
  for (int parts = 0; parts < 3; ++parts) {
    const std::size_t slash = text.find('/');
    if (!is_name(text.substr(0, slash))) return false;
    if (slash == std::string_view::npos) return true;
    text.remove_prefix(slash + 1);
  }
  return false;
}

void skip_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
}

/// Returns the number that `text` is; a size must be from 1 to `most`.
std::size_t size_of(std::string_view text, std::size_t most) {
  std::size_t size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  if (error != std::errc{} || end != text.data() + text.size() || size == 0 || size > most) {
    throw DefinitionFault(InputFault{.problem = fmt::format("the size {} is not valid", shown(text)),
                                     .value = std::string(text),
                                     .limit = fmt::format("1 to {}", most)});
  }
  return size;
}

/// Reads "<=N" from the beginning of `text`, up to `end`; leaves `text` unchanged without it.
std::size_t bound_at(std::string_view& text, std::string_view end) {
  if (!text.starts_with("<=")) return 0;
  const std::size_t length = std::min(text.find_first_of(end), text.size());
  const std::size_t bound = size_of(text.substr(2, length - 2), std::numeric_limits<std::uint32_t>::max());
  text.remove_prefix(length);
  return bound;
}

/// Sets the shape from what follows the name of the type: nothing, "[]", "[N]" or "[<=N]".
void read_shape(std::string_view text, MessageField& field) {
  if (text.empty()) return;
  const auto fail = [&] {
    throw DefinitionFault(InputFault{.problem = fmt::format("{} is not valid after a type", shown(text)),
                                     .value = std::string(text),
                                     .limit = "[], [N] or [<=N]"});
  };
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') fail();
  text = text.substr(1, text.size() - 2);
  field.shape = FieldShape::kSequence;
  if (text.empty()) return;
  field.size = bound_at(text, {});
  if (field.size > 0) return;
  field.shape = FieldShape::kArray;
  field.size = size_of(text, kLargestArray);
}

DeclaredField read_type(std::string_view word) {
  DeclaredField declared;
  const std::string_view base = word.substr(0, word.find_first_of("[<"));
  std::string_view rest = word.substr(base.size());
  const auto known =
      std::find_if(kKinds.begin(), kKinds.end(), [base](const auto& kind) { return kind.first == base; });
  MessageField& field = declared.field;
  if (known == kKinds.end()) {
    if (!is_type_name(base)) {
      throw DefinitionFault(InputFault{.problem = fmt::format("{} is not the name of a type", shown(base)),
                                       .value = std::string(base)});
    }
    field.kind = FieldKind::kStruct;
    declared.type = base;
  } else {
    field.kind = known->second;
  }
  if (field.kind == FieldKind::kString || field.kind == FieldKind::kWstring)
    field.string_size = bound_at(rest, "[");
  read_shape(rest, field);
  return declared;
}

}  // namespace

std::optional<DeclaredField> parse_definition_line(std::string_view line) {
  skip_blanks(line);
  if (line.empty() || line.front() == '#') return std::nullopt;
  const std::string_view type = line.substr(0, line.find_first_of(kBlanks));
  line.remove_prefix(type.size());
  skip_blanks(line);
  const auto end = std::find_if_not(line.begin(), line.end(), is_name_character);
  const std::string_view name = line.substr(0, static_cast<std::size_t>(end - line.begin()));
  line.remove_prefix(name.size());
  if (!is_name(name) || !(line.empty() || line.front() == '=' || line.front() == '#' ||
                          kBlanks.find(line.front()) != std::string_view::npos)) {
    throw DefinitionFault(
        InputFault{.problem = fmt::format("the type {} is not followed by the name of a field", shown(type)),
                   .value = std::string(name),
                   .limit = "a type and a name"});
  }
  DeclaredField declared = read_type(type);
  skip_blanks(line);
  if (line.starts_with('=')) return std::nullopt;  // a constant is not part of a message
  declared.field.name = name;
  return declared;
}

}  // namespace armtune::internal

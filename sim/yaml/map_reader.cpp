#include "sim/yaml/map_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/common/nearest.hpp"
#include "sim/yaml/source_text.hpp"

namespace armtune::internal::yaml {
namespace {

std::string limits(double lower, double upper) {
  if (std::isinf(upper)) return fmt::format("at least {}", lower);
  if (std::isinf(lower)) return fmt::format("at most {}", upper);
  return fmt::format("{} to {}", lower, upper);
}

}  // namespace

MapReader::MapReader(const Node& map) : map_(map) {
  map.entries();
}

bool MapReader::is_known(std::string_view key) const {
  return std::find(known_.begin(), known_.end(), key) != known_.end();
}

void MapReader::ignore(std::string_view key) {
  if (!is_known(key)) known_.emplace_back(key);
}

const Node* MapReader::optional(std::string_view key) {
  ignore(key);
  return map_.find(key);
}

const Node& MapReader::required(std::string_view key) {
  if (const Node* value = optional(key)) return *value;
  const std::string misspelt = nearest(key, unread());
  const std::string& path = map_.key_path();
  map_.fail(fmt::format("missing key '{}' in {}{}", key, path.empty() ? "the document" : "'" + path + "'",
                        misspelt.empty() ? "" : "; is '" + misspelt + "' a misspelling of it?"),
            fmt::format("the key '{}'", key));
}

void MapReader::none_of(std::initializer_list<std::string_view> keys) const {
  std::string hint;
  for (const std::string_view key : keys) {
    const std::string misspelt = nearest(key, unread());
    if (hint.empty() && !misspelt.empty())
      hint = fmt::format("; is '{}' a misspelling of '{}'?", misspelt, key);
  }
  const std::string names = fmt::format("{}", fmt::join(keys, ", "));
  map_.fail(fmt::format("one of these keys must be given: {}{}", names, hint),
            fmt::format("one of the keys: {}", names));
}

// Returns the keys of the file that are not known. One of them may be the misspelling of a missing key. Only
// finish() reports unknown keys, and after the error for a missing key it is not called.
std::vector<std::string> MapReader::unread() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : map_.entries()) {
    if (!is_known(name)) names.push_back(name);
  }
  return names;
}

bool MapReader::has(std::string_view key) {
  return optional(key) != nullptr;
}

double MapReader::number(std::string_view key) {
  return required(key).as_number();
}

double MapReader::number(std::string_view key, double default_value) {
  const Node* value = optional(key);
  return value ? value->as_number() : default_value;
}

double MapReader::number_in(std::string_view key, double default_value, double lower, double upper) {
  const Node* value = optional(key);
  if (!value) return default_value;
  const double number = value->as_number();
  if (number < lower || number > upper) {
    value->fail(
        InputFault{.problem = fmt::format("{} is out of range", number), .limit = limits(lower, upper)});
  }
  return number;
}

long MapReader::integer(std::string_view key, long default_value) {
  const Node* value = optional(key);
  return value ? value->as_integer() : default_value;
}

bool MapReader::boolean(std::string_view key, bool default_value) {
  const Node* value = optional(key);
  return value ? value->as_boolean() : default_value;
}

std::string MapReader::string(std::string_view key, const std::string& default_value) {
  const Node* value = optional(key);
  return value ? value->as_string() : default_value;
}

void MapReader::finish() const {
  for (const auto& [key, value] : map_.entries()) {
    if (is_known(key)) continue;
    const std::string known = known_.empty() ? "none" : fmt::format("{}", fmt::join(known_, ", "));
    throw error_at(
        value.file(), value.line(), value.key_path(),
        {.problem = fmt::format("unknown key '{}'{}; known keys: {}", key, suggestion(key, known_), known)})
        .with_value(key, fmt::format("the keys: {}", known));
  }
}

}  // namespace armtune::internal::yaml

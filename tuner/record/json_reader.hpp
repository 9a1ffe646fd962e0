#pragma once
// Reads objects from JSON. The members of their types are declared as in declaration.hpp. The reader uses the
// YAML reader, because JSON is a subset of YAML. Therefore the size limits of YAML files apply, and errors
// name file, line and key.

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/yaml/map_reader.hpp"
#include "tuner/record/declaration.hpp"

namespace armtune::internal::record {

template <typename T>
void read(const yaml::Node& node, T& value);

/// Returns the index of the node's word in `words`. If it is not among them, throws InputError that lists the
/// allowed words.
inline std::size_t index_of_word(const yaml::Node& node, const std::vector<std::string>& words) {
  const std::string word = node.as_string();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string all;
  for (const std::string& allowed : words) all += (all.empty() ? "" : ", ") + allowed;
  node.fail("'" + word + "' is not an allowed word; expected one of " + all, "one of: " + all);
}

/// A visitor that reads the members that `declare` visits. It skips values that are computed from others.
class JsonReader {
 public:
  explicit JsonReader(yaml::MapReader& map) : map_(map) {}

  JsonReader& type(const char*, const char* = "") { return *this; }

  template <typename T>
  JsonReader& operator()(const char* key, T& value, const char* = "", Presence presence = Presence::kAlways) {
    const yaml::Node* node = find(key, presence);
    if (node != nullptr) read(*node, value);
    return *this;
  }
  template <typename T>
  JsonReader& operator()(const char* key, const T&&) {
    map_.ignore(key);
    return *this;
  }
  template <typename T>
  JsonReader& operator()(const char* key, T& value, Words words, const char* = "",
                         Presence presence = Presence::kAlways) {
    const yaml::Node* node = find(key, presence);
    if (node == nullptr) return *this;
    const std::size_t index = index_of_word(*node, {words.begin(), words.end()});
    if constexpr (std::is_same_v<T, bool>) value = index == 1;
    if constexpr (Text<T>) value = words.begin()[index];
    return *this;
  }

 private:
  const yaml::Node* find(const char* key, Presence presence) {
    const bool absent = presence == Presence::kIfAny || presence == Presence::kLater;
    return absent ? map_.optional(key) : &map_.required(key);
  }

  yaml::MapReader& map_;
};

/// Reads a value. Throws InputError that names file, line, key and value, and states what is expected. A key
/// that is not declared is an error too. A type without a declaration needs its own function `read`.
template <typename T>
void read(const yaml::Node& node, T& value) {
  if constexpr (std::is_enum_v<T>) {
    value = static_cast<T>(index_of_word(node, names_of<T>()));
  } else if constexpr (std::is_same_v<T, bool>) {
    value = node.as_boolean();
  } else if constexpr (std::is_floating_point_v<T>) {
    value = node.as_number();
  } else if constexpr (std::is_integral_v<T>) {
    const long number = node.as_integer();
    if (!std::in_range<T>(number)) node.fail(std::to_string(number) + " is out of range");
    value = static_cast<T>(number);
  } else if constexpr (Text<T>) {
    value = node.as_string();
  } else if constexpr (Optional<T>) {
    value.reset();
    if (node.kind() != yaml::Node::Kind::kNull) read(node, value.emplace());
  } else if constexpr (Vector<T>) {
    const auto numbers = node.as_numbers(T::RowsAtCompileTime);
    std::copy(numbers.begin(), numbers.end(), value.begin());
  } else if constexpr (Quaternion<T>) {
    const auto q = node.as_numbers(4);
    value = T(q[0], q[1], q[2], q[3]);
  } else if constexpr (List<T>) {
    value.clear();
    for (const yaml::Node& item : node.items()) read(item, value.emplace_back());
  } else {
    yaml::MapReader map(node);
    JsonReader fields(map);
    declare(fields, value);
    map.finish();
  }
}

}  // namespace armtune::internal::record

#pragma once
// Writes objects as JSON. Each type must first declare its members (declaration.hpp).

#include <utility>

#include "tuner/record/declaration.hpp"
#include "tuner/record/json_scalar.hpp"

namespace armtune::internal::record {

template <typename T>
void write(std::string& out, const T& value);

/// A visitor that appends the members that `declare` visits to a JSON text.
class JsonWriter {
 public:
  explicit JsonWriter(std::string& out) : out_(out) {}

  JsonWriter& type(const char*, const char* = "") { return *this; }

  template <typename T>
  JsonWriter& operator()(const char* key, const T& value, const char* = "",
                         Presence presence = Presence::kAlways) {
    if (presence == Presence::kIfAny && is_empty(value)) return *this;
    out_ += (std::exchange(separate_, true) ? "," : "") + json_scalar(key) + ':';
    write(out_, value);
    return *this;
  }
  template <typename T>
  JsonWriter& operator()(const char* key, const T& value, Words words, const char* = "",
                         Presence presence = Presence::kAlways) {
    if constexpr (std::is_same_v<T, bool>) return (*this)(key, words.begin()[value ? 1 : 0]);
    return (*this)(key, value, "", presence);
  }

 private:
  std::string& out_;
  bool separate_ = false;
};

/// Appends a value to a JSON text. A type that is neither declared nor one of the kinds of members that
/// declaration.hpp lists needs its own function `write`.
template <typename T>
void write(std::string& out, const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    out += value ? "true" : "false";
  } else if constexpr (std::is_integral_v<T>) {
    out += std::to_string(value);
  } else if constexpr (std::is_enum_v<T>) {
    out += json_scalar(name(value));
  } else if constexpr (std::is_arithmetic_v<T> || Text<T>) {
    out += json_scalar(value);
  } else if constexpr (Optional<T>) {
    value ? write(out, *value) : void(out += "null");
  } else if constexpr (List<T>) {
    out += '[';
    bool separate = false;
    for (const auto& item : value) {
      if (std::exchange(separate, true)) out += ',';
      write(out, item);
    }
    out += ']';
  } else if constexpr (Pair<T>) {
    write(out += '[', value.first);
    write(out += ',', value.second);
    out += ']';
  } else if constexpr (Quaternion<T>) {
    write(out, std::vector<double>{value.w(), value.x(), value.y(), value.z()});
  } else {
    JsonWriter fields(out += '{');
    declare(fields, value);
    out += '}';
  }
}

/// Returns the JSON text of one value.
template <typename T>
std::string json_of(const T& value) {
  std::string text;
  write(text, value);
  return text;
}

}  // namespace armtune::internal::record

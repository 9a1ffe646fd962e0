#include "tuner/report/json.hpp"

#include <fmt/format.h>

#include <cmath>

namespace armtune::report {

std::string json_quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == '<' || c == 0x7f) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  return out + '"';
}

void Json::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

void Json::begin_object() {
  separate();
  text_ += '{';
  first_ = true;
}

void Json::end_object() {
  text_ += '}';
  first_ = false;
}

void Json::begin_array() {
  separate();
  text_ += '[';
  first_ = true;
}

void Json::end_array() {
  text_ += ']';
  first_ = false;
}

void Json::key(std::string_view name) {
  separate();
  text_ += json_quoted(name);
  text_ += ": ";
  first_ = true;
}

void Json::number(double value) {
  if (!std::isfinite(value)) {
    null();
    return;
  }
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", value);
}

void Json::integer(long value) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", value);
}

void Json::boolean(bool value) {
  separate();
  text_ += value ? "true" : "false";
}

void Json::text(std::string_view value) {
  separate();
  text_ += json_quoted(value);
}

void Json::null() {
  separate();
  text_ += "null";
}

void Json::texts(const std::vector<std::string>& values) {
  begin_array();
  for (const std::string& value : values) text(value);
  end_array();
}

void Json::numbers(const std::vector<double>& values) {
  begin_array();
  for (const double value : values) number(value);
  end_array();
}

void Json::number(std::string_view name, double value) {
  key(name);
  number(value);
}

void Json::number(std::string_view name, const std::optional<double>& value) {
  key(name);
  value ? number(*value) : null();
}

void Json::integer(std::string_view name, long value) {
  key(name);
  integer(value);
}

void Json::boolean(std::string_view name, bool value) {
  key(name);
  boolean(value);
}

void Json::text(std::string_view name, std::string_view value) {
  key(name);
  text(value);
}

void Json::texts(std::string_view name, const std::vector<std::string>& values) {
  key(name);
  texts(values);
}

void Json::numbers(std::string_view name, const std::vector<double>& values) {
  key(name);
  numbers(values);
}

}  // namespace armtune::report

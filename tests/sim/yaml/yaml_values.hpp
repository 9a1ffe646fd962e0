#pragma once
// What the tests of the YAML reader share: values, and the messages that reading them gives.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <clocale>
#include <filesystem>
#include <fstream>
#include <functional>
#include <locale>
#include <string>

#include "armtune/error.hpp"
#include "sim/yaml/document.hpp"
#include "tests/core/support/refused_at.hpp"

namespace armtune::internal::yaml::test {

using internal::test::input_error;
using internal::test::refused_at;

inline std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    internal::test::expect_place(error);
    EXPECT_NE(error.place().file, "") << error.what();
    return error.what();
  }
  return "no error";
}

/// Message of the error that parsing `text` as "in.yaml" gives.
inline std::string parse_error(const std::string& text) {
  return error_of([&] { parse_text(text, "in.yaml"); });
}

inline InputError parse_refusal(const std::string& text) {
  return input_error([&] { parse_text(text, "in.yaml"); });
}

/// The error that `read` gives on the value of key x, and its message.
template <typename Read>
inline InputError read_refusal(const std::string& value, Read read) {
  const Node root = parse_text("x: " + value, "in.yaml");
  return input_error([&] { read(*root.find("x")); });
}
template <typename Read>
inline std::string read_error(const std::string& value, Read read) {
  const Node root = parse_text("x: " + value, "in.yaml");
  return error_of([&] { read(*root.find("x")); });
}
inline constexpr auto as_string = [](const Node& node) { node.as_string(); };
inline constexpr auto as_number = [](const Node& node) { node.as_number(); };
inline constexpr auto as_integer = [](const Node& node) { node.as_integer(); };
inline constexpr auto as_boolean = [](const Node& node) { node.as_boolean(); };

inline double number(const std::string& value) {
  return parse_text("x: " + value, "in.yaml").find("x")->as_number();
}
inline long integer(const std::string& value) {
  return parse_text("x: " + value, "in.yaml").find("x")->as_integer();
}
inline std::string string(const std::string& value) {
  return parse_text("x: " + value, "in.yaml").find("x")->as_string();
}

inline std::string repeat(const std::string& part, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += part;
  return text;
}

/// A value as messages show it.
inline std::string quoted(const std::string& value) {
  return fmt::format("'{}'", value);
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text) : path_(testing::TempDir() + name) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// German numbers for the whole process: the system's locale where it is installed, the C++ one always.
class CommaLocale {
 public:
  CommaLocale() : before_(std::locale::global(std::locale(std::locale::classic(), new German))) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE"}) {
      if (std::setlocale(LC_ALL, name) != nullptr) break;
    }
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;
  ~CommaLocale() {
    std::locale::global(before_);
    std::setlocale(LC_ALL, "C");
  }

 private:
  struct German : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::locale before_;
};

}  // namespace armtune::internal::yaml::test

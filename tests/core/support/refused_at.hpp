#pragma once
// Checks the fields of an InputError: its place in the input, the value that is refused and the limit.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"

namespace armtune::internal::test {

/// Expects the message to be one line that begins with the file and the line of the fields.
inline void expect_place(const InputError& error) {
  const std::string message = error.what();
  const auto& [file, line, key] = error.place();
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  if (!file.empty()) {
    const std::string begin = one_line(line > 0 ? file + ":" + std::to_string(line) + ": " : file + ": ");
    EXPECT_TRUE(message.starts_with(begin)) << message << "\nbegins otherwise than " << begin;
  }
  const std::size_t number = message.find(':') + 1;
  const std::size_t end = message.find_first_not_of("0123456789", number);
  if (number > 0 && end > number && end != std::string::npos && message.substr(end, 2) == ": ") {
    EXPECT_GT(line, 0) << "no line as a field: " << message;
  }
}

/// Returns the InputError with which `action` ends, or "nothing was refused" without fields.
template <typename Action>
InputError input_error(Action&& action) {
  try {
    static_cast<void>(action());
  } catch (const InputError& error) {
    expect_place(error);
    return error;
  }
  return InputError("nothing was refused");
}

/// Returns the known name that the message suggests in place of a misspelt one, or an empty text.
inline std::string suggested_by(const InputError& error) {
  const std::string_view message = error.what();
  constexpr std::string_view kBegin = " (did you mean '";
  const std::size_t at = message.find(kBegin);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = message.substr(at + kBegin.size());
  return std::string(rest.substr(0, rest.find("'?)")));
}

/// The fields that refused_at() compares. Each takes a value or a matcher; one that is left out is not
/// compared.
struct RefusedFields {
  testing::Matcher<std::string> file = testing::_;
  testing::Matcher<long> line = testing::_;
  testing::Matcher<std::string> key = testing::_;
  testing::Matcher<std::string> value = testing::_;
  testing::Matcher<std::string> limit = testing::_;
  testing::Matcher<std::string> suggestion = testing::_;  ///< see suggested_by()
};

/// Matches an InputError, or a function that throws one, by the fields of the error.
class RefusedAt {
 public:
  using is_gtest_matcher = void;

  explicit RefusedAt(RefusedFields fields) : fields_(std::move(fields)) {}

  template <typename Actual>
  bool MatchAndExplain(const Actual& actual, std::ostream* explanation) const {
    if constexpr (std::is_invocable_v<const Actual&>) {
      return matches(input_error(actual), explanation);
    } else {
      return matches(actual, explanation);
    }
  }

  void DescribeTo(std::ostream* text) const { describe(*text << "is refused with"); }
  void DescribeNegationTo(std::ostream* text) const { describe(*text << "is not refused with"); }

 private:
  void describe(std::ostream& text) const {
    const auto add = [&text](const char* name, const auto& matcher) {
      matcher.DescribeTo(&(text << " " << name << " that "));
    };
    add("a file", fields_.file);
    add("a line", fields_.line);
    add("a key", fields_.key);
    add("a value", fields_.value);
    add("a limit", fields_.limit);
    add("a suggestion", fields_.suggestion);
  }

  bool matches(const InputError& error, std::ostream* explanation) const {
    if (explanation != nullptr) {
      *explanation << "whose message is: " << error.what() << "\n  file: " << error.place().file
                   << "\n  line: " << error.place().line << "\n  key: " << error.place().key
                   << "\n  value: " << error.value() << "\n  limit: " << error.limit();
    }
    return error.what() != std::string_view("nothing was refused") &&
           fields_.file.Matches(error.place().file) && fields_.line.Matches(error.place().line) &&
           fields_.key.Matches(error.place().key) && fields_.value.Matches(error.value()) &&
           fields_.limit.Matches(error.limit()) && fields_.suggestion.Matches(suggested_by(error));
  }

  RefusedFields fields_;
};

/// For example: EXPECT_THAT([&] { read(path); }, refused_at({.file = path, .line = 3, .value = "x7"})).
inline RefusedAt refused_at(RefusedFields fields) {
  return RefusedAt(std::move(fields));
}

}  // namespace armtune::internal::test

// Implements the typed reads of Node.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "core/common/message_text.hpp"
#include "sim/yaml/document.hpp"
#include "sim/yaml/source_text.hpp"

namespace armtune::internal::yaml {
namespace {

/// Converts the whole of `text` by std::from_chars, without locale, octal numbers or spaces. Unlike
/// std::from_chars, it accepts a leading '+'.
template <typename T>
std::errc convert(std::string_view text, T& value) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char* const first = text.data() + (plus ? 1 : 0);
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(first, last, value);
  return end == last || error == std::errc::invalid_argument ? error : std::errc::invalid_argument;
}

/// Returns an integer with leading zeros without these zeros. Returns an empty text for any other text.
std::string without_leading_zeros(std::string_view text) {
  const bool sign = !text.empty() && (text[0] == '-' || text[0] == '+');
  const std::string_view digits = text.substr(sign ? 1 : 0);
  const bool is_integer = digits.find_first_not_of("0123456789") == std::string_view::npos;
  if (!is_integer || digits.size() < 2 || digits[0] != '0') return {};
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  return fmt::format("{}{}", text[0] == '-' ? "-" : "", digits.substr(first));
}

void refuse_leading_zeros(const Node& node, std::string_view text) {
  const std::string decimal = without_leading_zeros(text);
  if (decimal.empty()) return;
  node.fail(fmt::format("{} has a leading zero, which makes it octal for some YAML readers; write {}",
                        shown(text), decimal),
            decimal);
}

}  // namespace

void Node::fail(const std::string& what, const std::string& limit) const {
  throw error_at(*file_, line_, key_path_, {.problem = what}).with_value(text_, limit);
}

void Node::fail(InputFault fault) const {
  if (fault.value.empty()) fault.value = text_;
  throw error_at(*file_, line_, key_path_, std::move(fault));
}

void Node::fail_choice(const std::vector<std::string>& known) const {
  const std::string limit = fmt::format("one of: {}", fmt::join(known, ", "));
  fail(fmt::format("'{}' is not {}", as_string(), limit), limit);
}

std::string Node::description() const {
  switch (kind_) {
    case Kind::kNull:
      return "the value is empty";
    case Kind::kSequence:
      return fmt::format("the value is a list of {}", items_.size());
    case Kind::kMap:
      return "the value is a map";
    case Kind::kScalar:
      break;
  }
  return is_text_ ? fmt::format("{} is a quoted text", shown(text_))
                  : fmt::format("the value is {}", shown(text_));
}

const std::string& Node::plain_text(const std::string& expected) const {
  if (kind_ != Kind::kScalar) fail(InputFault{.problem = description(), .limit = expected});
  if (is_text_) fail(InputFault{.problem = description(), .limit = expected + ", without quotes"});
  return text_;
}

std::string Node::as_string() const {
  if (kind_ != Kind::kScalar) fail(InputFault{.problem = description(), .limit = "a text"});
  double number = 0.0;
  const bool is_number = convert(text_, number) == std::errc() && std::isfinite(number);
  if (!is_text_ && (is_number || text_ == "true" || text_ == "false")) {
    fail(fmt::format("{0} is a {1}, but a text is expected; write it in quotes: \"{2}\"", shown(text_),
                     is_number ? "number" : "boolean", text_),
         "a text");
  }
  return text_;
}

double Node::as_number() const {
  const std::string& text = plain_text("a number");
  refuse_leading_zeros(*this, text);
  double value = 0.0;
  const std::errc error = convert(text, value);
  if (error == std::errc::result_out_of_range) {
    fail(InputFault{.problem = shown(text) + " does not fit a double",
                    .limit = "a magnitude from 1e-307 to 1e308, or 0"});
  }
  if (error != std::errc()) {
    fail(InputFault{.problem = shown(text) + " is not a number",
                    .limit = "a decimal number with '.' and no unit, such as -1.5 or 1e3"});
  }
  if (!std::isfinite(value))
    fail(InputFault{.problem = shown(text) + " is not finite", .limit = "a finite number"});
  return value;
}

long Node::as_integer() const {
  const std::string& text = plain_text("an integer");
  refuse_leading_zeros(*this, text);
  long value = 0;
  const std::errc error = convert(text, value);
  if (error == std::errc::result_out_of_range)
    fail(InputFault{.problem = shown(text) + " does not fit 64 bit", .limit = "a smaller integer"});
  if (error != std::errc()) {
    fail(InputFault{.problem = shown(text) + " is not an integer",
                    .limit = "decimal digits only, without point, exponent or unit"});
  }
  return value;
}

bool Node::as_boolean() const {
  const std::string limit = "true or false";
  const std::string& text = plain_text(limit);
  if (text == "true") return true;
  if (text == "false") return false;
  for (const auto& [meant, spellings] : {std::pair("true", " yes Yes YES on On ON y Y True TRUE 1 "),
                                         std::pair("false", " no No NO off Off OFF n N False FALSE 0 ")}) {
    if (std::string_view(spellings).find(" " + text + " ") != std::string_view::npos) {
      fail(fmt::format("{} is not a boolean here; write {}", shown(text), meant), limit);
    }
  }
  fail(InputFault{.problem = shown(text) + " is not a boolean", .limit = limit});
}

std::vector<double> Node::as_numbers() const {
  std::vector<double> values;
  if (kind_ != Kind::kSequence)
    fail(InputFault{.problem = description(), .limit = "a list of numbers, such as [1.0, 2.5]"});
  for (const Node& item : items_) values.push_back(item.as_number());
  return values;
}

std::vector<double> Node::as_numbers(std::size_t count) const {
  if (kind_ != Kind::kSequence)
    fail(InputFault{.problem = description(), .limit = fmt::format("a list of {} numbers", count)});
  if (items_.size() != count) {
    fail(InputFault{.problem = fmt::format("the list has {} entries", items_.size()),
                    .value = std::to_string(items_.size()),
                    .limit = fmt::format("{} numbers", count)});
  }
  return as_numbers();
}

std::vector<std::string> Node::as_strings() const {
  std::vector<std::string> values;
  if (kind_ != Kind::kSequence)
    fail(InputFault{.problem = description(), .limit = "a list of texts, such as [left, right]"});
  for (const Node& item : items_) values.push_back(item.as_string());
  return values;
}

const std::vector<Node>& Node::items() const {
  if (kind_ != Kind::kSequence) fail(InputFault{.problem = description(), .limit = "a list"});
  return items_;
}

const std::vector<std::pair<std::string, Node>>& Node::entries() const {
  if (kind_ == Kind::kMap) return entries_;
  // YAML reads 'mass:5' as one plain scalar. It is the most common reason why a map is missing.
  const bool no_space = kind_ == Kind::kScalar && !is_text_ && text_.find(':') != std::string::npos;
  fail(InputFault{
      .problem = description(),
      .limit = fmt::format("a map of 'key: value'{}", no_space ? ", with a space after the colon" : "")});
}

const Node* Node::find(std::string_view key) const {
  const auto& all = entries();
  const auto entry = std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.first == key; });
  return entry == all.end() ? nullptr : &entry->second;
}

}  // namespace armtune::internal::yaml

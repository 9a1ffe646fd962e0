// Typed reads.

#include <string>
#include <vector>

#include "tests/sim/yaml/yaml_values.hpp"

namespace armtune::internal::yaml {
namespace node_test {

using namespace test;

TEST(NodeAsNumber, ReadsDecimalForms) {
  EXPECT_EQ(number("1e3"), 1000.0);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("-2"), -2.0);
  EXPECT_EQ(number("+2.5"), 2.5);
  EXPECT_EQ(number("0"), 0.0);
  EXPECT_EQ(number("-0.25E-2"), -0.0025);
  EXPECT_EQ(number("0.1"), 0.1);
}

TEST(NodeAsNumber, RefusesWhatIsNoNumberWithItsText) {
  for (const char* text :
       {"0x10", "'1,5'", "1.5kg", "1 2", "+-5", "--5", "+", "1_000", "1:30", ".inf", ".nan", "abc"}) {
    const std::string plain = text[0] == '\'' ? "1,5" : text;
    EXPECT_THAT(
        read_refusal(text, as_number),
        refused_at(
            {.file = "in.yaml", .line = 1, .key = "x", .value = plain, .limit = testing::StartsWith("a ")}));
  }
  EXPECT_EQ(read_error("1.5kg", as_number),
            "in.yaml:1: key 'x': '1.5kg' is not a number; expected a decimal number with '.' and no unit, "
            "such as -1.5 "
            "or 1e3");
  EXPECT_THAT(read_refusal("1,5", as_number), refused_at({.key = "x", .value = "1,5"}));
}

TEST(NodeAsNumber, RefusesNumbersThatAreNotFinite) {
  for (const char* text : {"nan", "inf", "-inf", "+inf", "infinity", "NAN"}) {
    EXPECT_THAT(read_refusal(text, as_number),
                refused_at({.line = 1, .key = "x", .value = text, .limit = "a finite number"}));
  }
}

TEST(NodeAsNumber, RefusesNumbersThatDoNotFitADouble) {
  for (const char* text : {"1e400", "1e-400"}) {
    EXPECT_THAT(read_refusal(text, as_number),
                refused_at({.value = text, .limit = "a magnitude from 1e-307 to 1e308, or 0"}));
  }
}

TEST(NodeAsNumber, RefusesQuotedAndBlockText) {
  EXPECT_EQ(read_error("'5'", as_number),
            "in.yaml:1: key 'x': '5' is a quoted text; expected a number, without quotes");
  for (const auto& [text, value] : {std::pair("\"5\"", "5"), {"|\n  5\n", "5\n"}, {"!!str 5", "5"}}) {
    EXPECT_THAT(read_refusal(text, as_number),
                refused_at({.value = value, .limit = "a number, without quotes"}));
  }
}

TEST(NodeAsNumber, RefusesEmptyValuesListsAndMaps) {
  EXPECT_EQ(read_error("", as_number), "in.yaml:1: key 'x': the value is empty; expected a number");
  for (const char* text : {"[1, 2]", "{a: 1}"}) {
    EXPECT_THAT(read_refusal(text, as_number),
                refused_at({.line = 1, .key = "x", .value = "", .limit = "a number"}));
  }
}

TEST(NodeAsNumber, DoesNotDependOnTheLocale) {
  const CommaLocale german;
  EXPECT_EQ(number("1.5"), 1.5);
  EXPECT_EQ(number("1234.5"), 1234.5);
  EXPECT_THAT(read_refusal("1,5", as_number), refused_at({.key = "x", .value = "1,5"}));
  EXPECT_EQ(error_of([] { parse_text(repeat("#\n", 1233) + "x: 1\nx: 2", "in.yaml"); }),
            "in.yaml:1235: key 'x': duplicate key, already on line 1234; remove one of the two");
}

TEST(Document, ItsVersionDirectiveDoesNotDependOnTheLocale) {
  const CommaLocale german;
  EXPECT_EQ(parse_error("%YAML 1.2\n---\nx: 1\n"), "no error");
}

TEST(NodeAsInteger, ReadsDecimalDigits) {
  EXPECT_EQ(integer("0"), 0);
  EXPECT_EQ(integer("-7"), -7);
  EXPECT_EQ(integer("+7"), 7);
  EXPECT_EQ(integer("9223372036854775807"), 9223372036854775807L);
}

TEST(NodeAsInteger, RefusesLeadingZerosInsteadOfReadingOctal) {
  EXPECT_EQ(read_error("010", as_integer),
            "in.yaml:1: key 'x': '010' has a leading zero, which makes it octal for some YAML readers; "
            "write 10");
  EXPECT_THAT(read_refusal("-007", as_integer), refused_at({.value = "-007", .limit = "-7"}));
  EXPECT_THAT(read_refusal("00", as_integer), refused_at({.value = "00", .limit = "0"}));
  EXPECT_THAT(read_refusal("010", as_number), refused_at({.value = "010", .limit = "10"}));
}

TEST(NodeAsInteger, RefusesEverythingElse) {
  for (const char* text : {"3.0", "1e3", "0x10", "3kg", "1,000", "nan", "true", "--", "+-3"}) {
    EXPECT_THAT(read_refusal(text, as_integer),
                refused_at({.value = text, .limit = "decimal digits only, without point, exponent or unit"}));
  }
  EXPECT_THAT(read_refusal("9223372036854775808", as_integer),
              refused_at({.value = "9223372036854775808", .limit = "a smaller integer"}));
  EXPECT_THAT(read_refusal("'3'", as_integer),
              refused_at({.value = "3", .limit = "an integer, without quotes"}));
  EXPECT_THAT(read_refusal("~", as_integer), refused_at({.limit = "an integer"}));
}

TEST(NodeAsBoolean, ReadsTrueAndFalse) {
  const Node root = parse_text("[true, false]", "in.yaml");
  EXPECT_TRUE(root.items()[0].as_boolean());
  EXPECT_FALSE(root.items()[1].as_boolean());
}

TEST(NodeAsBoolean, RefusesOtherSpellingsAndSaysWhatToWrite) {
  EXPECT_EQ(read_error("yes", as_boolean), "in.yaml:1: key 'x': 'yes' is not a boolean here; write true");
  for (const char* text : {"on", "Yes", "True", "TRUE", "y", "1"}) {
    EXPECT_TRUE(read_error(text, as_boolean).ends_with("; write true")) << text;
  }
  for (const char* text : {"no", "off", "OFF", "False", "n", "0"}) {
    EXPECT_TRUE(read_error(text, as_boolean).ends_with("; write false")) << text;
  }
}

TEST(NodeAsBoolean, RefusesEverythingElse) {
  EXPECT_EQ(read_error("maybe", as_boolean),
            "in.yaml:1: key 'x': 'maybe' is not a boolean; expected true or false");
  EXPECT_THAT(read_refusal("'true'", as_boolean),
              refused_at({.value = "true", .limit = "true or false, without quotes"}));
  EXPECT_THAT(read_refusal("", as_boolean), refused_at({.value = "", .limit = "true or false"}));
}

TEST(NodeAsString, ReadsPlainQuotedAndBlockText) {
  EXPECT_EQ(string("hello world"), "hello world");
  EXPECT_EQ(string("'5'"), "5");
  EXPECT_EQ(string("'true'"), "true");
  EXPECT_EQ(string("'it''s'"), "it's");
  EXPECT_EQ(string("\"a\\\"b\\\\\""), "a\"b\\");
  EXPECT_EQ(string("''"), "");
  EXPECT_EQ(string("|\n  one\n  two\n"), "one\ntwo\n");
  EXPECT_EQ(string("1.5kg"), "1.5kg");
}

TEST(NodeAsString, RefusesPlainNumbersAndBooleansWithAdvice) {
  EXPECT_EQ(read_error("5", as_string),
            "in.yaml:1: key 'x': '5' is a number, but a text is expected; write it in quotes: \"5\"");
  for (const char* text : {"1e3", "true"})
    EXPECT_THAT(read_refusal(text, as_string), refused_at({.value = text, .limit = "a text"}));
}

TEST(NodeAsString, RefusesEmptyValuesListsAndMaps) {
  EXPECT_EQ(read_error("~", as_string), "in.yaml:1: key 'x': the value is empty; expected a text");
  for (const char* text : {"[a]", "{a: b}"})
    EXPECT_THAT(read_refusal(text, as_string), refused_at({.value = "", .limit = "a text"}));
}

TEST(NodeAsNumbers, ReadsAList) {
  EXPECT_EQ(parse_text("[1, 2.5, -3e0]", "in.yaml").as_numbers(), (std::vector{1.0, 2.5, -3.0}));
  EXPECT_EQ(parse_text("- 1\n- 2\n", "in.yaml").as_numbers(2), (std::vector{1.0, 2.0}));
  EXPECT_TRUE(parse_text("[]", "in.yaml").as_numbers().empty());
}

TEST(NodeAsNumbers, NamesBothCountsWhenTheyDiffer) {
  const auto three = [](const Node& node) { node.as_numbers(3); };
  EXPECT_EQ(read_error("[1, 2]", three), "in.yaml:1: key 'x': the list has 2 entries; expected 3 numbers");
  EXPECT_THAT(read_refusal("[1, 2]", three),
              refused_at({.line = 1, .key = "x", .value = "2", .limit = "3 numbers"}));
}

TEST(NodeAsNumbers, NamesTheElementThatIsWrong) {
  EXPECT_THAT(read_refusal("\n  - 1\n  - two\n", [](const Node& node) { node.as_numbers(); }),
              refused_at({.line = 3, .key = "x/1", .value = "two"}));
  EXPECT_THAT(read_refusal("[1, , 2]", [](const Node& node) { node.as_numbers(3); }),
              refused_at({.line = 1, .key = "x/1", .value = "", .limit = "a number"}));
}

TEST(NodeAsNumbers, RefusesWhatIsNoList) {
  EXPECT_THAT(read_refusal("5", [](const Node& node) { node.as_numbers(3); }),
              refused_at({.value = "5", .limit = "a list of 3 numbers"}));
  EXPECT_THAT(read_refusal("{a: 1}", [](const Node& node) { node.as_numbers(); }),
              refused_at({.value = "", .limit = "a list of numbers, such as [1.0, 2.5]"}));
}

TEST(NodeAsStrings, ReadsAListOfTexts) {
  EXPECT_EQ(parse_text("[a, 'b c', \"3\"]", "in.yaml").as_strings(),
            (std::vector<std::string>{"a", "b c", "3"}));
}

TEST(NodeAsStrings, NamesTheElementThatIsWrong) {
  const auto as_strings = [](const Node& node) { node.as_strings(); };
  EXPECT_THAT(read_refusal("[a, 3]", as_strings),
              refused_at({.line = 1, .key = "x/1", .value = "3", .limit = "a text"}));
  EXPECT_THAT(read_refusal("a", as_strings),
              refused_at({.value = "a", .limit = "a list of texts, such as [left, right]"}));
}

TEST(NodeItems, RefusesWhatIsNoList) {
  EXPECT_THAT(read_refusal("{a: 1}", [](const Node& node) { node.items(); }),
              refused_at({.line = 1, .key = "x", .limit = "a list"}));
}

TEST(NodeEntries, RefusesWhatIsNoMap) {
  EXPECT_EQ(read_error("[1]", [](const Node& node) { node.entries(); }),
            "in.yaml:1: key 'x': the value is a list of 1; expected a map of 'key: value'");
  EXPECT_THAT(read_refusal("", [](const Node& node) { node.find("a"); }),
              refused_at({.line = 1, .key = "x", .limit = "a map of 'key: value'"}));
}

TEST(NodeEntries, ExplainsAMissingSpaceAfterTheColon) {
  EXPECT_EQ(error_of([] { parse_text("mass:5", "in.yaml").entries(); }),
            "in.yaml:1: the value is 'mass:5'; expected a map of 'key: value', with a space after the colon");
}

TEST(NodeFail, GivesTheTextOfAScalarAsTheValue) {
  const auto fail = [](const Node& node) { node.fail("too heavy", "at most 5 kg"); };
  EXPECT_EQ(read_error("7", fail), "in.yaml:1: key 'x': too heavy");
  EXPECT_THAT(read_refusal("7", fail),
              refused_at({.line = 1, .key = "x", .value = "7", .limit = "at most 5 kg"}));
  EXPECT_THAT(read_refusal("[7]", fail), refused_at({.value = "", .limit = "at most 5 kg"}));
}

TEST(NodeFail, MakesItsMessageFromTheFieldsOfAFault) {
  const auto fail = [](const Node& node) {
    node.fail(InputFault{.problem = "too heavy", .value = "7.0", .limit = "5 kg"});
  };
  EXPECT_EQ(read_error("7", fail), "in.yaml:1: key 'x': too heavy; expected 5 kg");
  EXPECT_THAT(read_refusal("7", fail), refused_at({.value = "7.0", .limit = "5 kg"}));
}

TEST(NodeFail, ListsTheKnownWords) {
  const auto fail = [](const Node& node) { node.fail_choice({"log", "linear"}); };
  EXPECT_EQ(read_error("lin", fail), "in.yaml:1: key 'x': 'lin' is not one of: log, linear");
  EXPECT_THAT(read_refusal("lin", fail), refused_at({.value = "lin", .limit = "one of: log, linear"}));
}

TEST(NodeFail, StaysOnOneLineAndShortensLongValues) {
  const std::string message = read_error("\"a\\nb\\e" + std::string(5000, 'z') + "\"", as_number);
  EXPECT_TRUE(contains(message, "'a\\nb\\x1bzzz")) << message;
  EXPECT_TRUE(contains(message, "zzz...' is a quoted text")) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_LT(message.size(), 200u);
}

TEST(NodeFail, DoesNotCutACharacterInHalf) {
  const std::string message = read_error(repeat("\xE2\x82\xAC", 100), as_number);
  EXPECT_TRUE(contains(message, quoted(repeat("\xE2\x82\xAC", 20) + "..."))) << message;
  EXPECT_TRUE(contains(read_error(fmt::format("a{}", repeat("\xE2\x82\xAC", 100)), as_number),
                       quoted(fmt::format("a{}...", repeat("\xE2\x82\xAC", 19)))));
}

}  // namespace node_test
}  // namespace armtune::internal::yaml

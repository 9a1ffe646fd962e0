// Typed reads.

#include <string>
#include <vector>

#include "tests/sim/yaml/yaml_values.hpp"

namespace armtune::internal::yaml {
namespace {

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
    const std::string message = read_error(text, as_number);
    EXPECT_TRUE(message.starts_with("in.yaml:1: key 'x': ")) << message;
    EXPECT_TRUE(contains(message, "expected a ")) << message;
    if (text[0] != '\'') {
      EXPECT_TRUE(contains(message, text)) << message;
    }
  }
  EXPECT_EQ(read_error("1.5kg", as_number),
            "in.yaml:1: key 'x': '1.5kg' is not a number; expected a decimal number with '.' and no unit, "
            "such as -1.5 "
            "or 1e3");
  EXPECT_TRUE(contains(read_error("1,5", as_number), "'1,5' is not a number"));
}

TEST(NodeAsNumber, RefusesNumbersThatAreNotFinite) {
  for (const char* text : {"nan", "inf", "-inf", "+inf", "infinity", "NAN"}) {
    EXPECT_EQ(read_error(text, as_number),
              std::string("in.yaml:1: key 'x': '") + text + "' is not finite; expected a finite number");
  }
}

TEST(NodeAsNumber, RefusesNumbersThatDoNotFitADouble) {
  EXPECT_TRUE(contains(read_error("1e400", as_number), "'1e400' does not fit a double"));
  EXPECT_TRUE(contains(read_error("1e-400", as_number), "'1e-400' does not fit a double"));
}

TEST(NodeAsNumber, RefusesQuotedAndBlockText) {
  EXPECT_EQ(read_error("'5'", as_number),
            "in.yaml:1: key 'x': '5' is a quoted text; expected a number, without quotes");
  EXPECT_TRUE(contains(read_error("\"5\"", as_number), "quoted text"));
  EXPECT_TRUE(contains(read_error("|\n  5\n", as_number), "quoted text"));
  EXPECT_TRUE(contains(read_error("!!str 5", as_number), "quoted text"));
}

TEST(NodeAsNumber, RefusesEmptyValuesListsAndMaps) {
  EXPECT_EQ(read_error("", as_number), "in.yaml:1: key 'x': the value is empty; expected a number");
  EXPECT_EQ(read_error("[1, 2]", as_number),
            "in.yaml:1: key 'x': the value is a list of 2; expected a number");
  EXPECT_EQ(read_error("{a: 1}", as_number), "in.yaml:1: key 'x': the value is a map; expected a number");
}

TEST(NodeAsNumber, DoesNotDependOnTheLocale) {
  const CommaLocale german;
  EXPECT_EQ(number("1.5"), 1.5);
  EXPECT_EQ(number("1234.5"), 1234.5);
  EXPECT_TRUE(contains(read_error("1,5", as_number), "'1,5' is not a number"));
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
  EXPECT_TRUE(contains(read_error("-007", as_integer), "write -7"));
  EXPECT_TRUE(contains(read_error("00", as_integer), "write 0"));
  EXPECT_TRUE(contains(read_error("010", as_number), "write 10"));
}

TEST(NodeAsInteger, RefusesEverythingElse) {
  for (const char* text : {"3.0", "1e3", "0x10", "3kg", "1,000", "nan", "true", "--", "+-3"}) {
    EXPECT_TRUE(
        contains(read_error(text, as_integer), std::string("'") + text + "' is not an integer; expected "));
  }
  EXPECT_TRUE(contains(read_error("9223372036854775808", as_integer), "does not fit 64 bit"));
  EXPECT_TRUE(contains(read_error("'3'", as_integer), "without quotes"));
  EXPECT_TRUE(contains(read_error("~", as_integer), "empty; expected an integer"));
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
  EXPECT_TRUE(contains(read_error("'true'", as_boolean), "without quotes"));
  EXPECT_TRUE(contains(read_error("", as_boolean), "empty; expected true or false"));
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
  EXPECT_TRUE(contains(read_error("1e3", as_string), "is a number"));
  EXPECT_TRUE(contains(read_error("true", as_string), "is a boolean"));
}

TEST(NodeAsString, RefusesEmptyValuesListsAndMaps) {
  EXPECT_EQ(read_error("~", as_string), "in.yaml:1: key 'x': the value is empty; expected a text");
  EXPECT_TRUE(contains(read_error("[a]", as_string), "a list of 1; expected a text"));
  EXPECT_TRUE(contains(read_error("{a: b}", as_string), "a map; expected a text"));
}

TEST(NodeAsNumbers, ReadsAList) {
  EXPECT_EQ(parse_text("[1, 2.5, -3e0]", "in.yaml").as_numbers(), (std::vector{1.0, 2.5, -3.0}));
  EXPECT_EQ(parse_text("- 1\n- 2\n", "in.yaml").as_numbers(2), (std::vector{1.0, 2.0}));
  EXPECT_TRUE(parse_text("[]", "in.yaml").as_numbers().empty());
}

TEST(NodeAsNumbers, NamesBothCountsWhenTheyDiffer) {
  EXPECT_EQ(read_error("[1, 2]", [](const Node& node) { node.as_numbers(3); }),
            "in.yaml:1: key 'x': the list has 2 entries; expected 3 numbers");
}

TEST(NodeAsNumbers, NamesTheElementThatIsWrong) {
  EXPECT_TRUE(read_error("\n  - 1\n  - two\n", [](const Node& node) {
                node.as_numbers();
              }).starts_with("in.yaml:3: key 'x/1': 'two' is not a number; "));
  EXPECT_EQ(read_error("[1, , 2]", [](const Node& node) { node.as_numbers(3); }),
            "in.yaml:1: key 'x/1': the value is empty; expected a number");
}

TEST(NodeAsNumbers, RefusesWhatIsNoList) {
  EXPECT_TRUE(contains(read_error("5", [](const Node& node) { node.as_numbers(3); }),
                       "the value is '5'; expected a list of 3 numbers"));
  EXPECT_TRUE(contains(read_error("{a: 1}", [](const Node& node) { node.as_numbers(); }),
                       "a map; expected a list of numbers"));
}

TEST(NodeAsStrings, ReadsAListOfTexts) {
  EXPECT_EQ(parse_text("[a, 'b c', \"3\"]", "in.yaml").as_strings(),
            (std::vector<std::string>{"a", "b c", "3"}));
}

TEST(NodeAsStrings, NamesTheElementThatIsWrong) {
  const auto as_strings = [](const Node& node) { node.as_strings(); };
  EXPECT_TRUE(read_error("[a, 3]", as_strings).starts_with("in.yaml:1: key 'x/1': '3' is a number, but "));
  EXPECT_TRUE(contains(read_error("a", as_strings), "the value is 'a'; expected a list of texts"));
}

TEST(NodeItems, RefusesWhatIsNoList) {
  EXPECT_EQ(read_error("{a: 1}", [](const Node& node) { node.items(); }),
            "in.yaml:1: key 'x': the value is a map; expected a list");
}

TEST(NodeEntries, RefusesWhatIsNoMap) {
  EXPECT_EQ(read_error("[1]", [](const Node& node) { node.entries(); }),
            "in.yaml:1: key 'x': the value is a list of 1; expected a map of 'key: value'");
  EXPECT_TRUE(read_error("", [](const Node& node) { node.find("a"); }).starts_with("in.yaml:1: key 'x': "));
}

TEST(NodeEntries, ExplainsAMissingSpaceAfterTheColon) {
  EXPECT_EQ(error_of([] { parse_text("mass:5", "in.yaml").entries(); }),
            "in.yaml:1: the value is 'mass:5'; expected a map of 'key: value', with a space after the colon");
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

}  // namespace
}  // namespace armtune::internal::yaml

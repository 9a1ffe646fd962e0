#include "sim/yaml/document.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <clocale>
#include <filesystem>
#include <fstream>
#include <functional>
#include <locale>
#include <string>
#include <vector>

#include "core/common/error.hpp"

namespace armtune::yaml {
namespace {

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// Message of the error that parsing `text` as "in.yaml" gives.
std::string parse_error(const std::string& text) {
  return error_of([&] { parse_text(text, "in.yaml"); });
}

/// Message of the error that `read` gives on the value of key x.
template <typename Read>
std::string read_error(const std::string& value, Read read) {
  const Node root = parse_text("x: " + value, "in.yaml");
  return error_of([&] { read(*root.find("x")); });
}
const auto as_string = [](const Node& node) { node.as_string(); };
const auto as_number = [](const Node& node) { node.as_number(); };
const auto as_integer = [](const Node& node) { node.as_integer(); };
const auto as_boolean = [](const Node& node) { node.as_boolean(); };

double number(const std::string& value) {
  return parse_text("x: " + value, "in.yaml").find("x")->as_number();
}
long integer(const std::string& value) {
  return parse_text("x: " + value, "in.yaml").find("x")->as_integer();
}
std::string string(const std::string& value) {
  return parse_text("x: " + value, "in.yaml").find("x")->as_string();
}

std::string repeat(const std::string& part, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += part;
  return text;
}

/// A value as messages show it.
std::string quoted(const std::string& value) {
  return fmt::format("'{}'", value);
}

bool contains(const std::string& text, const std::string& part) {
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

// ---- the tree

TEST(Document, KeepsKindsLinesFileAndKeyPaths) {
  const Node root = parse_text(
      "# comment\nplant:\n  payload:\n    mass: 2\ntargets:\n  - {center: 1}\n  - center: 2\n", "in.yaml");
  EXPECT_EQ(root.kind(), Node::Kind::kMap);
  EXPECT_EQ(root.line(), 2);
  EXPECT_EQ(root.file(), "in.yaml");
  EXPECT_EQ(root.key_path(), "");
  const Node& mass = *root.find("plant")->find("payload")->find("mass");
  EXPECT_EQ(mass.kind(), Node::Kind::kScalar);
  EXPECT_EQ(mass.key_path(), "plant/payload/mass");
  EXPECT_EQ(mass.line(), 4);
  EXPECT_EQ(mass.file(), "in.yaml");
  const Node& targets = *root.find("targets");
  EXPECT_EQ(targets.kind(), Node::Kind::kSequence);
  EXPECT_EQ(targets.items()[1].find("center")->key_path(), "targets/1/center");
  EXPECT_EQ(targets.items()[1].line(), 7);
}

TEST(Document, GivesAMapEntryTheLineOfItsKey) {
  const Node root = parse_text("a:\n\n  b: 1\nc:\n\n\nd: 2\n", "in.yaml");
  EXPECT_EQ(root.find("a")->line(), 1);
  EXPECT_EQ(root.find("c")->line(), 4);
}

TEST(Document, GivesAnEmptyListElementTheLineOfItsDash) {
  const Node root = parse_text("a:\n  - 1\n  -\n\n\n  - ~\n  -\nnext: 1\n", "in.yaml");
  const std::vector<Node>& items = root.find("a")->items();
  ASSERT_EQ(items.size(), 4u);
  EXPECT_EQ(items[1].line(), 3);
  EXPECT_EQ(items[2].line(), 6);
  EXPECT_EQ(items[3].line(), 7);
}

TEST(Document, CountsLinesWithWindowsLineEndings) {
  const Node root = parse_text("a: \"\xC3\xA9\"\r\n\r\nb: 'x'\r\nc:\r\n  -\r\n  - 'y'\r\n", "in.yaml");
  EXPECT_EQ(root.find("b")->line(), 3);
  EXPECT_EQ(root.find("b")->as_string(), "x");
  EXPECT_EQ(root.find("c")->items()[0].line(), 5);
}

TEST(Document, KeepsEntriesInTheOrderOfTheFile) {
  const Node root = parse_text("z: 1\na: 2\nm: 3\n", "in.yaml");
  ASSERT_EQ(root.entries().size(), 3u);
  EXPECT_EQ(root.entries()[0].first, "z");
  EXPECT_EQ(root.entries()[2].first, "m");
}

TEST(Document, FindsNothingForAnAbsentKey) {
  EXPECT_EQ(parse_text("a: 1", "in.yaml").find("b"), nullptr);
}

TEST(Document, ReadsNothingTildeAndNullAsEmpty) {
  const Node root = parse_text("a:\nb: ~\nc: null\nd: !!null ~\ne: ''\n", "in.yaml");
  for (const char* key : {"a", "b", "c", "d"}) EXPECT_EQ(root.find(key)->kind(), Node::Kind::kNull) << key;
  EXPECT_EQ(root.find("e")->kind(), Node::Kind::kScalar);
}

TEST(Document, AcceptsAByteOrderMarkADirectiveAndTheMarkersOfOneDocument) {
  EXPECT_EQ(parse_text("\xEF\xBB\xBF%YAML 1.2\n---\na: '1'\n...\n", "in.yaml").find("a")->as_string(), "1");
}

TEST(Document, AcceptsCoreTags) {
  const Node root = parse_text(
      "a: !!str 5\nb: !!float 5\nc: !!int 5\nd: !!bool true\ne: !!seq [1]\nf: !!map {x: 1}\n"
      "g: !!str 'q'\n",
      "in.yaml");
  EXPECT_EQ(root.find("a")->as_string(), "5");
  EXPECT_EQ(root.find("b")->as_number(), 5.0);
  EXPECT_EQ(root.find("c")->as_integer(), 5);
  EXPECT_TRUE(root.find("d")->as_boolean());
  EXPECT_EQ(root.find("e")->items().size(), 1u);
  EXPECT_EQ(root.find("f")->entries().size(), 1u);
  EXPECT_EQ(root.find("g")->as_string(), "q");
}

TEST(Document, ItsNodesCanBeCopiedAndOutliveTheRoot) {
  const Node copy = [] { return *parse_text("a: {b: 1}", "in.yaml").find("a"); }();
  EXPECT_EQ(error_of([&] { copy.find("b")->fail("wrong"); }), "in.yaml:1: key 'a/b': wrong");
}

// ---- typed reads

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
            "in.yaml:1: key 'x': '010' has a leading zero, octal to some YAML readers and decimal to others; "
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
            "in.yaml:1: key 'x': '5' is a number; expected a text: to mean one, put it in quotes, \"5\"");
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
  EXPECT_TRUE(read_error("[a, 3]", as_strings).starts_with("in.yaml:1: key 'x/1': '3' is a number; "));
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

// ---- documents that are refused

TEST(Parse, RefusesDuplicateKeysAndNamesBothLines) {
  EXPECT_EQ(parse_error("plant:\n  mass: 1\n  size: 2\n  mass: 3\n"),
            "in.yaml:4: key 'plant/mass': duplicate key, already on line 2; remove one of the two");
  EXPECT_TRUE(contains(parse_error("a: 1\n'a': 2\n"), "duplicate key"));
  EXPECT_TRUE(contains(parse_error("{a: 1, a: 2}"), "duplicate key"));
}

TEST(Parse, AcceptsTheSameKeyInDifferentMaps) {
  EXPECT_EQ(parse_error("a: {x: 1}\nb: {x: 1}\nx: [{x: 1}, {x: 2}]\n"), "no error");
}

TEST(Parse, RefusesASecondDocument) {
  EXPECT_EQ(parse_error("a: 1\n---\nb: 2\n"),
            "in.yaml:2: a second document starts here; expected one document in a file");
  EXPECT_TRUE(parse_error("a: 1\n...\n---\n").starts_with("in.yaml:3: a second document"));
}

TEST(Parse, RefusesTextAfterTheDocument) {
  EXPECT_EQ(parse_error("- 1\n- 2\nb: 3\n"),
            "in.yaml:3: text after the end of the document; check the indentation of this line");
}

TEST(Parse, RefusesAnchorsAndAliases) {
  EXPECT_EQ(parse_error("a: &x 1\nb: *x\n"),
            "in.yaml:1: key 'a': anchor '&x': anchors and aliases are not accepted; write the value out "
            "where it is "
            "used");
  EXPECT_TRUE(parse_error("c: 1\n&q a: 1\n").starts_with("in.yaml:2: anchor '&q'"));
  EXPECT_TRUE(
      parse_error("a: 1\nb: *x\n").starts_with("in.yaml:2: key 'b': aliases (*name) are not accepted"));
}

TEST(Parse, RefusesAnAliasBombAtOnce) {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 50; ++i) {
    const std::string last = fmt::format("*a{}, ", i - 1);
    bomb += fmt::format("a{0}: &a{0} [{1}x]\n", i, repeat(last, 10));
  }
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(parse_error(bomb).starts_with("in.yaml:1: key 'a0': anchor '&a0'"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

TEST(Parse, RefusesTagsOtherThanCoreOnes) {
  EXPECT_EQ(parse_error("a: !robot ur5\n"),
            "in.yaml:1: key 'a': tag '!robot' is not accepted here; remove it");
  EXPECT_TRUE(contains(parse_error("a: !!binary aGk=\n"), "'tag:yaml.org,2002:binary' is not accepted"));
  EXPECT_TRUE(contains(parse_error("a: !set {b: 1}\n"), "'!set' is not accepted"));
  EXPECT_TRUE(contains(parse_error("a: !list [b]\n"), "'!list' is not accepted"));
  EXPECT_TRUE(contains(parse_error("!foo a: 1\n"), "'!foo' is not accepted"));
  EXPECT_TRUE(contains(parse_error("a: !!seq 5\n"), "seq' is not accepted here"));
  EXPECT_TRUE(contains(parse_error("a: !!null 5\n"), "'5' is tagged !!null"));
}

TEST(Parse, RefusesKeysThatAreNotScalars) {
  EXPECT_EQ(parse_error("a:\n  ? [1, 2]\n  : x\n"),
            "in.yaml:2: key 'a': a key is a list or a map; expected a text before ':'");
  EXPECT_TRUE(contains(parse_error("? {a: 1}\n: x\n"), "a key is a list or a map"));
  EXPECT_TRUE(contains(parse_error("? [{? [a] : b}]\n: [x, {y: z}]\n? {}\n"), "in.yaml:1: a key is a list"));
  EXPECT_EQ(parse_error("a: 1\n~: 3\n"), "in.yaml:2: a key is empty; expected a text before ':'");
  EXPECT_TRUE(contains(parse_error(": 3\n"), "a key is empty"));
}

TEST(Parse, ReportsSyntaxErrorsWithTheirLine) {
  EXPECT_EQ(parse_error("a: 1\nb: c: d\n"), "in.yaml:2: not valid YAML: illegal map value");
  EXPECT_EQ(parse_error("a: 1\n]\n"), "in.yaml:2: not valid YAML: illegal flow end");
  EXPECT_EQ(parse_error("a: \"\\q\"\n"), "in.yaml:1: not valid YAML: unknown escape character: q");
  EXPECT_TRUE(parse_error("%YAML 3.0\n---\na: 1\n").starts_with("in.yaml:1: not valid YAML: "));
}

TEST(Parse, NamesTheLineOfABracketThatIsNeverClosed) {
  EXPECT_EQ(parse_error("a: 1\nb: [1,\n  2\n"),
            "in.yaml:4: not valid YAML: end of sequence flow not found; opened on line 2");
  EXPECT_TRUE(parse_error("a: 1\nb: {c: 1,\n").ends_with("end of map flow not found; opened on line 2"));
}

TEST(Parse, DoesNotTakeABracketThatIsNeverClosedForAKey) {
  for (const char* text : {"a: [[1, 2], [3, 4]\n", "a: [{b: 1}, {b: 2}\n", "a: [{b: 1},\n[1]\n"}) {
    EXPECT_TRUE(contains(parse_error(text), "end of sequence flow not found; opened on line 1"))
        << parse_error(text);
  }
  EXPECT_TRUE(contains(parse_error(std::string(1000, '[')), "nested more than 64"));
}

TEST(Parse, RefusesAQuoteThatIsNeverClosed) {
  EXPECT_EQ(parse_error("a: 1\nname: \"abc\nduration: 5\n"),
            "in.yaml:2: key 'name': the quote \" opened here is never closed");
  EXPECT_TRUE(
      contains(parse_error("name: 'it''s\nduration: 5\n"), "the quote ' opened here is never closed"));
  EXPECT_TRUE(contains(parse_error("name: \"abc\\\"\n"), "never closed"));
  EXPECT_TRUE(contains(parse_error("name: !!str \"abc\n"), "never closed"));
  EXPECT_TRUE(contains(parse_error("\xEF\xBB\xBF\xC3\xA9: 'x'\r\nb: \"abc\r\n"), "key 'b': the quote"));
  EXPECT_EQ(parse_error("a: \"two\n  lines\"\nb: 'x'"), "no error");
}

TEST(Parse, RefusesControlCharactersThatWouldHideTheRest) {
  EXPECT_EQ(parse_error("a: 1\n\x04"
                        "b: 2\n"),
            "in.yaml:2: control character 0x04; expected text in UTF-8");
  EXPECT_TRUE(contains(parse_error(std::string("a: 1\0", 5)), "control character 0x00"));
}

TEST(Parse, RefusesUtf16) {
  EXPECT_EQ(parse_error(std::string("\xFF\xFE"
                                    "a\0:\0 \0001\0",
                                    10)),
            "in.yaml: the text is UTF-16; save it as UTF-8");
  EXPECT_TRUE(contains(parse_error(std::string("a\0:\0", 4)), "control character 0x00"));
}

TEST(Parse, RefusesAnEmptyDocument) {
  for (const char* text : {"", "\n\n", "# only a comment\n", "---\n", "~"}) {
    EXPECT_EQ(parse_error(text), "in.yaml: empty, or nothing but comments; expected a YAML document") << text;
  }
}

// ---- limits

TEST(ParseLimits, AcceptsTheGreatestDepthAndRefusesOneMore) {
  const auto nested = [](std::size_t n) { return std::string(n, '[') + std::string(n, ']'); };
  EXPECT_EQ(parse_error(nested(kMaxDepth)), "no error");
  EXPECT_EQ(parse_error(nested(kMaxDepth + 1)), "in.yaml:1: nested more than 64 levels deep");
  EXPECT_TRUE(contains(parse_error(repeat("- ", kMaxDepth + 1) + "x"), "nested more than 64"));
}

TEST(ParseLimits, AcceptsTheMostItemsAndRefusesOneMore) {
  EXPECT_EQ(parse_error(repeat("- 1\n", kMaxItems - 1)), "no error");  // and the list itself
  EXPECT_EQ(parse_error(repeat("- 1\n", kMaxItems)),
            "in.yaml:200000: more than 200000 values; expected fewer in one file");
}

TEST(ParseLimits, RefusesATextThatIsTooLarge) {
  const std::string text = "a: 1\n#";
  EXPECT_EQ(parse_error(text + std::string(kMaxBytes - text.size(), 'x')), "no error");
  EXPECT_EQ(parse_error(text + std::string(kMaxBytes - text.size() + 1, 'x')),
            "in.yaml: larger than 4 MB; expected a smaller file");
}

TEST(ParseLimits, RefusesKeysAndPathsThatAreTooLong) {
  EXPECT_TRUE(
      contains(parse_error(fmt::format("? {:k<201}\n: 1\n", 'k')), "has 201 bytes; expected at most 200"));
  EXPECT_TRUE(contains(parse_error(repeat(fmt::format("{{{:k<150}: ", 'k'), 7) + "1" + repeat("}", 7)),
                       "longer than 1000 bytes"));
}

TEST(ParseLimits, ReadsALargeMapInReasonableTime) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "key" + std::to_string(i) + ": 1\n";
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(parse_text(text, "in.yaml").entries().size(), 100'000u);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

// ---- files

TEST(ParseFile, ReadsAFileAndNamesItInErrors) {
  const TemporaryFile file("armtune_document.yaml", "a: 1\nb: x\n");
  const Node root = parse_file(file.path());
  EXPECT_EQ(root.find("a")->as_number(), 1.0);
  EXPECT_EQ(root.file(), file.path());
  EXPECT_TRUE(error_of([&] { root.find("b")->as_number(); }).starts_with(file.path() + ":2: key 'b': "));
}

TEST(ParseFile, RefusesAMissingFile) {
  EXPECT_EQ(error_of([] { parse_file("/no/such/file.yaml"); }), "/no/such/file.yaml: no such file");
}

TEST(ParseFile, RefusesADirectory) {
  EXPECT_EQ(error_of([] { parse_file("/tmp"); }), "/tmp: is a directory; expected a YAML file");
}

TEST(ParseFile, RefusesAFileThatCannotBeOpened) {
  const TemporaryFile file("armtune_unreadable.yaml", "a: 1\n");
  std::filesystem::permissions(file.path(), std::filesystem::perms::none);
  if (std::ifstream(file.path())) GTEST_SKIP() << "this user reads everything";
  EXPECT_EQ(error_of([&] { parse_file(file.path()); }),
            file.path() + ": cannot be opened: Permission denied");
}

TEST(ParseFile, RefusesAFileThatCannotBeRead) {
  // Opens, and gives an I/O error at its first byte.
  if (!std::ifstream("/proc/self/mem")) GTEST_SKIP() << "no /proc";
  EXPECT_EQ(error_of([] { parse_file("/proc/self/mem"); }), "/proc/self/mem: cannot be read");
}

TEST(ParseFile, RefusesAnEmptyFile) {
  const TemporaryFile file("armtune_empty.yaml", "");
  EXPECT_EQ(error_of([&] { parse_file(file.path()); }),
            file.path() + ": empty, or nothing but comments; expected a YAML document");
}

TEST(ParseFile, RefusesAnOversizeOrEndlessFile) {
  const TemporaryFile file("armtune_oversize.yaml", "a: 1\n#" + std::string(kMaxBytes, 'x'));
  EXPECT_EQ(error_of([&] { parse_file(file.path()); }),
            file.path() + ": larger than 4 MB; expected a smaller file");
  EXPECT_TRUE(contains(error_of([] { parse_file("/dev/zero"); }), "larger than 4 MB"));
}

}  // namespace
}  // namespace armtune::yaml

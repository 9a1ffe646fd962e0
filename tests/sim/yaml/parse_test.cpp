// Documents that are refused, limits, files.

#include <chrono>
#include <string>

#include "tests/sim/yaml/yaml_values.hpp"

namespace armtune::internal::yaml {
namespace parse_test {

using namespace test;

TEST(Parse, RefusesDuplicateKeysAndNamesBothLines) {
  EXPECT_EQ(parse_error("plant:\n  mass: 1\n  size: 2\n  mass: 3\n"),
            "in.yaml:4: key 'plant/mass': duplicate key, already on line 2; remove one of the two");
  EXPECT_THAT(parse_refusal("a: 1\n'a': 2\n"), refused_at({.file = "in.yaml", .line = 2, .key = "a"}));
  EXPECT_THAT(parse_refusal("{a: 1, a: 2}"), refused_at({.file = "in.yaml", .line = 1, .key = "a"}));
}

TEST(Parse, AcceptsTheSameKeyInDifferentMaps) {
  EXPECT_EQ(parse_error("a: {x: 1}\nb: {x: 1}\nx: [{x: 1}, {x: 2}]\n"), "no error");
}

TEST(Parse, RefusesASecondDocument) {
  EXPECT_EQ(parse_error("a: 1\n---\nb: 2\n"),
            "in.yaml:2: a second document starts here; expected one document in a file");
  EXPECT_THAT(parse_refusal("a: 1\n...\n---\n"), refused_at({.file = "in.yaml", .line = 3}));
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
  EXPECT_THAT(parse_refusal("%YAML 3.0\n---\na: 1\n"), refused_at({.file = "in.yaml", .line = 1}));
}

TEST(Parse, NamesTheLineOfABracketThatIsNeverClosed) {
  EXPECT_EQ(parse_error("a: 1\nb: [1,\n  2\n"),
            "in.yaml:4: not valid YAML: end of sequence flow not found; its bracket was opened on line 2");
  EXPECT_TRUE(parse_error("a: 1\nb: {c: 1,\n")
                  .ends_with("end of map flow not found; its bracket was opened on line 2"));
}

TEST(Parse, DoesNotTakeABracketThatIsNeverClosedForAKey) {
  for (const char* text : {"a: [[1, 2], [3, 4]\n", "a: [{b: 1}, {b: 2}\n", "a: [{b: 1},\n[1]\n"}) {
    EXPECT_TRUE(
        contains(parse_error(text), "end of sequence flow not found; its bracket was opened on line 1"))
        << parse_error(text);
  }
  EXPECT_THAT(parse_refusal(std::string(1000, '[')), refused_at({.limit = "at most 64 levels"}));
}

TEST(Parse, RefusesAQuoteThatIsNeverClosed) {
  EXPECT_EQ(parse_error("a: 1\nname: \"abc\nduration: 5\n"),
            "in.yaml:2: key 'name': the quote \" opened here is never closed; close it");
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
            "in.yaml:2: this line contains the control character 0x04; remove it");
  EXPECT_TRUE(contains(parse_error(std::string("a: 1\0", 5)), "control character 0x00"));
}

TEST(Parse, RefusesUtf16) {
  EXPECT_EQ(parse_error(std::string("\xFF\xFE"
                                    "a\0:\0 \0001\0",
                                    10)),
            "in.yaml: the text is UTF-16; save it as UTF-8");
  EXPECT_TRUE(contains(parse_error(std::string("a\0:\0", 4)), "control character 0x00"));
}

TEST(Parse, RefusesTextThatIsNotUtf8AndNamesItsLine) {
  for (const std::string text : {"name: caf\xe9", "# caf\xe9", "'caf\xe9': 1", "name: \"caf\xe9\""}) {
    EXPECT_TRUE(contains(parse_error("a: 1\n" + text + "\nb: 2\n"), "in.yaml:2: ")) << text;
    EXPECT_TRUE(contains(parse_error("a: 1\n" + text + "\nb: 2\n"), "UTF-8")) << text;
  }
  EXPECT_EQ(parse_error("name: caf\xc3\xa9\n"), "no error");
  EXPECT_EQ(parse_error("\xEF\xBB\xBFname: caf\xc3\xa9\n"), "no error") << "a byte order mark";
}

TEST(Parse, RefusesAnEmptyDocument) {
  for (const char* text : {"", "\n\n", "# only a comment\n", "---\n", "~"}) {
    EXPECT_EQ(parse_error(text), "in.yaml: empty, or nothing but comments; expected a YAML document") << text;
  }
}

TEST(ParseLimits, AcceptsTheGreatestDepthAndRefusesOneMore) {
  const auto nested = [](std::size_t n) { return std::string(n, '[') + std::string(n, ']'); };
  EXPECT_EQ(parse_error(nested(kMaxDepth)), "no error");
  EXPECT_EQ(parse_error(nested(kMaxDepth + 1)),
            "in.yaml:1: nested more than 64 levels deep; armtune's files need no more than 10");
  EXPECT_THAT(parse_refusal(repeat("- ", kMaxDepth + 1) + "x"), refused_at({.limit = "at most 64 levels"}));
}

TEST(ParseLimits, AcceptsTheMostItemsAndRefusesOneMore) {
  EXPECT_EQ(parse_error(repeat("- 1\n", kMaxItems - 1)), "no error");  // and the list itself
  EXPECT_EQ(parse_error(repeat("- 1\n", kMaxItems)),
            "in.yaml:200000: the file has more than 200000 values, which is the most that armtune reads");
}

TEST(ParseLimits, RefusesATextThatIsTooLarge) {
  const std::string text = "a: 1\n#";
  EXPECT_EQ(parse_error(text + std::string(kMaxBytes - text.size(), 'x')), "no error");
  EXPECT_EQ(parse_error(text + std::string(kMaxBytes - text.size() + 1, 'x')),
            "in.yaml: larger than 4 MB; expected a smaller file");
}

TEST(ParseLimits, RefusesKeysAndPathsThatAreTooLong) {
  const auto key = [](std::size_t bytes) { return "? " + std::string(bytes, 'k') + "\n: 1\n"; };
  EXPECT_EQ(parse_error(key(kMaxKeyBytes)), "no error");
  EXPECT_THAT(parse_refusal(key(kMaxKeyBytes + 1)), refused_at({.value = "4097", .limit = "at most 4096"}));
  EXPECT_THAT(parse_refusal(repeat(fmt::format("{{{:k<150}: ", 'k'), 56) + "1" + repeat("}", 56)),
              refused_at({.limit = "at most 8192 bytes"}));
}

TEST(ParseLimits, RefusesLongPathsToManyValues) {
  // 20,000 values, each of which would hold a path of 3,600 bytes: 72 MB.
  const std::string open = repeat(fmt::format("{{{:k<900}: ", 'k'), 4);
  EXPECT_THAT(parse_refusal(open + "[" + repeat("1, ", 20'000) + "1]" + repeat("}", 4)),
              refused_at({.limit = "at most 32 MB"}));
}

TEST(ParseLimits, GrowWithTheLargestTextThatTheCallerAllows) {
  // 15,000 values with paths of 3,600 bytes, 54 MB: too long for a file of 4 MB, not for one of 8 MB.
  const std::string open = repeat(fmt::format("{{{:k<900}: ", 'k'), 4);
  const std::string paths = open + "[" + repeat("1, ", 15'000) + "1]" + repeat("}", 4);
  EXPECT_THAT(parse_refusal(paths), refused_at({.limit = "at most 32 MB"}));
  EXPECT_NO_THROW(parse_text(paths, "in.yaml", 2 * kMaxBytes));
  const std::string values = repeat("- 1\n", kMaxItems);
  EXPECT_THAT(parse_refusal(values), refused_at({.limit = "at most 200000 values"}));
  EXPECT_NO_THROW(parse_text(values, "in.yaml", 2 * kMaxBytes));
}

TEST(ParseLimits, OverlaysLargeMapsInReasonableTime) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "key" + std::to_string(i) + ": 1\n";
  const Node node = parse_text(text, "in.yaml");
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(overlay({node, node}).entries().size(), 100'000u);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST(ParseLimits, ReadsALargeMapInReasonableTime) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "key" + std::to_string(i) + ": 1\n";
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(parse_text(text, "in.yaml").entries().size(), 100'000u);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_EQ(parse_error(text + "one_more: 1\n"),
            "in.yaml:100001: more than 100000 keys in one map; expected fewer");
}

TEST(ParseFile, ReadsAFileAndNamesItInErrors) {
  const TemporaryFile file("armtune_document.yaml", "a: 1\nb: x\n");
  const Node root = parse_file(file.path());
  EXPECT_EQ(root.find("a")->as_number(), 1.0);
  EXPECT_EQ(root.file(), file.path());
  EXPECT_THAT([&] { root.find("b")->as_number(); },
              refused_at({.file = file.path(), .line = 2, .key = "b", .value = "x"}));
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
  EXPECT_TRUE(error_of([] { parse_file("/proc/self/mem"); }).starts_with("/proc/self/mem: cannot be read: "));
}

TEST(ParseFile, RefusesAnEmptyFile) {
  const TemporaryFile file("armtune_empty.yaml", "");
  EXPECT_EQ(error_of([&] { parse_file(file.path()); }),
            file.path() + ": empty, or nothing but comments; expected a YAML document");
}

TEST(ParseFile, RefusesAnOversizeOrEndlessFile) {
  const TemporaryFile file("armtune_oversize.yaml", "a: 1\n#" + std::string(kMaxBytes, 'x'));
  for (const std::string& path : {file.path(), std::string("/dev/zero")})
    EXPECT_THAT([&] { parse_file(path); }, refused_at({.file = path, .limit = "at most 4 MB"}));
}

}  // namespace parse_test
}  // namespace armtune::internal::yaml

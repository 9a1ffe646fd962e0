// The tree a document becomes.

#include <string>

#include "tests/sim/yaml/yaml_values.hpp"

namespace armtune::internal::yaml {
namespace document_test {

using namespace test;

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

}  // namespace document_test
}  // namespace armtune::internal::yaml

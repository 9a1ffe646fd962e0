#include "sim/yaml/map_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "armtune/error.hpp"
#include "tests/core/support/refused_at.hpp"

namespace armtune::internal::yaml {
namespace map_reader_test {

using internal::test::refused_at;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

Node parse(const std::string& text) {
  return parse_text(text, "in.yaml");
}

TEST(MapReader, RefusesWhatIsNoMap) {
  const Node list = parse("[1, 2]");
  EXPECT_EQ(error_of([&] { MapReader reader(list); }),
            "in.yaml:1: the value is a list of 2; expected a map of 'key: value'");
}

TEST(MapReader, GivesOptionalValuesOrNothing) {
  const Node map = parse("a: 1\n");
  MapReader reader(map);
  ASSERT_NE(reader.optional("a"), nullptr);
  EXPECT_EQ(reader.optional("a")->as_integer(), 1);
  EXPECT_EQ(reader.optional("b"), nullptr);
}

TEST(MapReader, NamesAMissingRequiredKeyAndItsMap) {
  const Node root = parse("a: 1\nplant:\n  payload:\n    inertia: 1\n");
  const Node& payload = *root.find("plant")->find("payload");
  MapReader reader(payload);
  EXPECT_EQ(reader.required("inertia").as_number(), 1.0);
  EXPECT_EQ(error_of([&] { reader.required("mass"); }),
            "in.yaml:3: key 'plant/payload': missing key 'mass' in 'plant/payload'");
  EXPECT_THAT([&] { reader.required("mass"); },
              refused_at({.line = 3, .key = "plant/payload", .value = "", .limit = "the key 'mass'"}));
  MapReader top(root);
  EXPECT_EQ(error_of([&] { top.number("mass"); }), "in.yaml:1: missing key 'mass' in the document");
}

TEST(MapReader, PointsAtTheMisspeltKeyWhenARequiredOneIsMissing) {
  const Node map = parse("durration: 1\n");
  MapReader reader(map);
  EXPECT_EQ(error_of([&] { reader.required("duration"); }),
            "in.yaml:1: missing key 'duration' in the document; is 'durration' a misspelling of it?");
}

TEST(MapReader, DoesNotTakeAKeyThatWasReadForAMisspelling) {
  const Node map = parse("kp: 1\n");
  MapReader reader(map);
  reader.number("kp");
  EXPECT_EQ(error_of([&] { reader.required("kd"); }), "in.yaml:1: missing key 'kd' in the document");
}

TEST(MapReader, ReadsValuesThatAreThere) {
  const Node map = parse("n: 2.5\ni: 3\nb: true\ns: text\n");
  MapReader reader(map);
  EXPECT_EQ(reader.number("n"), 2.5);
  EXPECT_EQ(reader.number("n", 1.0), 2.5);
  EXPECT_EQ(reader.number_in("n", 1.0, 0.0, 3.0), 2.5);
  EXPECT_EQ(reader.integer("i", 1), 3);
  EXPECT_TRUE(reader.boolean("b", false));
  EXPECT_EQ(reader.string("s", "default"), "text");
  EXPECT_EQ(error_of([&] { reader.finish(); }), "no error");
}

TEST(MapReader, GivesDefaultsForAbsentKeys) {
  const Node map = parse("{}");
  MapReader reader(map);
  EXPECT_EQ(reader.number("n", 1.5), 1.5);
  EXPECT_EQ(reader.number_in("n", 7.0, 0.0, 10.0), 7.0);
  EXPECT_EQ(reader.integer("i", 4), 4);
  EXPECT_TRUE(reader.boolean("b", true));
  EXPECT_EQ(reader.string("s", "default"), "default");
}

TEST(MapReader, DoesNotHideAWrongTypeBehindADefault) {
  const Node map = parse("n: abc\ni: 3.0\nb: yes\ns: 5\ne:\n");
  MapReader reader(map);
  EXPECT_THAT([&] { reader.number("n", 1.0); }, refused_at({.line = 1, .key = "n", .value = "abc"}));
  EXPECT_THAT([&] { reader.number_in("n", 1.0, 0.0, 2.0); },
              refused_at({.line = 1, .key = "n", .value = "abc"}));
  EXPECT_THAT([&] { reader.integer("i", 1); }, refused_at({.line = 2, .key = "i", .value = "3.0"}));
  EXPECT_THAT([&] { reader.boolean("b", true); },
              refused_at({.line = 3, .key = "b", .value = "yes", .limit = "true or false"}));
  EXPECT_THAT([&] { reader.string("s", ""); },
              refused_at({.line = 4, .key = "s", .value = "5", .limit = "a text"}));
  EXPECT_THAT([&] { reader.number("e", 1.0); },
              refused_at({.line = 5, .key = "e", .value = "", .limit = "a number"}));
}

TEST(MapReader, RefusesANumberOutOfRangeWithValueAndLimits) {
  const Node map = parse("plant: {mass: 7}\n");
  MapReader reader(*map.find("plant"));
  EXPECT_EQ(error_of([&] { reader.number_in("mass", 1.0, 0.0, 5.5); }),
            "in.yaml:1: key 'plant/mass': 7 is out of range; expected 0 to 5.5");
  EXPECT_THAT([&] { reader.number_in("mass", 1.0, 0.0, 5.5); },
              refused_at({.line = 1, .key = "plant/mass", .value = "7", .limit = "0 to 5.5"}));
  EXPECT_THAT([&] { reader.number_in("mass", 9.0, 8.0, kInfinity); },
              refused_at({.value = "7", .limit = "at least 8"}));
  EXPECT_THAT([&] { reader.number_in("mass", 0.0, -kInfinity, 6.0); },
              refused_at({.value = "7", .limit = "at most 6"}));
}

TEST(MapReader, CountsBothLimitsAsInRange) {
  const Node map = parse("a: 0\nb: 5\n");
  MapReader reader(map);
  EXPECT_EQ(reader.number_in("a", 1.0, 0.0, 5.0), 0.0);
  EXPECT_EQ(reader.number_in("b", 1.0, 0.0, 5.0), 5.0);
}

TEST(MapReaderFinish, RefusesAnUnknownKeyWithTheNearestKnownOne) {
  const Node map = parse("robot: ur5\ndurration: 5\n");
  MapReader reader(map);
  reader.string("robot", "");
  reader.number("duration", 1.0);
  EXPECT_EQ(error_of([&] { reader.finish(); }),
            "in.yaml:2: key 'durration': unknown key 'durration' (did you mean 'duration'?); known keys: "
            "robot, duration");
  EXPECT_THAT(
      [&] { reader.finish(); },
      refused_at(
          {.line = 2, .key = "durration", .value = "durration", .limit = "the keys: robot, duration"}));
}

TEST(MapReaderFinish, ListsKnownKeysWhenNoneIsNear) {
  const Node root = parse("plant:\n  gravity: 5\n  other: 1\n");
  const Node& plant = *root.find("plant");
  MapReader reader(plant);
  EXPECT_THAT([&] { reader.finish(); },
              refused_at({.line = 2, .key = "plant/gravity", .limit = "the keys: none"}));
  reader.number("mass", 1.0);
  reader.number("mass", 1.0);
  EXPECT_THAT([&] { reader.finish(); },
              refused_at({.line = 2, .key = "plant/gravity", .limit = "the keys: mass"}));
}

TEST(MapReaderFinish, NamesTheFirstUnknownKeyOfTheFile) {
  const Node map = parse("z: 1\na: 2\n");
  MapReader reader(map);
  EXPECT_THAT([&] { reader.finish(); }, refused_at({.line = 1, .key = "z"}));
}

TEST(MapReaderFinish, AcceptsKeysThatWereReadAskedForOrIgnored) {
  const Node map = parse("a: 1\nb: 2\nc: 3\nd: 4\n");
  MapReader reader(map);
  reader.required("a");
  reader.optional("b");
  EXPECT_TRUE(reader.has("c"));
  EXPECT_FALSE(reader.has("e"));
  reader.ignore("d");
  EXPECT_EQ(error_of([&] { reader.finish(); }), "no error");
}

TEST(MapReaderFinish, AcceptsAnEmptyMap) {
  const Node map = parse("{}");
  EXPECT_EQ(error_of([&] { MapReader(map).finish(); }), "no error");
}

}  // namespace map_reader_test
}  // namespace armtune::internal::yaml

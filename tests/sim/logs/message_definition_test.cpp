#include "sim/logs/message_definition.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/logs/builtin_definitions.hpp"
#include "sim/logs/message_definitions.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace message_definition_test {

const InputPlace kPlace{"some.mcap", 0, "/topic"};
const std::string kBoundary = std::string(80, '=') + "\n";

MessageDefinition parsed(const std::string& schema) {
  return parse_ros2msg(schema, "pkg/msg/Root", kPlace);
}

std::vector<std::string> names_of(const MessageType& type) {
  std::vector<std::string> names;
  for (const MessageField& field : type.fields) names.push_back(field.name);
  return names;
}

TEST(MessageDefinition, HasTheFieldsInOrderWithoutConstantsCommentsAndDefaults) {
  const auto definition = parsed(
      "# a comment\r\n\n"
      "int32 LIMIT=5\n  uint8 OTHER = 3 # why\nstring TEXT = \"a # b\"\n"
      "\tint16 first 7\nstring second \"x = y\"  # comment\nfloat64[] third [1.0, 2.0]\nbool last# tight\n");
  EXPECT_EQ(definition.types.front().name, "pkg/Root");
  EXPECT_EQ(names_of(definition.types.front()),
            (std::vector<std::string>{"first", "second", "third", "last"}));
}

TEST(MessageDefinition, KnowsShapesAndBounds) {
  const auto fields = parsed("string<=10[<=5] a\nwstring[] b\nfloat32[9] c\nuint8[<=3] d\nbyte e\nchar f\n")
                          .types.front()
                          .fields;
  ASSERT_EQ(fields.size(), 6U);
  EXPECT_EQ(fields[0].string_size, 10U);
  EXPECT_EQ(fields[0].shape, FieldShape::kSequence);
  EXPECT_EQ(fields[0].size, 5U);
  EXPECT_EQ(fields[1].kind, FieldKind::kWstring);
  EXPECT_EQ(fields[1].size, 0U);
  EXPECT_EQ(fields[2].shape, FieldShape::kArray);
  EXPECT_EQ(fields[2].size, 9U);
  EXPECT_EQ(fields[3].size, 3U);
  EXPECT_EQ(fields[4].kind, FieldKind::kUint8);
  EXPECT_EQ(fields[5].kind, FieldKind::kUint8);
}

TEST(MessageDefinition, FindsTypesOfItsOwnPackageAndOfOthers) {
  const auto definition = parsed("Inner a\nother/Thing b\nother/msg/Thing[2] c\nbuiltin_interfaces/Time t\n" +
                                 kBoundary + "MSG: pkg/Inner\nbuiltin_interfaces/Duration d\n" + kBoundary +
                                 "MSG: other/msg/Thing\nfloat64 x\n");
  const auto& fields = definition.types.front().fields;
  EXPECT_EQ(definition.types[fields[0].type].name, "pkg/Inner");
  EXPECT_EQ(definition.types[fields[0].type].fields.front().kind, FieldKind::kDuration);
  EXPECT_EQ(definition.types[fields[1].type].name, "other/Thing");
  EXPECT_EQ(fields[1].type, fields[2].type);
  EXPECT_EQ(fields[3].kind, FieldKind::kTime);
}

TEST(MessageDefinition, EmptyTypeTakesOneByte) {
  ASSERT_EQ(parsed("# nothing\n").types.front().fields.size(), 1U);
  EXPECT_EQ(parsed("").types.front().fields.front().kind, FieldKind::kUint8);
}

TEST(MessageDefinition, CyclesAreRefused) {
  const std::string cycle = "A a\n" + kBoundary + "MSG: pkg/A\nB[] b\n" + kBoundary + "MSG: pkg/B\nA[] a\n";
  EXPECT_THAT([&] { return parsed(cycle); },
              test::refused_at({.file = "some.mcap", .key = "/topic", .value = "pkg/A"}));
  EXPECT_THAT([] { return parsed("Root again\n"); }, test::refused_at({.value = "pkg/Root"}));
}

TEST(MessageDefinition, UnknownTypesAndWrongLinesAreRefused) {
  using test::refused_at;
  EXPECT_THAT([] { return parsed("other/Thing b\n"); }, refused_at({.value = "other/Thing"}));
  EXPECT_THAT([] { return parsed("float64\n"); }, refused_at({.file = "some.mcap"}));
  EXPECT_THAT([] { return parsed("float64 1x\n"); }, refused_at({.file = "some.mcap"}));
  EXPECT_THAT([] { return parsed("../../etc/passwd x\n"); }, refused_at({.value = "../../etc/passwd"}));
  EXPECT_THAT([] { return parsed("int8 a\nint8 a\n"); }, refused_at({.value = "a"}));
  EXPECT_THAT([] { return parsed("int8 a\n" + kBoundary + "no head\n"); },
              refused_at({.limit = "MSG: PACKAGE/TYPE"}));
  for (const char* size : {"[0]", "[-1]", "[99999999999999999999]", "[16777217]", "[<=0]", "[<=4294967296]",
                           "[x]", "[", "]", "[2][2]"})
    EXPECT_THAT([&] { return parsed("float64" + std::string(size) + " x\n"); },
                refused_at({.file = "some.mcap", .key = "/topic"}))
        << size;
}

TEST(MessageDefinition, DeepAndWideSchemasAreRefused) {
  std::string deep = "T0 x\n";
  std::string wide;
  for (int i = 0; i < 100; ++i)
    deep += kBoundary + "MSG: pkg/T" + std::to_string(i) + "\nT" + std::to_string(i + 1) + " x\n";
  for (std::size_t i = 0; i <= kMostFields; ++i) wide += "int8 f" + std::to_string(i) + "\n";
  EXPECT_THAT([&] { return parsed(deep); },
              test::refused_at({.file = "some.mcap", .limit = testing::HasSubstr("32")}));
  EXPECT_THAT([&] { return parsed(wide); },
              test::refused_at({.file = "some.mcap", .limit = testing::HasSubstr("20000")}));
  EXPECT_THAT([] { return parsed(std::string(kMostDefinitionBytes + 1, '#')); },
              test::refused_at({.limit = "at most 4 MB"}));
}

TEST(MessageDefinitions, EveryBuiltInTypeIsWhole) {
  const MessageDefinitions definitions;
  for (const char* type :
       {"sensor_msgs/msg/JointState", "trajectory_msgs/msg/JointTrajectory",
        "geometry_msgs/msg/WrenchStamped", "geometry_msgs/msg/PoseStamped",
        "geometry_msgs/msg/TransformStamped", "tf2_msgs/msg/TFMessage", "std_msgs/msg/Header",
        "std_msgs/msg/Float64MultiArray", "rosgraph_msgs/msg/Clock", "builtin_interfaces/msg/Time",
        "sensor_msgs/msg/Imu", "geometry_msgs/msg/AccelStamped", "geometry_msgs/msg/TwistStamped",
        "control_msgs/msg/DynamicJointState"})
    EXPECT_EQ(definitions.of({"/t", type, "cdr", "", ""}, "a.db3").size(), 1U) << type;
  EXPECT_EQ(definitions.of({"/t", "control_msgs/msg/JointTrajectoryControllerState", "cdr", "", ""}, "a.db3")
                .size(),
            5U);
}

TEST(MessageDefinitions, TheSchemaOfTheFileComesFirst) {
  const MessageDefinitions definitions;
  const auto found =
      definitions.of({"/t", "std_msgs/msg/Float64", "cdr", "float32 other\n", "ros2msg"}, "a.db3");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().types.front().fields.front().name, "other");
}

TEST(MessageDefinitions, TypesOfTheUserComeFromTheirFolder) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "mine/msg");
  const std::string file = folder.write("mine/msg/State.msg", "std_msgs/Header header\nPart part\n");
  folder.write("mine/msg/Part.msg", "float64 x\nmissing/Type y\n");
  const MessageDefinitions definitions(folder.path());
  const BagTopic topic{"/t", "mine/msg/State", "cdr", "", ""};
  EXPECT_THAT([&] { return definitions.of(topic, "a.db3"); },
              test::refused_at({.file = folder / "mine/msg/Part.msg", .line = 2, .value = "missing/Type"}));
  folder.write("mine/msg/Part.msg", "float64 x\n");
  EXPECT_EQ(definitions.of(topic, "a.db3").front().types.size(), 3U);
  EXPECT_THAT([&] { return MessageDefinitions(file); }, test::refused_at({.file = file}));
}

TEST(MessageDefinitions, UnknownTypesAreRefusedWithTheirTopic) {
  const test::TemporaryFolder folder;
  const MessageDefinitions definitions(folder.path());
  for (const char* type : {"mine/msg/State", "../../x", "", "a/b/c/d"})
    EXPECT_THAT(
        [&] {
          return definitions.of({"/t", type, "cdr", "", ""}, "a.db3");
        },
        test::refused_at({.file = "a.db3", .key = "/t", .value = type}));
  EXPECT_THAT(
      [&] {
        return definitions.of({"/t", "mine/msg/State", "cdr", "struct", "ros2idl"}, "a.db3");
      },
      test::refused_at({.value = "mine/msg/State"}));
}

}  // namespace message_definition_test
}  // namespace armtune::internal

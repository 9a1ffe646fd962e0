// Messages of ROS 2 with their schemas, read back as numbers.

#include "sim/logs/ros_messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "sim/logs/builtin_schema.hpp"
#include "sim/logs/message_decoder.hpp"
#include "tests/core/support/refused_at.hpp"

namespace armtune::internal {
namespace ros_messages_test {

using testing::ElementsAre;

constexpr const char* kWritten[] = {"sensor_msgs/msg/JointState", "geometry_msgs/msg/PoseStamped",
                                    "tf2_msgs/msg/TFMessage", "std_msgs/msg/Float64"};

/// Decodes a message by the schema of its topic alone.
struct Decoded {
  MessageDecoder decoder;
  DecodedMessage message;

  Decoded(const char* type, std::span<const std::byte> bytes)
      : decoder(builtin_topic("/t", type), MessageDefinitions(), "a.mcap") {
    decoder.decode(bytes, message);
  }
};

/// A third of a turn about the diagonal, with the quaternion (0.5, 0.5, 0.5, 0.5), and an offset.
FramePose third_of_a_turn() {
  FramePose pose;
  pose.R << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  pose.p = Vec3(1.0, -2.0, 3.0);
  return pose;
}

TEST(RosMessages, SchemasDefineEveryTypeThatTheyUseOnce) {
  for (const char* type : kWritten) {
    const BagTopic topic = builtin_topic("/t", type);
    EXPECT_EQ(topic.encoding, "cdr");
    EXPECT_EQ(topic.schema_encoding, "ros2msg");
    const MessageDefinition stated = parse_ros2msg(topic.schema, type, {});
    BagTopic bare = topic;
    bare.schema.clear();
    const MessageDefinition known = MessageDefinitions().of(bare, "a.mcap").front();
    ASSERT_EQ(stated.types.size(), known.types.size()) << type;
    for (std::size_t k = 0; k < known.types.size(); ++k) {
      const std::string& name = known.types[k].name;
      EXPECT_EQ(stated.types[k].name, name);
      const std::size_t head = topic.schema.find("MSG: " + name + "\n");
      EXPECT_EQ(head == std::string::npos, k == 0) << name << " of " << type;
      const std::size_t again = topic.schema.rfind("MSG: " + name + "\n");
      EXPECT_EQ(again, head) << name << " stands twice";
    }
    const bool has_time = topic.schema.find("builtin_interfaces/Time stamp") != std::string::npos;
    EXPECT_EQ(topic.schema.find("MSG: builtin_interfaces/Time\nint32 sec") != std::string::npos, has_time);
  }
  EXPECT_THAT([] { return builtin_topic("/t", "nobody_msgs/msg/Unknown"); },
              test::refused_at({.key = "/t", .value = "nobody_msgs/Unknown"}));
}

TEST(RosMessages, JointStatesHaveNamesStampAndNumbers) {
  CdrWriter out;
  const std::vector<double> q = {0.1, -0.2};
  const std::vector<double> qd = {1.5, 2.5};
  const Decoded read(kWritten[0], joint_state_message(out, 12'000'000'345, {"a", "elbow"}, q, qd, {}));
  EXPECT_EQ(read.message.stamp, 12'000'000'345);
  EXPECT_THAT(read.decoder.labels(), ElementsAre("a", "elbow"));
  EXPECT_THAT(read.decoder.paths(),
              ElementsAre("/t/position[0]", "/t/position[1]", "/t/velocity[0]", "/t/velocity[1]"));
  EXPECT_THAT(read.message.values, ElementsAre(0.1, -0.2, 1.5, 2.5));
}

TEST(RosMessages, PosesHaveTheirQuaternionWithItsScalarLast) {
  CdrWriter out;
  FramePose quarter = third_of_a_turn();
  quarter.R = Eigen::AngleAxisd(std::acos(-1.0) / 2.0, Vec3::UnitZ()).toRotationMatrix();
  const Decoded read(kWritten[1], pose_message(out, 1, "base", quarter));
  EXPECT_EQ(read.message.stamp, 1);
  const double half = std::sqrt(0.5);
  EXPECT_THAT(read.message.values,
              testing::Pointwise(testing::DoubleNear(1e-15),
                                 std::vector<double>{1.0, -2.0, 3.0, 0.0, 0.0, half, half}));
  EXPECT_EQ(read.decoder.paths().back(), "/t/pose/orientation/w");
}

TEST(RosMessages, TransformsAndNumbersAreReadBack) {
  CdrWriter out;
  const std::vector<NamedTransform> frames = {{"base", "a", third_of_a_turn()}, {"a", "long_name", {}}};
  const Decoded read(kWritten[2], tf_message(out, 1'500'000'000, frames));
  EXPECT_THAT(read.message.values,
              testing::Pointwise(testing::DoubleNear(1e-15),
                                 std::vector<double>{1.5, 1.0, -2.0, 3.0, 0.5, 0.5, 0.5, 0.5,  //
                                                     1.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}));
  EXPECT_THAT(Decoded(kWritten[3], float_message(out, -0.125)).message.values, ElementsAre(-0.125));
}

}  // namespace ros_messages_test
}  // namespace armtune::internal

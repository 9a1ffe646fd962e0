#include "sim/logs/message_decoder.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tests/core/support/allocation_counter.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/sim/logs/cdr_writer.hpp"

namespace armtune::internal {
namespace message_decoder_test {

using test::CdrWriter;
using testing::ElementsAre;
using testing::IsEmpty;

MessageDecoder decoder_of(const std::string& schema) {
  return {BagTopic{"/t", "pkg/msg/Root", "cdr", schema, "ros2msg"}, MessageDefinitions(), "a.mcap"};
}

MessageDecoder builtin(const std::string& type) {
  return {BagTopic{"/t", type, "cdr", "", ""}, MessageDefinitions(), "a.db3"};
}

std::vector<double> decoded(MessageDecoder& decoder, const CdrWriter& message) {
  DecodedMessage result;
  decoder.decode(message.bytes(), result);
  EXPECT_EQ(result.values.size(), decoder.paths().size());
  EXPECT_EQ(decoder.units().size(), decoder.paths().size());
  return result.values;
}

/// Decodes the bytes when it is called.
auto decoding(MessageDecoder& decoder, std::span<const std::byte> bytes) {
  return [&decoder, bytes] {
    DecodedMessage result;
    decoder.decode(bytes, result);
    return result.values.size();
  };
}

CdrWriter joint_state(std::initializer_list<const char*> names, const std::vector<double>& position) {
  return CdrWriter().header(3, 500).strings(names).doubles(position).doubles({}).doubles({});
}

TEST(MessageDecoder, ReadsEveryPrimitiveTypeAlignedInBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    auto decoder = decoder_of(
        "bool a\nfloat64 b\nint8 c\nuint64 d\nuint8 e\nint16 f\nbyte g\n"
        "float32 h\nchar i\nint64 j\nuint16 k\nint32 l\nuint32 m\n");
    CdrWriter writer(order);
    writer.number(std::uint8_t{7})
        .number(-1.5)
        .number(std::int8_t{-2})
        .number(std::uint64_t{1} << 40U)
        .number(std::uint8_t{200});
    writer.number(std::int16_t{-300})
        .number(std::uint8_t{9})
        .number(0.25F)
        .number(std::uint8_t{65})
        .number(std::int64_t{-5});
    writer.number(std::uint16_t{60'000}).number(std::int32_t{-70'000}).number(std::uint32_t{4'000'000'000U});
    EXPECT_THAT(decoded(decoder, writer), ElementsAre(1.0, -1.5, -2.0, std::pow(2.0, 40), 200.0, -300.0, 9.0,
                                                      0.25, 65.0, -5.0, 60'000.0, -70'000.0, 4e9));
    EXPECT_EQ(decoder.paths()[1], "/t/b");
  }
}

TEST(MessageDecoder, NamesNestedFieldsAndElements) {
  auto decoder = decoder_of("Part[2] parts\nfloat64[] free\nbuiltin_interfaces/Duration wait\n" +
                            std::string(80, '=') + "\nMSG: pkg/Part\nstring text\nfloat32[2] x\n");
  CdrWriter writer;
  writer.string("abc").number(1.0F).number(2.0F).string("").number(3.0F).number(4.0F);
  writer.doubles({5.0}).number(std::int32_t{-1}).number(std::uint32_t{750'000'000});
  EXPECT_THAT(decoded(decoder, writer), ElementsAre(1.0, 2.0, 3.0, 4.0, 5.0, -0.25));
  EXPECT_THAT(decoder.paths(), ElementsAre("/t/parts[0]/x[0]", "/t/parts[0]/x[1]", "/t/parts[1]/x[0]",
                                           "/t/parts[1]/x[1]", "/t/free[0]", "/t/wait"));
  EXPECT_EQ(decoder.units().back(), "s");
}

TEST(MessageDecoder, EmptySequencesAreNotAligned) {
  auto decoder = decoder_of("float64[] a\nint32 b\n");
  EXPECT_THAT(decoded(decoder, CdrWriter().length(0).number(std::int32_t{8})), ElementsAre(8.0));
}

TEST(MessageDecoder, TakesTheStampOfTheHeaderUnlessItIsZero) {
  auto decoder = builtin("geometry_msgs/msg/WrenchStamped");
  DecodedMessage message;
  CdrWriter writer;
  writer.header(1'700'000'000, 25, "tool");
  for (double value = 1.0; value < 7.0; ++value) writer.number(value);
  decoder.decode(writer.bytes(), message);
  EXPECT_EQ(message.stamp, 1'700'000'000'000'000'025);
  EXPECT_THAT(message.values, ElementsAre(1.0, 2.0, 3.0, 4.0, 5.0, 6.0));
  EXPECT_THAT(decoder.paths().front(), "/t/wrench/force/x");
  EXPECT_THAT(decoder.units(), ElementsAre("N", "N", "N", "N m", "N m", "N m"));
  CdrWriter without;
  without.header(0, 0);
  for (int i = 0; i < 6; ++i) without.number(0.0);
  decoder.decode(without.bytes(), message);
  EXPECT_FALSE(message.stamp);
}

TEST(MessageDecoder, SequencesThatGrowMakeChannelsAndLeaveNan) {
  auto decoder = decoder_of("float64[] a\nfloat64[] b\n");
  EXPECT_THAT(decoded(decoder, CdrWriter().doubles({1.0}).doubles({2.0})), ElementsAre(1.0, 2.0));
  EXPECT_THAT(decoded(decoder, CdrWriter().doubles({1.0, 3.0}).doubles({2.0})), ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(decoder.paths(), ElementsAre("/t/a[0]", "/t/b[0]", "/t/a[1]"));
  const auto values = decoded(decoder, CdrWriter().doubles({}).doubles({7.0}));
  EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[2]));
  EXPECT_EQ(values[1], 7.0);
}

TEST(MessageDecoder, OtherNamesOnTheSameTopicGetTheirOwnChannels) {
  auto decoder = builtin("sensor_msgs/msg/JointState");
  EXPECT_THAT(decoded(decoder, joint_state({"a", "b"}, {1.0, 2.0})), ElementsAre(1.0, 2.0));
  EXPECT_EQ(decoder.label_changes(), 0U);
  EXPECT_THAT(decoded(decoder, joint_state({"b", "a"}, {2.5, 1.5})), ElementsAre(1.5, 2.5));
  const auto gripper = decoded(decoder, joint_state({"finger"}, {9.0}));
  EXPECT_TRUE(std::isnan(gripper[0]) && std::isnan(gripper[1]));
  EXPECT_EQ(gripper[2], 9.0);
  EXPECT_THAT(decoded(decoder, joint_state({"a", "b"}, {1.0, 2.0}))[1], 2.0);
  EXPECT_THAT(decoder.labels(), ElementsAre("a", "b", "finger"));
  EXPECT_EQ(decoder.label_changes(), 3U);
}

TEST(MessageDecoder, NamesThatOccurTwiceKeepTheirPlaces) {
  auto decoder = builtin("sensor_msgs/msg/JointState");
  EXPECT_THAT(decoded(decoder, joint_state({"a", "a"}, {1.0, 2.0})), ElementsAre(1.0, 2.0));
}

TEST(MessageDecoder, FindsOutWhichControllerStateItIs) {
  const std::string type = "control_msgs/msg/JointTrajectoryControllerState";
  for (const int points : {3, 4, 6}) {
    for (const bool has_factor : {false, true}) {
      for (const int multi : {0, 3, 4, 6}) {
        const bool exists =
            points == 3 ? multi <= 3 && !has_factor : multi == points && (points == 4 || !has_factor);
        if (!exists || (points > 3 && multi == 0)) continue;
        CdrWriter writer;
        writer.header(1, 0).strings({"j1", "j2"});
        for (int i = 0; i < points; ++i) writer.point({10.0 * i, 10.0 * i + 1.0});
        if (multi > 0) writer.length(0);
        for (int i = 0; i < multi; ++i) writer.empty_multi_dof_point();
        if (has_factor) writer.number(0.5);
        auto decoder = builtin(type);
        const auto values = decoded(decoder, writer);
        EXPECT_EQ(decoder.paths().front(),
                  points == 3 ? "/t/desired/positions[0]" : "/t/reference/positions[0]");
        EXPECT_EQ(decoder.paths()[3], points == 3 ? "/t/actual/positions[0]" : "/t/feedback/positions[0]");
        EXPECT_EQ(values[3], 10.0);
        EXPECT_EQ(values[2], 1.5);
        EXPECT_EQ(decoder.paths().back() == "/t/speed_scaling_factor", has_factor);
        EXPECT_EQ(values.size(), static_cast<std::size_t>(3 * points + multi + (has_factor ? 1 : 0)));
      }
    }
  }
}

TEST(MessageDecoder, LongArraysAreSkippedAndCounted) {
  auto decoder = decoder_of("uint8[] image\nfloat64 x\nfloat64[300] cloud\nfloat64 y\n");
  CdrWriter writer;
  writer.length(1001);
  for (int i = 0; i < 1001; ++i) writer.number(std::uint8_t{1});
  writer.number(2.0);
  for (int i = 0; i < 300; ++i) writer.number(0.0);
  writer.number(3.0);
  EXPECT_THAT(decoded(decoder, writer), ElementsAre(2.0, 3.0));
  EXPECT_EQ(decoder.skipped_arrays(), 2U);
}

TEST(MessageDecoder, WstringsOfBothMiddlewaresArePassedOver) {
  const std::string schema = "wstring text\nfloat64 x\n";
  CdrWriter fast;
  fast.length(3).number(std::uint32_t{'a'}).number(std::uint32_t{'b'}).number(std::uint32_t{'c'}).number(4.0);
  CdrWriter cyclone;
  cyclone.length(6)
      .number(std::uint16_t{'a'})
      .number(std::uint16_t{'b'})
      .number(std::uint16_t{'c'})
      .number(4.0);
  for (const CdrWriter& writer : {fast, cyclone}) {
    auto decoder = decoder_of(schema);
    EXPECT_THAT(decoded(decoder, writer), ElementsAre(4.0));
  }
}

TEST(MessageDecoder, EveryTruncationIsRefused) {
  const CdrWriter whole = joint_state({"a", "b"}, {1.0, 2.0});
  auto decoder = builtin("sensor_msgs/msg/JointState");
  for (std::size_t size = 0; size < whole.bytes().size(); ++size) {
    EXPECT_THAT(decoding(decoder, std::span(whole.bytes()).first(size)),
                test::refused_at({.file = "a.db3", .key = "/t", .value = std::to_string(size)}));
  }
  EXPECT_THAT(decoder.paths(), IsEmpty());
  EXPECT_THAT(decoded(decoder, whole), ElementsAre(1.0, 2.0));
}

TEST(MessageDecoder, BytesThatDoNotFitAreRefused) {
  const auto refused = [](MessageDecoder& decoder, const CdrWriter& writer) {
    EXPECT_THAT(decoding(decoder, writer.bytes()), test::refused_at({.file = "a.mcap", .key = "/t"}));
  };
  auto bounded = decoder_of("float64[<=2] a\n");
  refused(bounded, CdrWriter().doubles({1.0, 2.0, 3.0}));
  auto text = decoder_of("string<=2 a\n");
  refused(text, CdrWriter().string("abc"));
  EXPECT_THAT(decoded(text, CdrWriter().string("ab")), IsEmpty());
  auto lying = decoder_of("float64[] a\n");
  refused(lying, CdrWriter().length(0xffffffffU));
  refused(lying, CdrWriter().length(3).number(1.0));
  refused(lying, CdrWriter().doubles({1.0}).number(std::uint32_t{0}));
  auto huge =
      decoder_of("Part[16777216] a\n" + std::string(80, '=') + "\nMSG: pkg/Part\nfloat64[16777216] x\n");
  refused(huge, CdrWriter().number(1.0));
  EXPECT_THAT(huge.paths(), IsEmpty());
}

TEST(MessageDecoder, EncodingsThatAreNotCdrAreRefused) {
  const auto of_ros1 = [] {
    const BagTopic topic{"/t", "std_msgs/msg/Float64", "ros1", "", ""};
    return MessageDecoder(topic, MessageDefinitions(), "a.mcap").paths().size();
  };
  EXPECT_THAT(of_ros1, test::refused_at({.file = "a.mcap", .key = "/t", .value = "ros1"}));
  auto decoder = builtin("std_msgs/msg/Float64");
  for (const unsigned kind : {0x02U, 0x03U, 0x06U, 0x07U, 0x0bU}) {  // PL_CDR and XCDR2
    auto bytes = CdrWriter().number(1.0).bytes();
    bytes[1] = static_cast<std::byte>(kind);
    EXPECT_THAT(decoding(decoder, bytes), test::refused_at({.key = "/t"}));
  }
}

TEST(MessageDecoder, ChannelsAreBounded) {
  auto decoder = decoder_of("Part[] parts\n" + std::string(80, '=') + "\nMSG: pkg/Part\nfloat64[] x\n");
  CdrWriter writer;
  writer.length(200);
  for (int i = 0; i < 200; ++i) writer.doubles(std::vector<double>(200, 1.0));
  EXPECT_LE(decoded(decoder, writer).size(), MessageDecoder::kMostChannels);
  EXPECT_GT(decoder.skipped_arrays(), 0U);
}

TEST(MessageDecoder, DoesNotAllocateForMessagesLikeThoseBefore) {
  if (!test::allocations_are_counted()) GTEST_SKIP();
  auto decoder = builtin("sensor_msgs/msg/JointState");
  const CdrWriter arm = joint_state({"a", "b"}, {1.0, 2.0});
  const CdrWriter gripper = joint_state({"finger"}, {1.0});
  DecodedMessage message;
  for (const CdrWriter* one : {&arm, &gripper, &arm}) decoder.decode(one->bytes(), message);
  const long before = test::allocations();
  for (int i = 0; i < 100; ++i) decoder.decode(i % 2 == 0 ? arm.bytes() : gripper.bytes(), message);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace message_decoder_test
}  // namespace armtune::internal

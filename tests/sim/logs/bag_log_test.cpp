// Messages of a bag as numbers against time.

#include "sim/logs/bag_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <limits>

#include "sim/logs/bag_rows.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/sim/logs/cdr_writer.hpp"

namespace armtune::internal {
namespace bag_log_test {

using test::CdrWriter;
using test::refused_at;
using testing::ElementsAre;

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kStart = 1'700'000'000 * kSecond;

/// A bag in memory.
class MemoryBag final : public BagReader {
 public:
  std::size_t add_topic(const std::string& name, const std::string& type) {
    topics_.push_back({name, type, "cdr", "", ""});
    return topics_.size() - 1;
  }
  void add(std::size_t topic, std::int64_t time, const CdrWriter& message) {
    const auto bytes = message.bytes();
    messages_.push_back({topic, time, {bytes.begin(), bytes.end()}});
  }
  const std::vector<BagTopic>& topics() const override { return topics_; }
  std::optional<BagMessage> next() override {
    if (at_ >= messages_.size()) return std::nullopt;
    const Kept& kept = messages_[at_++];
    return BagMessage{kept.topic, kept.time, kept.bytes};
  }
  bool unfinished() const override { return killed; }

  bool killed = false;  ///< true: as if the recorder had been killed

 private:
  struct Kept {
    std::size_t topic;
    std::int64_t time;
    std::vector<std::byte> bytes;
  };
  std::vector<BagTopic> topics_;
  std::deque<Kept> messages_;
  std::size_t at_ = 0;
};

CdrWriter joint_state(std::int64_t stamp, double q) {
  return CdrWriter()
      .header(static_cast<std::int32_t>(stamp / kSecond), static_cast<std::uint32_t>(stamp % kSecond))
      .strings({"elbow"})
      .doubles({q})
      .doubles({})
      .doubles({});
}

/// Messages of one topic, with the stamps that are given in ms after `clock`; recorded 5 ms later than in
/// order.
MemoryBag joint_bag(const std::vector<int>& stamps, std::int64_t clock = kStart) {
  MemoryBag bag;
  bag.add_topic("/joint_states", "sensor_msgs/msg/JointState");
  for (std::size_t k = 0; k < stamps.size(); ++k)
    bag.add(0, kStart + static_cast<std::int64_t>(k) * 10'000'000 + 5'000'000,
            joint_state(clock + std::int64_t{stamps[k]} * 1'000'000, stamps[k]));
  return bag;
}

Log read(BagReader& bag, const std::vector<std::string>& topics = {}) {
  LogSelection selection;
  selection.topics = topics;
  return read_bag(bag, MessageDefinitions(), "a.mcap", selection);
}

LogSummary summarize(BagReader& bag, const std::vector<std::string>& topics = {}) {
  LogSelection selection;
  selection.topics = topics;
  return summarize_bag(bag, MessageDefinitions(), "a.mcap", selection);
}

TEST(BagLog, HasTheStampsOfTheMessagesInOrder) {
  MemoryBag bag = joint_bag({0, 20, 10, 30, 30});
  const Log log = read(bag);
  ASSERT_EQ(log.topics.size(), 1U);
  const LogTopic& topic = log.topics[0];
  ASSERT_EQ(topic.time.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(topic.time[k], 1e-3 * topic.channels[0].value[k], 1e-9);
  EXPECT_THAT(topic.channels[0].value, ElementsAre(0, 10, 20, 30, 30));
  EXPECT_THAT(topic.labels, ElementsAre("elbow"));
  EXPECT_NEAR(log.start, 1.7e9, 1e-6);
}

TEST(BagLog, SummarisesTheSameRows) {
  MemoryBag bag = joint_bag({0, 20, 10, 30, 30});
  const LogSummary summary = summarize(bag);
  ASSERT_EQ(summary.topics.size(), 1U);
  EXPECT_EQ(summary.topics[0].rows, 5);
  EXPECT_EQ(summary.topics[0].repeated, 1);
  EXPECT_EQ(summary.topics[0].backward, 1);
  EXPECT_EQ(summary.topics[0].channels[0].greatest, 30.0);
  EXPECT_EQ(summary.topics[0].first, 0.0);
  EXPECT_NEAR(summary.topics[0].last, 0.03, 1e-9);
}

TEST(BagLog, WhoseClockIsResetIsRefused) {
  std::vector<int> stamps;
  for (int k = 0; k < 300; ++k) stamps.push_back(10 * (k % 150));
  MemoryBag bag = joint_bag(stamps);
  EXPECT_THAT([&] { return read(bag); }, refused_at({.file = "a.mcap", .key = "/joint_states"}));
}

TEST(BagLog, ShiftsSimulatedTimeToTheRecording) {
  // The stamps begin at 3 s of a simulation; another topic has only the times of the recording.
  MemoryBag bag = joint_bag({0, 10, 20}, 3 * kSecond);
  const std::size_t commands = bag.add_topic("/commands", "std_msgs/msg/Float64MultiArray");
  CdrWriter message;
  message.length(0).number(std::uint32_t{0}).doubles({1.5});
  bag.add(commands, kStart + 25'000'000, message);
  const LogSummary summary = summarize(bag);
  ASSERT_EQ(summary.topics.size(), 2U);
  EXPECT_NEAR(summary.topics[0].first, 0.0, 1e-6);
  EXPECT_NEAR(summary.topics[1].first, 0.02, 1e-6);
  EXPECT_EQ(summary.notes.size(), 1U);
}

// A stamp of 0 is none, but simulations begin at 0.
TEST(BagLog, TimesThatBeginAtZeroAreKept) {
  MemoryBag of_simulation;
  of_simulation.add_topic("/joint_states", "sensor_msgs/msg/JointState");
  for (const std::int64_t stamp : {0, 10'000'000, 20'000'000})
    of_simulation.add(0, stamp, joint_state(stamp, 1.0));
  const Log log = read(of_simulation);
  EXPECT_EQ(log.start, 0.0);
  EXPECT_THAT(log.topics.at(0).time, ElementsAre(0.0, 0.01, 0.02));
  MemoryBag recorded = joint_bag({0, 10, 20}, 0);  // by a recorder with another clock
  EXPECT_THAT(read(recorded).topics.at(0).time,
              ElementsAre(0.0, testing::DoubleNear(0.01, 1e-9), testing::DoubleNear(0.02, 1e-9)));
}

TEST(BagLog, CountsTopicsThatItCannotDecode) {
  MemoryBag bag = joint_bag({0, 10});
  const std::size_t other = bag.add_topic("/other", "nobody_msgs/msg/Unknown");
  bag.add(other, kStart, CdrWriter());
  const LogSummary summary = summarize(bag);
  ASSERT_EQ(summary.topics.size(), 2U);
  EXPECT_EQ(summary.topics[1].rows, 1);
  EXPECT_FALSE(summary.topics[1].trouble.empty());
  EXPECT_TRUE(summary.topics[0].trouble.empty());
  MemoryBag again = joint_bag({0, 10});
  again.add(again.add_topic("/other", "nobody_msgs/msg/Unknown"), kStart, CdrWriter());
  EXPECT_THAT([&] { return read(again); }, refused_at({.file = "a.mcap", .key = "/other"}));
  MemoryBag selected = joint_bag({0, 10});
  selected.add(selected.add_topic("/other", "nobody_msgs/msg/Unknown"), kStart, CdrWriter());
  EXPECT_EQ(read(selected, {"/joint*"}).topics.size(), 1U);
}

TEST(BagLog, CountsDamagedMessages) {
  MemoryBag bag = joint_bag({0, 10, 20});
  bag.add(0, kStart + kSecond, CdrWriter().header(1, 0).length(1'000'000));
  const LogSummary summary = summarize(bag);
  EXPECT_EQ(summary.topics[0].rows, 4);
  EXPECT_EQ(summary.topics[0].channels[0].missing, 1);
  EXPECT_FALSE(summary.topics[0].trouble.empty());
}

TEST(BagLog, WithoutASelectedTopicIsRefused) {
  MemoryBag bag = joint_bag({0, 10});
  EXPECT_THAT([&] { return summarize(bag, {"/joint_state"}).topics.size(); },
              refused_at({.file = "a.mcap", .key = "--topic", .value = "/joint_state"}));
  MemoryBag empty;
  EXPECT_THAT([&] { return read(empty).topics.size(); }, refused_at({.file = "a.mcap"}));
}

TEST(MessageClock, TakesTimesOfAnySize) {
  MessageClock clock;
  std::optional<std::int64_t> shift;
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t recorded : {kLeast, kMost, std::int64_t{0}}) {
    for (const std::int64_t stamp : {kLeast, kMost})
      EXPECT_TRUE(std::isfinite(clock.time(stamp, recorded, shift)));
  }
}

TEST(BagLog, AFileThatItsRecorderDidNotFinishIsNoted) {
  for (const bool killed : {false, true}) {
    MemoryBag bag = joint_bag({0, 10, 20});
    bag.killed = killed;
    const LogSummary summary = summarize_bag(bag, MessageDefinitions(), "a.mcap", {});
    EXPECT_EQ(summary.notes.size(), killed ? 1U : 0U);
    EXPECT_EQ(summary.topics.at(0).rows, 3);
  }
}

}  // namespace bag_log_test
}  // namespace armtune::internal

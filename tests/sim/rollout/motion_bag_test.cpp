// MCAP files of motions, against the motions that they were written from.

#include "sim/rollout/motion_bag.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/robot/kinematics.hpp"
#include "sim/logs/cdr_reader.hpp"
#include "sim/logs/log_reader.hpp"
#include "sim/logs/ros_messages.hpp"
#include "sim/rollout/recorder.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/sim/logs/support/mcap_files.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace motion_bag_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A recorded rollout and its MCAP file, read back.
class BagOfARollout {
 public:
  explicit BagOfARollout(const Scenario& scenario) {
    Recorder recorder(scenario, 5);
    metrics = Rollout(scenario, Stepper::kMidpoint)
                  .run(test::quick_gains(scenario), [&](const Observation& o) { return recorder(o); })
                  .metrics;
    columns = column_names(recorder.columns());
    values = recorder.rows();
    path = folder / "run.mcap";
    write_motion_bag(path, {*scenario.robot, columns, values}, &metrics);
    log = read_log(path, {});
  }

  std::size_t rows() const { return values.size() / columns.size(); }
  std::vector<double> column(const std::string& name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    std::vector<double> column;
    for (std::size_t at = static_cast<std::size_t>(found - columns.begin()); at < values.size();
         at += columns.size())
      column.push_back(values[at]);
    return column;
  }
  const LogTopic& topic(const std::string& name) const {
    const auto found = std::find_if(log.topics.begin(), log.topics.end(),
                                    [&](const LogTopic& one) { return one.name == name; });
    EXPECT_TRUE(found != log.topics.end()) << name;
    return found == log.topics.end() ? nothing : *found;
  }
  std::vector<double> channel(const std::string& topic_name, const std::string& field) const {
    for (const LogChannel& channel : topic(topic_name).channels) {
      if (channel.name == topic_name + field) return channel.value;
    }
    ADD_FAILURE() << topic_name << field;
    return {};
  }

  test::TemporaryFolder folder;
  std::string path;
  std::vector<std::string> columns;
  std::vector<double> values;
  Metrics metrics;
  Log log;
  LogTopic nothing;
};

std::vector<double> finite(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  return values;
}

struct Frame {
  std::string parent, child;
  FramePose pose;
};

/// Reads a tf2_msgs/TFMessage field by field.
std::vector<Frame> frames_in(const std::string& bytes) {
  CdrReader reader(test::as_raw(bytes));
  std::vector<Frame> frames(reader.length(0));
  for (Frame& frame : frames) {
    reader.number<std::int32_t>();
    reader.number<std::uint32_t>();
    frame.parent = reader.string(0);
    frame.child = reader.string(0);
    for (int k = 0; k < 3; ++k) frame.pose.p[k] = reader.number<double>();
    Eigen::Quaterniond turn;
    for (int k = 0; k < 4; ++k) turn.coeffs()[k] = reader.number<double>();
    EXPECT_NEAR(turn.norm(), 1.0, 1e-15);
    frame.pose.R = turn.toRotationMatrix();
  }
  EXPECT_EQ(reader.fault(), CdrFault::kNone);
  EXPECT_EQ(reader.rest(), 0U);
  return frames;
}

/// One topic of a file.
Log read_topic(const std::string& path, const std::string& topic) {
  LogSelection selection;
  selection.topics = {topic};
  return read_log(path, selection);
}

/// The frames of all messages of a topic.
std::vector<std::vector<Frame>> frames_on(const std::string& topic, const std::string& path) {
  std::vector<std::vector<Frame>> all;
  for (const test::KeptMessage& message : test::read_whole(path).messages) {
    if (message.topic == topic) all.push_back(frames_in(message.bytes));
  }
  return all;
}

TEST(MotionBag, HoldsEveryNumberOfARecordingAtItsTime) {
  const Scenario scenario = test::scenario_of("obstacle_pass", 4.0);
  const BagOfARollout run(scenario);
  const std::vector<double> time = run.column("time");
  ASSERT_EQ(run.topic("/joint_states").time.size(), run.rows());
  EXPECT_EQ(run.topic("/joint_states").labels, joint_names(*scenario.robot));
  for (std::size_t row = 0; row < run.rows(); ++row)
    EXPECT_NEAR(run.topic("/joint_states").time[row], time[row], 1e-9);
  std::set<std::string> held = {"time"};
  for (int i = 0; i < scenario.robot->n(); ++i) {
    const std::string tree = "joint/" + scenario.robot->joints[static_cast<std::size_t>(i)].name + "/";
    const std::string index = "[" + std::to_string(i) + "]";
    const std::map<std::string, std::string> fields = {
        {"position", "/position"}, {"velocity", "/velocity"}, {"torque", "/effort"}};
    for (const auto& [column, field] : fields) {
      EXPECT_EQ(run.channel("/joint_states", field + index), run.column(tree + column)) << tree << column;
      held.insert(tree + column);
    }
  }
  for (const char* axis : {"x", "y", "z"}) {
    const std::string part = std::string("/") + axis;
    EXPECT_EQ(run.channel("/target_pose", "/pose/position" + part), run.column("desired/position" + part));
    EXPECT_EQ(run.channel("/gaze_target", "/pose/position" + part), run.column("target/position" + part));
    EXPECT_THAT(run.channel("/tool_pose", "/pose/position" + part),
                testing::Pointwise(testing::DoubleNear(1e-12), run.column("tool/position" + part)));
  }
  for (const std::string& column : run.columns) {
    const bool in_pose = column.starts_with("tool/") || column.starts_with("desired/") ||
                         column.starts_with("target/position/");
    if (held.contains(column) || in_pose || finite(run.column(column)).empty()) continue;
    EXPECT_EQ(run.channel("/recording/" + column, "/data"), finite(run.column(column))) << column;
  }
}

TEST(MotionBag, EndsWithEachMetricThatHasAValue) {
  const BagOfARollout run(test::scenario_of("moving_target", 4.0));
  std::size_t written = 0;
  for (const LogTopic& topic : run.log.topics) written += topic.name.starts_with("/metrics/") ? 1 : 0;
  std::size_t expected = 0;
  for (const Metric metric : all_metrics()) {
    if (!std::isfinite(run.metrics[metric])) continue;
    ++expected;
    const std::string topic = std::string("/metrics/") + name(metric);
    EXPECT_THAT(run.channel(topic, "/data"), testing::ElementsAre(run.metrics[metric]));
    EXPECT_NEAR(run.topic(topic).time.front(), run.column("time").back(), 1e-9);
  }
  EXPECT_EQ(written, expected);
  EXPECT_GT(expected, 10U);
}

TEST(MotionBag, FramesOfAllLinksEqualForwardKinematics) {
  const Scenario scenario = test::scenario_of("moving_target", 0.5);
  const RobotModel& robot = *scenario.robot;
  const BagOfARollout run(scenario);
  const auto fixed = frames_on("/tf_static", run.path);
  const auto moving = frames_on("/tf", run.path);
  ASSERT_EQ(fixed.size(), 1U);
  ASSERT_EQ(moving.size(), run.rows());
  EXPECT_EQ(fixed[0][0].parent, "map");
  EXPECT_EQ(fixed[0][0].child, robot.base_link);
  EXPECT_LT((fixed[0][0].pose.R * robot.chain.gravity.normalized() + Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_EQ(fixed[0].size() + moving[0].size(), robot.links.size() + 1)
      << "the links but the base, map, tool";
  Poses poses;
  for (std::size_t row = 0; row < run.rows(); ++row) {
    JointVector q(robot.n());
    std::map<std::string, FramePose> frames;
    for (const Frame& frame : moving[row]) {
      EXPECT_EQ(frame.parent, robot.base_link);
      EXPECT_TRUE(frames.emplace(frame.child, frame.pose).second) << frame.child;
    }
    for (int i = 0; i < robot.n(); ++i)
      q[i] = run.column("joint/" + robot.joints[static_cast<std::size_t>(i)].name + "/position")[row];
    forward_kinematics(robot.chain, q, poses);
    EXPECT_LT((frames.at("tool").p - poses.p_0T).norm(), 1e-12);
    EXPECT_LT((frames.at("tool").R - poses.R_0T).norm(), 1e-12);
    for (const LinkFrame& link : robot.links) {
      if (link.body < 0) continue;
      const auto body = static_cast<std::size_t>(link.body);
      const FramePose& pose = frames.at(link.name);
      EXPECT_LT((pose.p - poses.p_0B[body] - poses.R_0B[body] * link.p_BL).norm(), 1e-12) << link.name;
      EXPECT_LT((pose.R - poses.R_0B[body] * link.R_BL).norm(), 1e-12) << link.name;
    }
  }
}

/// Two rows of an arm, of which only the second has planned positions; all joints of a row are equal.
MotionTable two_rows(const RobotModel& robot, double second) {
  MotionTable motion{robot, {"time"}, {}};
  for (const std::string& joint : joint_names(robot)) {
    for (const char* field : {"position", "velocity", "torque", "planned"})
      motion.columns.push_back("joint/" + joint + "/" + field);
  }
  for (const double time : {0.0, second}) {
    motion.values.push_back(time);
    for (int i = 0; i < robot.n(); ++i)
      motion.values.insert(motion.values.end(), {0.3, 0.0, 1.0, time == 0.0 ? kNan : 0.4});
  }
  return motion;
}

TEST(MotionBag, ReferencesStandWhereThePlanIsFollowed) {
  const auto robot = load_robot("ur10");
  const test::TemporaryFolder files;
  write_motion_bag(files / "a.mcap", two_rows(*robot, 0.25));
  const Log references = read_topic(files / "a.mcap", "/joint_references");
  ASSERT_EQ(references.topics.size(), 1U);
  EXPECT_EQ(references.start, 0.25);
  EXPECT_EQ(references.topics[0].labels, joint_names(*robot));
  for (const LogChannel& channel : references.topics[0].channels)
    EXPECT_THAT(channel.value, testing::ElementsAre(0.4)) << channel.name;
  Poses poses;
  const JointVector planned = JointVector::Constant(robot->n(), 0.4);
  forward_kinematics(robot->chain, planned, poses);
  const Log target = read_topic(files / "a.mcap", "/target_pose");
  ASSERT_EQ(target.topics.size(), 1U);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(target.topics[0].channels[axis].value.at(0), poses.p_0T[static_cast<int>(axis)], 1e-12);
}

// A stamp of 0 is no stamp for the reader, which then takes the time of recording.
TEST(MotionBag, ItsTimesAreReadFromZeroOn) {
  const auto robot = load_robot("ur10");
  const test::TemporaryFolder files;
  write_motion_bag(files / "a.mcap", two_rows(*robot, 0.25));
  const Log log = read_log(files / "a.mcap", {});
  EXPECT_EQ(log.start, 0.0);
  for (const LogTopic& topic : log.topics) {
    const bool is_planned = topic.name == "/joint_references" || topic.name == "/target_pose";
    std::vector<double> expected = {0.0, 0.25};
    if (is_planned) expected = {0.25};
    if (topic.name == "/tf_static") expected = {0.0};
    EXPECT_EQ(topic.time, expected) << topic.name;
  }
}

TEST(MotionBag, IsTheSameFileEachTimeAndNamesAMissingColumn) {
  const auto robot = load_robot("ur10");
  const test::TemporaryFolder files;
  MotionTable motion = two_rows(*robot, 0.25);
  write_motion_bag(files / "a.mcap", motion);
  write_motion_bag(files / "b.mcap", motion);
  EXPECT_EQ(test::read_text(files / "a.mcap"), test::read_text(files / "b.mcap"));
  motion.values.clear();
  write_motion_bag(files / "empty.mcap", motion);
  EXPECT_TRUE(test::read_whole(files / "empty.mcap").messages.empty());
  const std::string column = motion.columns[2];
  motion.columns[2] = "other";
  EXPECT_THAT([&] { write_motion_bag(files / "c.mcap", motion); }, test::refused_at({.key = column}));
}

}  // namespace motion_bag_test
}  // namespace armtune::internal

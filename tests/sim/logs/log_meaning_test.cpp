// What channels look like: by their names, and by laws that their values obey.

#include "sim/logs/log_meaning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

namespace armtune::internal {
namespace log_meaning_test {

using testing::HasSubstr;

/// A channel as a function of time.
struct Signal {
  std::string name;
  std::function<double(double)> value;
  std::string unit = {};
};

double angle(int joint, double t) {
  return 0.5 * (joint + 1) * std::sin((1.0 + 0.3 * joint) * t + joint);
}
double rate(int joint, double t) {
  return 0.5 * (joint + 1) * (1.0 + 0.3 * joint) * std::cos((1.0 + 0.3 * joint) * t + joint);
}

/// Adds n signals NAME0, NAME1 and so on.
void add(std::vector<Signal>& signals, const std::string& name, int n, double (*value)(int, double),
         double scale = 1.0) {
  for (int i = 0; i < n; ++i)
    signals.push_back({name + std::to_string(i), [=](double t) { return scale * value(i, t); }});
}

TopicSummary summary_of(const std::vector<Signal>& signals, bool named = true) {
  TopicAccumulator accumulator;
  accumulator.topic().named = named;
  for (const Signal& signal : signals) accumulator.add_channel(signal.name, signal.unit);
  for (int k = 0; k < 2000; ++k) {
    const double t = 0.008 * k;
    std::vector<double> values;
    for (const Signal& signal : signals) values.push_back(signal.value(t));
    accumulator.add_time(t);
    accumulator.add_values(values);
  }
  return accumulator.finish();
}

std::map<std::string, GroupMeaning> meanings_of(const std::vector<Signal>& signals, bool named = true) {
  std::map<std::string, GroupMeaning> found;
  for (const GroupMeaning& meaning : find_meanings(summary_of(signals, named)))
    found[meaning.group.name] = meaning;
  return found;
}

TEST(Meaning, IsCertainWhereNamesAndDerivativesAgree) {
  std::vector<Signal> signals;
  add(signals, "actual_q_", 3, angle);
  add(signals, "actual_qd_", 3, rate);
  const auto found = meanings_of(signals);
  ASSERT_EQ(found.size(), 2U);
  const GroupMeaning& q = found.at("actual_q_0..2");
  EXPECT_EQ(q.quantity, Quantity::kPosition);
  EXPECT_EQ(q.unit, "rad");
  EXPECT_EQ(q.sureness, Sureness::kCertain);
  const GroupMeaning& qd = found.at("actual_qd_0..2");
  EXPECT_EQ(qd.quantity, Quantity::kVelocity);
  EXPECT_EQ(qd.unit, "rad/s");
  EXPECT_EQ(qd.sureness, Sureness::kCertain);
}

TEST(Meaning, IsFoundWithoutNames) {
  std::vector<Signal> signals;
  add(signals, "", 3, angle);
  add(signals, "", 3, rate);
  add(signals, "", 3, [](int j, double t) { return std::cos(3.0 * t + j); });
  add(signals, "", 3, [](int j, double t) { return (10.0 + j) * std::cos(3.0 * t + j); });
  for (std::size_t c = 0; c < signals.size(); ++c) signals[c].name = std::to_string(c + 2);
  const auto found = meanings_of(signals, false);
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found.at("2..4").quantity, Quantity::kPosition);
  EXPECT_EQ(found.at("5..7").quantity, Quantity::kVelocity);
  EXPECT_EQ(found.at("8..10").quantity, Quantity::kCurrent);
  EXPECT_EQ(found.at("11..13").quantity, Quantity::kTorque);
  EXPECT_EQ(found.at("11..13").sureness, Sureness::kPossible);
}

TEST(Meaning, OfContradictoryVelocitiesIsDoubtful) {
  struct Case {
    double scale;
    const char* hint;
  };
  for (const Case& c : {Case{180.0 / M_PI, "deg/s"}, Case{-1.0, "sign"}, Case{0.5, "0.5 times"}}) {
    std::vector<Signal> signals;
    add(signals, "q", 3, angle);
    add(signals, "dq", 3, rate, c.scale);
    const auto found = meanings_of(signals);
    const GroupMeaning& dq = found.at("dq0..2");
    EXPECT_EQ(dq.sureness, Sureness::kDoubtful) << c.scale;
    EXPECT_THAT(dq.reasons, testing::Contains(HasSubstr(c.hint))) << c.scale;
  }
}

TEST(Meaning, OfExchangedJointsIsDoubtful) {
  std::vector<Signal> signals;
  add(signals, "q", 3, angle);
  add(signals, "dq", 3, [](int j, double t) { return rate((j + 1) % 3, t); });
  const auto found = meanings_of(signals);
  EXPECT_EQ(found.at("dq0..2").sureness, Sureness::kDoubtful);
  EXPECT_THAT(found.at("dq0..2").reasons, testing::Contains(HasSubstr("order")));
}

TEST(Meaning, OfLargeAnglesIsInDegreesUnlessTheUnitIsStated) {
  std::vector<Signal> signals;
  add(signals, "joint_position_", 2, angle, 180.0 / M_PI);
  add(signals, "joint_velocity_", 2, rate, 180.0 / M_PI);
  auto found = meanings_of(signals);
  EXPECT_EQ(found.at("joint_position_0..1").unit, "deg");
  EXPECT_EQ(found.at("joint_velocity_0..1").unit, "deg/s");
  EXPECT_EQ(found.at("joint_velocity_0..1").sureness, Sureness::kCertain);
  for (Signal& signal : signals) signal.unit = signal.name.find("pos") != std::string::npos ? "radian" : "";
  found = meanings_of(signals);
  EXPECT_EQ(found.at("joint_position_0..1").unit, "rad");
  EXPECT_TRUE(found.at("joint_position_0..1").unit_stated);
}

TEST(Meaning, IsNotInventedForNoise) {
  std::vector<Signal> signals;
  unsigned state = 1;
  for (int i = 0; i < 6; ++i)
    signals.push_back({std::to_string(i + 1), [&state](double) {
                         state = state * 1664525U + 1013904223U;
                         return static_cast<double>(state >> 8);
                       }});
  for (const auto& [name, meaning] : meanings_of(signals, false))
    EXPECT_EQ(meaning.quantity, Quantity::kUnknown) << name;
}

TEST(Words, OfKnownRecordersAreRecognised) {
  struct Case {
    const char* name;
    Quantity quantity;
    Role role = Role::kMeasured;
  };
  for (const Case& c : {
           Case{"actual_q_0", Quantity::kPosition},
           Case{"target_q_5", Quantity::kPosition, Role::kCommand},
           Case{"target_qdd_1", Quantity::kAcceleration, Role::kCommand},
           Case{"target_moment_3", Quantity::kTorque, Role::kCommand},
           Case{"actual_current_2", Quantity::kCurrent},
           Case{"actual_TCP_pose_0", Quantity::kTool},
           Case{"joint_temperatures_0", Quantity::kOther},
           Case{"state.q[0]", Quantity::kPosition},
           Case{"state.q_d[0]", Quantity::kPosition, Role::kCommand},
           Case{"state.dq[6]", Quantity::kVelocity},
           Case{"state.tau_J[0]", Quantity::kTorque},
           Case{"control.tau_J_d[0]", Quantity::kTorque, Role::kCommand},
           Case{"state.dtau_J[0]", Quantity::kOther},
           Case{"joint/elbow/velocity_ratio", Quantity::kOther},
           Case{"q1", Quantity::kPosition},
           Case{"dq1", Quantity::kVelocity},
           Case{"tau1", Quantity::kTorque},
           Case{"joint/elbow/velocity", Quantity::kVelocity},
           Case{"current_position_1", Quantity::kPosition},
           Case{"motorCurrent3", Quantity::kCurrent},
           Case{"robot_mode", Quantity::kUnknown},
       }) {
    EXPECT_EQ(words_of(c.name).quantity, c.quantity) << c.name;
    EXPECT_EQ(words_of(c.name).role, c.role) << c.name;
  }
  EXPECT_EQ(words_of("q1 [deg]").unit, "deg");
  EXPECT_EQ(words_of("tau_3 (Nm)").unit, "N m");
  EXPECT_EQ(words_of("position[0]").unit, "");
}

TEST(Words, OfTheTopicCountWhereTheFieldSaysNothing) {
  const ChannelWords data =
      words_of("/forward_position_controller/commands/data[0]", "/forward_position_controller/commands");
  EXPECT_EQ(data.quantity, Quantity::kPosition);
  EXPECT_EQ(data.role, Role::kCommand);
  const ChannelWords field = words_of("/position_controller/state/velocity[0]", "/position_controller/state");
  EXPECT_EQ(field.quantity, Quantity::kVelocity);
  EXPECT_EQ(field.role, Role::kMeasured);
}

TEST(Groups, PutEveryChannelIntoExactlyOne) {
  const std::vector<std::string> names = {"time2",
                                          "joint/elbow/position",
                                          "joint/wrist_1/position",
                                          "a[10]",
                                          "a[9]",
                                          "force/x",
                                          "force/y",
                                          "hip_pos",
                                          "knee_pos",
                                          "battery",
                                          "joint/elbow/torque"};
  std::vector<Signal> signals;
  for (const std::string& name : names) signals.push_back({name, [](double t) { return t; }});
  std::vector<int> count(names.size(), 0);
  std::map<std::string, std::size_t> size;
  for (const ChannelGroup& group : group_channels(summary_of(signals))) {
    size[group.name] = group.channels.size();
    for (const std::size_t c : group.channels) ++count[c];
  }
  EXPECT_THAT(count, testing::Each(1));
  EXPECT_EQ(size["joint/*/position"], 2U);
  EXPECT_EQ(size["a[9..10]"], 2U);
  EXPECT_EQ(size["force/x..y"], 2U);
  EXPECT_EQ(size["*_pos"], 2U);
  EXPECT_EQ(size["battery"], 1U);
}

}  // namespace log_meaning_test
}  // namespace armtune::internal

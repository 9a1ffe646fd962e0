#include "tuner/identification/log_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/core/support/arms.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace log_file_test {

using test::refused_at;
using testing::HasSubstr;
using testing::StartsWith;

class Logs : public ::testing::Test {
 protected:
  RobotModel arm_ = test::random_arm(2, 5, false);
  test::TemporaryFolder folder_;
  LogColumns columns_{{"t"}, {{"q1"}, {"q2"}}, {}, {{"tau1"}, {"tau2"}}};

  std::vector<LogSample> read(const std::string& text) {
    LogFile log(folder_.write("log.csv", text), columns_);
    std::vector<LogSample> samples;
    while (auto sample = log.next()) samples.push_back(*sample);
    return samples;
  }
  /// Returns the error with which a log of this text is refused. Its file is the log.
  InputError refused(const std::string& text) {
    InputError error = test::input_error([&] { read(text); });
    EXPECT_THAT(error, refused_at({.file = folder_ / "log.csv"}));
    return error;
  }
  /// Returns the error with which a column map of this text is refused. Its file is the map.
  InputError map_refused(const std::string& text) {
    const std::string path = folder_.write("map.yaml", text);
    InputError error = test::input_error([&] { load_log_columns(path, arm_); });
    EXPECT_THAT(error, refused_at({.file = path}));
    return error;
  }
};

TEST_F(Logs, AreReadByColumnNameWhateverElseStandsInThem) {
  const auto samples = read("tau2,t, q1,note,q2,tau1\n4,0.0,1,7,2,3\n8,0.5,5,7,6,7\r\n12,1.0,9,8,10,11\n");
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_EQ(samples[1].time, 0.5);
  EXPECT_EQ(samples[1].q, JointVector(Eigen::Vector2d(5, 6)));
  EXPECT_EQ(samples[2].torque, JointVector(Eigen::Vector2d(11, 12)));
  EXPECT_EQ(samples[0].qd.size(), 0);
}

TEST_F(Logs, AColumnMapGivesNamesAndUnits) {
  const auto joints = joint_names(arm_);
  const std::string path = folder_.write(
      "map.yaml",
      "time: stamp\ntime_scale: 1e-9\nposition: {columns: [a, b], scale: 0.5}\ntorque:\n  columns:\n    " +
          joints[1] + ": second\n    " + joints[0] + ": first\n");
  columns_ = load_log_columns(path, arm_);
  const auto samples = read("stamp,a,b,first,second\n0,2,4,1,2\n1000000000,2,4,3,4\n");
  EXPECT_EQ(samples[1].time, 1.0);
  EXPECT_EQ(samples[1].q, JointVector(Eigen::Vector2d(1, 2)));
  EXPECT_EQ(samples[1].torque, JointVector(Eigen::Vector2d(3, 4)));
  EXPECT_THAT(map_refused("position: {columns: [a]}\ntorque: {columns: [a, b]}\n"),
              refused_at({.line = 1, .key = "position/columns", .value = "1", .limit = "2 entries"}));
}

TEST_F(Logs, WhatAColumnMapLeavesOutIsCalledAsUsual) {
  const auto joints = joint_names(arm_);
  columns_ = load_log_columns(folder_.write("map.yaml", "time_scale: 1e-3\n"), arm_);
  std::string head = "time";
  for (const char* what : {"position", "velocity", "torque"}) {
    for (const std::string& joint : joints) head += ",joint/" + joint + "/" + what;
  }
  const auto samples = read(head + "\n0,1,2,3,4,5,6\n500,1,2,3,4,5,6\n");
  EXPECT_EQ(samples[1].time, 0.5);
  EXPECT_EQ(samples[1].qd, JointVector(Eigen::Vector2d(3, 4)));
  EXPECT_EQ(samples[1].torque, JointVector(Eigen::Vector2d(5, 6)));
  columns_ = load_log_columns(folder_.write("map.yaml", "position: {columns: [a, b]}\n"), arm_);
  EXPECT_TRUE(columns_.velocity.empty()) << "of other columns nothing is known";
  EXPECT_THAT(map_refused("time_scale: -1\n"),
              refused_at({.line = 1, .key = "time_scale", .value = "-1", .limit = "above zero"}));
}

TEST_F(Logs, UnitsCountForAllColumnsBesideTheirScales) {
  columns_ = load_log_columns(
      folder_.write("map.yaml",
                    "units: {time: ms, angle: deg, torque: mN m}\nposition: {columns: [a, b]}\n"
                    "velocity: {columns: [c, d]}\ntorque: {columns: [e, f], scale: 2}\n"),
      arm_);
  const auto samples = read("time,a,b,c,d,e,f\n5000,180,90,360,0,1000,500\n6000,180,90,360,0,1000,500\n");
  EXPECT_DOUBLE_EQ(samples[1].time, 1.0);
  EXPECT_LT((samples[0].q - JointVector(Eigen::Vector2d(M_PI, M_PI / 2.0))).norm(), 1e-15);
  EXPECT_LT((samples[0].qd - JointVector(Eigen::Vector2d(2.0 * M_PI, 0.0))).norm(), 1e-15);
  EXPECT_EQ(samples[0].torque, JointVector(Eigen::Vector2d(2.0, 1.0)));
}

TEST_F(Logs, AByteOrderMarkIsSkippedAndALastRowNeedsNoLineEnd) {
  const auto samples = read("\xEF\xBB\xBFt,q1,q2,tau1,tau2\n0,1,2,3,4\n1,5,6,7,8");
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[1].torque, JointVector(Eigen::Vector2d(7, 8)));
}

TEST_F(Logs, BlankLinesBeforeTheNamesAreSkippedAndCounted) {
  const auto samples = read("\n \r\nt,q1,q2,tau1,tau2\n0,1,2,3,4\n1,5,6,7,8\n");
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[1].torque, JointVector(Eigen::Vector2d(7, 8)));
  EXPECT_THAT(refused("\n\nt,q1,q2,tau1\n"),
              refused_at({.line = 3, .key = "tau2", .limit = "a column 'tau2'"}));
  EXPECT_THAT(
      refused("\nt,q1,q2,tau1,tau2\n0,1,2,3,4\n1,5,6,7,8\n2,5,6,7,8\n3,5,6,7,8\n4,5,6,7,8\n5,5,6,7,8\n"
              "6,5,6,7,8\n7.8,5,6,7,8\n"),
      refused_at({.line = 10, .key = "t", .value = "1.8", .limit = StartsWith("equal steps")}));
  EXPECT_THAT(refused("\n\n"), refused_at({.line = 0, .limit = "a line of column names"}));
}

TEST_F(Logs, AQuotedTextThatGoesOnOverItsLineIsNamed) {
  EXPECT_THAT(refused("t,q1,q2,tau1,tau2,note\n0,1,2,3,4,\"a\nb\"\n1,5,6,7,8,c\n"),
              refused_at({.line = 3, .limit = "texts of one line"}));
}

TEST_F(Logs, TwoColumnsOfOneNameAreRefusedWhereTheyAreNeeded) {
  EXPECT_THAT(refused("t,q1,q2,tau1,tau2,q1\n"),
              refused_at({.line = 1, .key = "q1", .value = "q1", .limit = "one column of each name"}));
  EXPECT_EQ(read("t,q1,q2,tau1,tau2,note,note\n0,1,2,3,4,5,6\n1,1,2,3,4,5,6\n").size(), 2U);
}

TEST_F(Logs, ALineOfMoreThanAMegabyteIsRefused) {
  EXPECT_THAT(refused("t,q1,q2,tau1,tau2\n0,1,2,3,4\n1," + std::string(2'000'000, '7')),
              refused_at({.line = 3, .limit = "lines of at most 1 MB"}));
}

TEST_F(Logs, OnlyRegularFilesAreReadForALogIsReadMoreThanOnce) {
  EXPECT_THAT([&] { LogFile("/dev/zero", columns_); },
              refused_at({.file = "/dev/zero", .line = 0, .limit = "a regular file"}));
  const std::string pipe = folder_ / "pipe.csv";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto read_pipe = [&] { return LogFile(pipe, columns_).path(); };
  EXPECT_THAT(read_pipe, refused_at({.file = pipe, .line = 0, .limit = "a regular file"}));
}

TEST_F(Logs, CellsMayBeSeparatedBySemicolonsTabsOrBlanks) {
  const auto commas = read("t,q1,q2,tau1,tau2\n0,1,-2,3e0,4\n0.5,5,6,7,8\n");
  for (const std::string separator : {";", "\t", " ", "; ", "   "}) {
    std::string text = "t,q1,q2,tau1,tau2\n0,1,-2,3e0,4\n0.5,5,6,7,8\n";
    for (std::size_t at; (at = text.find(',')) != std::string::npos;) text.replace(at, 1, separator);
    const auto samples = read(text);
    ASSERT_EQ(samples.size(), 2U) << separator;
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(samples[k].time, commas[k].time);
      EXPECT_EQ(samples[k].q, commas[k].q);
      EXPECT_EQ(samples[k].torque, commas[k].torque);
    }
  }
  const InputError comma = refused("t;q1;q2;tau1;tau2\n0;1,5;2;3;4\n");
  EXPECT_THAT(comma, refused_at({.line = 2, .key = "q1", .value = "1,5", .limit = "a finite number"}));
  EXPECT_THAT(comma.what(), HasSubstr("write decimal points"));
}

TEST_F(Logs, LinesMayEndInAnyWayAndEmptyOnesMayFollowTheLast) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    for (const std::string& after : {std::string(), end, end + end, end + end + " " + end}) {
      const auto samples = read("t,q1,q2,tau1,tau2" + end + "0,1,2,3,4" + end + "1,5,6,7,8" + after);
      ASSERT_EQ(samples.size(), 2U);
      EXPECT_EQ(samples[1].torque, JointVector(Eigen::Vector2d(7, 8)));
    }
  }
}

TEST_F(Logs, ASeparatorInAQuotedCellBelongsToTheCell) {
  const auto samples = read("\"t\",note,q1,q2,tau1,tau2\n0,\"a, b\",1,2,3,4\n1,\"c,,d\",5,6,7,8\n");
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[1].q, JointVector(Eigen::Vector2d(5, 6)));
}

TEST_F(Logs, WithoutALineOfNamesColumnsAreCalledByTheirNumbers) {
  const InputError unnamed = refused("0,1,2,3,4\n1,5,6,7,8\n");
  EXPECT_THAT(unnamed, refused_at({.line = 1, .key = "t", .limit = "a column 't'"}));
  EXPECT_THAT(unnamed.what(), HasSubstr("call the 5 columns \"1\""));
  columns_.time.name = "1";
  columns_.position = {{"2"}, {"3"}};
  columns_.torque = {{"4"}, {"5"}};
  const auto samples = read("0,1,2,3,4\n1,5,6,7,8\n");
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].q, JointVector(Eigen::Vector2d(1, 2)));
  EXPECT_EQ(samples[1].torque, JointVector(Eigen::Vector2d(7, 8)));
}

TEST_F(Logs, UnixTimeStampsKeepTheirStepsInSecondsAndNanoseconds) {
  const auto seconds = read("t,q1,q2,tau1,tau2\n1732600000.000,1,2,3,4\n1732600000.002,1,2,3,4\n");
  EXPECT_EQ(seconds[0].time, 0.0);
  EXPECT_NEAR(seconds[1].time, 0.002, 1e-6);
  columns_.time.scale = 1e-9;
  const auto nanoseconds =
      read("t,q1,q2,tau1,tau2\n1732600000000000000,1,2,3,4\n1732600000002000000,1,2,3,4\n");
  EXPECT_NEAR(nanoseconds[1].time, 0.002, 1e-6);
}

TEST_F(Logs, AScaleIsOneNumberOrOneForEachJoint) {
  const auto joints = joint_names(arm_);
  for (const std::string& scale :
       {std::string("[10, 0.5]"), "{" + joints[1] + ": 0.5, " + joints[0] + ": 10}"}) {
    columns_ = load_log_columns(
        folder_.write("map.yaml",
                      "time: t\nposition: {columns: [q1, q2]}\ntorque: {columns: [tau1, tau2], scale: " +
                          scale + "}\n"),
        arm_);
    EXPECT_EQ(read("t,q1,q2,tau1,tau2\n0,1,2,3,4\n1,1,2,3,4\n")[0].torque,
              JointVector(Eigen::Vector2d(30, 2)));
  }
  const auto scale_refused = [this](const std::string& scale) {
    return map_refused("position: {columns: [a, b]}\ntorque: {columns: [a, b], scale: " + scale + "}\n");
  };
  const std::string key = "torque/scale";
  EXPECT_THAT(scale_refused("[1]"), refused_at({.line = 2, .key = key, .value = "1", .limit = "2 entries"}));
  EXPECT_THAT(scale_refused("[1, 2, 3]"),
              refused_at({.line = 2, .key = key, .value = "3", .limit = "2 entries"}));
  EXPECT_THAT(scale_refused("{nobody: 1}"),
              refused_at({.line = 2, .key = key, .limit = "the key '" + joints[0] + "'"}));
  EXPECT_THAT(scale_refused("0"), refused_at({.line = 2, .key = key, .value = "0", .limit = "other than 0"}));
  EXPECT_THAT(scale_refused("[1, 0]"),
              refused_at({.line = 2, .key = key + "/1", .value = "0", .limit = "other than 0"}));
  EXPECT_THAT(scale_refused("fast"), refused_at({.line = 2, .key = key, .value = "fast"}));
}

TEST_F(Logs, WhatIsNoWholeLogIsRefusedWithItsPlace) {
  const std::string head = "t,q1,q2,tau1,tau2\n";
  EXPECT_THAT(refused(""), refused_at({.line = 0, .limit = "a line of column names"}));
  const InputError missing = refused("t,q1,q2,tau1\n");
  EXPECT_THAT(missing, refused_at({.line = 1, .key = "tau2", .limit = "a column 'tau2'"}));
  EXPECT_THAT(missing.what(), HasSubstr("--columns"));
  EXPECT_THAT(refused(head + "0,1,2,3,4\n"),
              refused_at({.line = 0, .value = "1", .limit = "at least 2 rows"}));
  EXPECT_THAT(refused(head + "0,1,2,3,4\n1,1,2,3\n"),
              refused_at({.line = 3, .value = "4", .limit = "5 cells"}));
  for (const std::string cell : {"nan", "2x"}) {
    EXPECT_THAT(refused(head + "0,1,2,3,4\n1,1," + cell + ",3,4\n"),
                refused_at({.line = 3, .key = "q2", .value = cell, .limit = "a finite number"}));
  }
  EXPECT_THAT(refused(head + "0,1,2,3,4\n1,1,2,1e200,4\n"),
              refused_at({.line = 3, .key = "tau1", .value = "1e200", .limit = "at most 1e+09 in size"}));
  EXPECT_THAT(
      refused(head + "0,1,2,3,4\n0,1,2,3,4\n"),
      refused_at({.line = 3, .key = "t", .value = "0", .limit = "above the value of the row before"}));
  EXPECT_THAT(refused(head + "0,1,2,3,4\n1,1,2,3,4\n2,1,2,3,4\n4,1,2,3,4\n5,1,2,3,4\n"),
              refused_at({.line = 5, .key = "t", .value = "2", .limit = StartsWith("equal steps: 1.25 s")}));
  EXPECT_THAT(refused(head + "0,1,2,3,4\n1,1,2,3,4\n\n2,1,2,3,4\n"),
              refused_at({.line = 4, .limit = "a row of numbers"}));
}

/// A log whose k-th row is at the time that `when` gives.
template <typename When>
std::string log_at(long rows, When when) {
  std::string text = "t,q1,q2,tau1,tau2\n";
  for (long k = 0; k < rows; ++k) text += fmt::format("{:.9f},1,2,3,4\n", when(k));
  return text;
}

TEST_F(Logs, ThePeriodIsTheMeanOfJitteringSteps) {
  const auto when = [](long k) { return 0.002 * static_cast<double>(k) + (k % 3 == 1 ? 0.0003 : 0.0); };
  const LogFile log(folder_.write("log.csv", log_at(2000, when)), columns_);
  EXPECT_NEAR(log.period(), 0.002, 1e-3 * 0.002);  // that of the first two rows is 15 % longer
  EXPECT_EQ(read(log_at(2000, when)).size(), 2000U);
}

TEST_F(Logs, AMissingSampleOrAnotherRateIsFoundFarIntoALog) {
  EXPECT_THAT(refused(log_at(3000, [](long k) { return 0.002 * static_cast<double>(k < 2500 ? k : k + 1); })),
              refused_at({.line = 2502, .key = "t", .value = "0.004", .limit = StartsWith("equal steps")}));
  const auto another_rate =
      refused_at({.line = testing::Gt(1L), .key = "t", .limit = StartsWith("one rate")});
  EXPECT_THAT(refused(log_at(3000,
                             [](long k) {
                               return 0.002 * static_cast<double>(k) * (1.0 + 1e-5 * static_cast<double>(k));
                             })),
              another_rate);
  // Within the first stretch and at a log's end, too.
  const auto slower = [](long k) {
    return 0.01 * static_cast<double>(k) * (1.0 + 1e-3 * static_cast<double>(k));
  };
  EXPECT_THAT(refused(log_at(300, slower)), another_rate);
  EXPECT_THAT(refused(log_at(900,
                             [](long k) {
                               return 0.002 * static_cast<double>(k < 600 ? k : 600) +
                                      0.0024 * static_cast<double>(k < 600 ? 0 : k - 600);
                             })),
              another_rate);
}

TEST_F(Logs, ItsOwnVelocityColumnsMayBeMissingButNamedOnesMayNot) {
  columns_.velocity = {{"v1"}, {"v2"}};
  columns_.velocity_optional = true;
  EXPECT_EQ(read("t,q1,q2,tau1,tau2\n0,1,2,3,4\n1,1,2,3,4\n").front().qd.size(), 0);
  EXPECT_EQ(read("t,q1,q2,tau1,tau2,v2,v1\n0,1,2,3,4,5,6\n1,1,2,3,4,5,6\n").front().qd,
            JointVector(Eigen::Vector2d(6, 5)));
  EXPECT_THAT(refused("t,q1,q2,tau1,tau2,v1\n0,1,2,3,4,5\n1,1,2,3,4,5\n"),
              refused_at({.line = 1, .key = "v2"}))
      << "half of them";
  columns_.velocity_optional = false;
  EXPECT_THAT(refused("t,q1,q2,tau1,tau2\n0,1,2,3,4\n1,1,2,3,4\n"), refused_at({.line = 1, .key = "v1"}));
}

}  // namespace log_file_test
}  // namespace armtune::internal

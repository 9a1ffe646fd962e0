#include "tuner/identification/log_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/core/support/arms.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace log_file_test {

using testing::AllOf;
using testing::HasSubstr;

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
  std::string refused(const std::string& text) {
    return test::refusal([&] { read(text); });
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
  EXPECT_THAT(test::refusal([&] {
                load_log_columns(
                    folder_.write("m.yaml", "position: {columns: [a]}\ntorque: {columns: [a, b]}\n"), arm_);
              }),
              AllOf(HasSubstr("m.yaml:1:"), HasSubstr("1 entries"), HasSubstr("2 joints")));
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
  EXPECT_THAT(test::refusal([&] { load_log_columns(folder_.write("map.yaml", "time_scale: -1\n"), arm_); }),
              AllOf(HasSubstr("map.yaml:1:"), HasSubstr("negative")));
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
  EXPECT_THAT(refused("\n\nt,q1,q2,tau1\n"), HasSubstr("log.csv:3: there is no column 'tau2'"));
  EXPECT_THAT(
      refused("\nt,q1,q2,tau1,tau2\n0,1,2,3,4\n1,5,6,7,8\n2,5,6,7,8\n3,5,6,7,8\n4,5,6,7,8\n5,5,6,7,8\n"
              "6,5,6,7,8\n7.8,5,6,7,8\n"),
      HasSubstr("log.csv:10: a step of"));
  EXPECT_THAT(refused("\n\n"), HasSubstr("is empty"));
}

TEST_F(Logs, AQuotedTextThatGoesOnOverItsLineIsNamed) {
  EXPECT_THAT(refused("t,q1,q2,tau1,tau2,note\n0,1,2,3,4,\"a\nb\"\n1,5,6,7,8,c\n"),
              AllOf(HasSubstr("log.csv:3:"), HasSubstr("spans several lines")));
}

TEST_F(Logs, TwoColumnsOfOneNameAreRefusedWhereTheyAreNeeded) {
  EXPECT_THAT(refused("t,q1,q2,tau1,tau2,q1\n"), HasSubstr("log.csv:1: two columns are called 'q1'"));
  EXPECT_EQ(read("t,q1,q2,tau1,tau2,note,note\n0,1,2,3,4,5,6\n1,1,2,3,4,5,6\n").size(), 2U);
}

TEST_F(Logs, ALineOfMoreThanAMegabyteIsRefused) {
  EXPECT_THAT(refused("t,q1,q2,tau1,tau2\n0,1,2,3,4\n1," + std::string(2'000'000, '7')),
              AllOf(HasSubstr("log.csv:3:"), HasSubstr("1 MB")));
}

TEST_F(Logs, OnlyRegularFilesAreReadForALogIsReadMoreThanOnce) {
  EXPECT_THAT(test::refusal([&] { LogFile("/dev/zero", columns_); }),
              AllOf(HasSubstr("/dev/zero"), HasSubstr("not a regular file")));
  const std::string pipe = folder_ / "pipe.csv";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(test::refusal([&] { LogFile(pipe, columns_); }), HasSubstr("pipe.csv"));
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
  EXPECT_THAT(refused("t;q1;q2;tau1;tau2\n0;1,5;2;3;4\n"),
              AllOf(HasSubstr("1,5"), HasSubstr("decimal points")));
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
  EXPECT_THAT(refused("0,1,2,3,4\n1,5,6,7,8\n"), AllOf(HasSubstr("'t'"), HasSubstr("\"1\"")));
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
  for (const std::string scale : {"[1]", "[1, 2, 3]", "{nobody: 1}", "0", "[1, 0]", "fast"}) {
    EXPECT_THAT(
        test::refusal([&] {
          load_log_columns(
              folder_.write("map.yaml",
                            "position: {columns: [a, b]}\ntorque: {columns: [a, b], scale: " + scale + "}\n"),
              arm_);
        }),
        HasSubstr("map.yaml:2:"))
        << scale;
  }
}

TEST_F(Logs, WhatIsNoWholeLogIsRefusedWithItsPlace) {
  const std::string head = "t,q1,q2,tau1,tau2\n";
  EXPECT_THAT(refused(""), HasSubstr("empty"));
  EXPECT_THAT(refused("t,q1,q2,tau1\n"),
              AllOf(HasSubstr("log.csv:1:"), HasSubstr("'tau2'"), HasSubstr("--columns")));
  EXPECT_THAT(refused(head + "0,1,2,3,4\n"), HasSubstr("1 rows of data"));
  EXPECT_THAT(refused(head + "0,1,2,3,4\n1,1,2,3\n"), AllOf(HasSubstr("log.csv:3:"), HasSubstr("4 cells")));
  EXPECT_THAT(refused(head + "0,1,2,3,4\n1,1,nan,3,4\n"), AllOf(HasSubstr("log.csv:3:"), HasSubstr("'q2'")));
  EXPECT_THAT(refused(head + "0,1,2,3,4\n1,1,2x,3,4\n"),
              AllOf(HasSubstr("log.csv:3:"), HasSubstr("'q2'"), HasSubstr("2x")));
  EXPECT_THAT(
      refused(head + "0,1,2,3,4\n1,1,2,1e200,4\n"),
      AllOf(HasSubstr("log.csv:3:"), HasSubstr("'tau1'"), HasSubstr("1e+200"), HasSubstr("exceeds 1e+09")));
  EXPECT_THAT(refused(head + "0,1,2,3,4\n0,1,2,3,4\n"), AllOf(HasSubstr("log.csv:3:"), HasSubstr("'t'")));
  EXPECT_THAT(refused(head + "0,1,2,3,4\n1,1,2,3,4\n2,1,2,3,4\n4,1,2,3,4\n5,1,2,3,4\n"),
              AllOf(HasSubstr("log.csv:5:"), HasSubstr("step")));
  EXPECT_THAT(refused(head + "0,1,2,3,4\n1,1,2,3,4\n\n2,1,2,3,4\n"), HasSubstr("empty line"));
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
              AllOf(HasSubstr("log.csv:2502:"), HasSubstr("step")));
  EXPECT_THAT(refused(log_at(3000,
                             [](long k) {
                               return 0.002 * static_cast<double>(k) * (1.0 + 1e-5 * static_cast<double>(k));
                             })),
              HasSubstr("one rate"));
  // Within the first stretch and at a log's end, too.
  const auto slower = [](long k) {
    return 0.01 * static_cast<double>(k) * (1.0 + 1e-3 * static_cast<double>(k));
  };
  EXPECT_THAT(refused(log_at(300, slower)), HasSubstr("one rate"));
  EXPECT_THAT(refused(log_at(900,
                             [](long k) {
                               return 0.002 * static_cast<double>(k < 600 ? k : 600) +
                                      0.0024 * static_cast<double>(k < 600 ? 0 : k - 600);
                             })),
              HasSubstr("one rate"));
}

TEST_F(Logs, ItsOwnVelocityColumnsMayBeMissingButNamedOnesMayNot) {
  columns_.velocity = {{"v1"}, {"v2"}};
  columns_.velocity_optional = true;
  EXPECT_EQ(read("t,q1,q2,tau1,tau2\n0,1,2,3,4\n1,1,2,3,4\n").front().qd.size(), 0);
  EXPECT_EQ(read("t,q1,q2,tau1,tau2,v2,v1\n0,1,2,3,4,5,6\n1,1,2,3,4,5,6\n").front().qd,
            JointVector(Eigen::Vector2d(6, 5)));
  EXPECT_THAT(refused("t,q1,q2,tau1,tau2,v1\n0,1,2,3,4,5\n1,1,2,3,4,5\n"), HasSubstr("'v2'"))
      << "half of them";
  columns_.velocity_optional = false;
  EXPECT_THAT(refused("t,q1,q2,tau1,tau2\n0,1,2,3,4\n1,1,2,3,4\n"), HasSubstr("'v1'"));
}

}  // namespace log_file_test
}  // namespace armtune::internal

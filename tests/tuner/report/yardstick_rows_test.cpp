#include "tuner/report/yardstick_rows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "armtune/error.hpp"
#include "tests/tuner/report/support/decode.hpp"
#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {
namespace yardstick_rows_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kHeader =
    "scenario,event,time,reached,limit,ratio,unit,outcome,held_back_by,clearance,status\n";

CsvTable table(const std::string& rows) {
  return CsvTable::parse(kHeader + rows, "yardstick.csv");
}

std::string words(const std::string& row) {
  return yardstick_of({table(row + "\n")}).front().words;
}

TEST(YardstickRows, SayWhatWasReachedAndWhatTheLimitsAllow) {
  EXPECT_EQ(words("a,switch,8,1.4800001,1.21,1.223,s,reached,velocity of wrist_2_joint,,solved"),
            "reacquired in 1.48 s; the joint limits allow 1.21 s (velocity of wrist_2_joint)");
  EXPECT_EQ(words("a,return,8,2.5,1.25,2,s,reached,nothing,0.3,solved"),
            "back on the path in 2.5 s; the joint limits allow 1.25 s (nothing)");
  EXPECT_EQ(words("a,lap,8,0.012,0.0004,30,rad,reached,nothing,,solved"),
            "a gaze error of 12 mrad rms; the joint limits allow 0.4 mrad (nothing)");
}

TEST(YardstickRows, SayPlainlyWhatThereIsNot) {
  EXPECT_EQ(words("a,switch,8,0,0,,s,already there,,,there at once"), "the next target is in view already");
  EXPECT_EQ(words("a,switch,8,1.8,0,,s,reached,,,there at once"),
            "reacquired in 1.8 s; the gaze is on target from the beginning");
  EXPECT_EQ(words("a,switch,8,,1.21,,s,not before the next switch,nothing,,solved"),
            "not reacquired: not before the next switch; the joint limits allow 1.21 s (nothing)");
  EXPECT_EQ(words("a,switch,8,,9,,s,not before the next switch,nothing,,past the next switch"),
            "not reacquired: not before the next switch; the joint limits allow 9 s, past the next switch "
            "(nothing)");
  EXPECT_EQ(words("a,return,8,2,,,s,reached,torque of elbow_joint,,infeasible"),
            "back on the path in 2 s; no motion within the limits achieves this (torque of elbow_joint)");
  EXPECT_THAT(words("a,return,8,2,,,s,reached,,,not solved"), HasSubstr("unknown: not solved"));
  EXPECT_THAT(words("a,return,8,2,1,2,s,reached,nothing,,solved without obstacles"),
              HasSubstr("allow 1 s, solved without obstacles"));
}

TEST(YardstickRows, OfEverySetWithItsFile) {
  const auto rows = yardstick_of({table("a,switch,8,2,1,2,s,reached,nothing,,solved\n"), std::nullopt,
                                  table("a,switch,8,1.5,1,1.5,s,reached,nothing,,solved\n")});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].set, 0U);
  EXPECT_EQ(rows[1].set, 2U);
  EXPECT_EQ(rows[1].ratio, 1.5);
  EXPECT_THROW(yardstick_of({CsvTable::parse("scenario,event\na,switch\n", "yardstick.csv")}), InputError);
}

TEST(YardstickSentence, IsOfTheWorstOfEachKindInOneSet) {
  const auto rows = yardstick_of({table("a,switch,8,9,1,9,s,reached,nothing,,solved\n"),
                                  table("a,switch,8,1.2,1,1.2,s,reached,nothing,,solved\n"
                                        "b,switch,16,1.48,1.21,1.223,s,reached,nothing,,solved\n"
                                        "b,switch,24,,1,,s,not before the next switch,nothing,,solved\n"
                                        "b,lap,10,0.012,0.0004,30,rad,reached,nothing,,solved\n")});
  EXPECT_THAT(yardstick_sentence(rows, 1),
              AllOf(HasSubstr("up to 1.22 times the best (1.48 s instead of 1.21 s, in b at 16 s)"),
                    HasSubstr("30 times the best (12 mrad instead of 0.4 mrad, in b at 10 s)"),
                    Not(HasSubstr("return"))));
  EXPECT_THAT(yardstick_sentence(rows, 0), HasSubstr("9 times"));
  EXPECT_EQ(yardstick_sentence(rows, 2), "");
  EXPECT_EQ(yardstick_sentence({}, 0), "");
}

TEST(YardstickJson, HasNullWhereThereIsNoValue) {
  ReportData data;
  data.yardstick = yardstick_of({table("a,switch,8,,1.5,,s,not before the next switch,nothing,,solved\n")});
  const auto page = test::parsed(report_json(data));
  const auto& node = test::at(page, "yardstick/0");
  EXPECT_EQ(test::at(node, "reached").kind(), yaml::Node::Kind::kNull);
  EXPECT_EQ(test::at(node, "ratio").kind(), yaml::Node::Kind::kNull);
  EXPECT_EQ(test::at(node, "limit").as_number(), 1.5);
  EXPECT_EQ(test::at(node, "event").as_string(), "switch");
  EXPECT_THAT(test::at(node, "words").as_string(), StartsWith("not reacquired"));
}

}  // namespace yardstick_rows_test
}  // namespace armtune::internal::report

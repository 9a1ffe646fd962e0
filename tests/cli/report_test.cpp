// report.html of real runs of every kind, and `armtune report`.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/cli/support/program.hpp"
#include "tests/tuner/report/support/decode.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/report/report.hpp"

namespace armtune::internal {
namespace report_test {

namespace fs = std::filesystem;
using test::at;
using test::Finished;
using test::Program;
using test::run_program;
using test::ShortStudy;
using testing::HasSubstr;

class Report : public testing::Test {
 protected:
  void SetUp() override {
    if (!report::available()) GTEST_SKIP() << "built without the page";
  }

  /// The data of the run's page; the page that `armtune report` makes of the folder is the same to the byte.
  static yaml::Node data(const std::string& folder) {
    const std::string page = test::read_text(folder + "/report.html");
    EXPECT_FALSE(page.empty()) << folder;
    EXPECT_LE(page.size(), 6'000'000U);
    const Finished again = run_program({"report", folder});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("report.html"));
    EXPECT_EQ(test::read_text(folder + "/report.html"), page);
    return test::parsed(test::data_of(page));
  }

  /// Every scenario has a replay of every set.
  static void expect_replays(const yaml::Node& data, std::size_t scenarios, std::size_t sets) {
    ASSERT_EQ(at(data, "scenarios").items().size(), scenarios);
    ASSERT_EQ(at(data, "sets").items().size(), sets);
    for (const yaml::Node& scenario : at(data, "scenarios").items()) {
      ASSERT_EQ(at(scenario, "runs").items().size(), sets);
      for (const yaml::Node& run : at(scenario, "runs").items()) {
        EXPECT_EQ(at(run, "status").as_string(), "completed");
        EXPECT_EQ(at(run, "replay/n").as_integer(), 200) << "8 s at 25 a second";
      }
    }
    EXPECT_EQ(at(data, "robots/0/joints").items().size(), 6U);
    EXPECT_FALSE(at(data, "verdict/sentence").as_string().empty());
    EXPECT_THAT(at(data, "provenance/command").as_string(),
                testing::AllOf(testing::StartsWith("armtune "), HasSubstr(" --out ")));
  }

  const ShortStudy files_;
};

TEST_F(Report, OfASimulationAndAComparison) {
  ASSERT_EQ(run_program({"simulate", files_ / "short.yaml", files_ / "short_realistic.yaml", "--gains",
                         files_ / "gains.yaml", "--out", files_ / "run"})
                .exit_code,
            0);
  const auto simulated = data(files_ / "run");
  EXPECT_EQ(at(simulated, "kind").as_string(), "simulate");
  EXPECT_EQ(at(simulated, "sets/0").as_string(), "gains");
  expect_replays(simulated, 2, 1);
  // A recording that was lost, and one that ends at a row before its time, are said.
  const std::string recording = files_ / "run/rollout_short.csv";
  const std::string whole = test::read_text(recording);
  std::ofstream(recording, std::ios::binary) << whole.substr(0, whole.find('\n', whole.size() / 2) + 1);
  const Finished cut = run_program({"report", files_ / "run"});
  EXPECT_EQ(cut.exit_code, 0);
  EXPECT_THAT(cut.err,
              testing::AllOf(HasSubstr("rollout_short.csv"), HasSubstr("of 8 s"), HasSubstr("ends there")));
  std::filesystem::remove(recording);
  EXPECT_THAT(run_program({"report", files_ / "run"}).err,
              testing::AllOf(HasSubstr("rollout_short.csv"), HasSubstr("is missing")));
  std::ofstream(recording, std::ios::binary) << whole;
  ASSERT_EQ(run_program({"compare", "published", files_ / "run", "--scenarios", files_ / "short.yaml",
                         "--out", files_ / "compared"})
                .exit_code,
            3)
      << "the published gains need longer than this to track";
  const auto compared = data(files_ / "compared");
  EXPECT_EQ(at(compared, "kind").as_string(), "compare");
  EXPECT_EQ(at(compared, "sets/1").as_string(), "run");
  EXPECT_EQ(at(compared, "tables/0/status/0").as_string(), "no_samples");
  EXPECT_EQ(at(compared, "tables/0/status/1").as_string(), "completed");
}

TEST_F(Report, OfATunedRunHasWhatTheSearchLeaves) {
  ASSERT_EQ(run_program({"tune", files_.path(), "--out", files_ / "run", "--max-evaluations", "6"}).exit_code,
            0);
  const auto tuned = data(files_ / "run");
  EXPECT_EQ(at(tuned, "kind").as_string(), "tune");
  expect_replays(tuned, 2, 2);
  EXPECT_EQ(at(tuned, "evaluations/objective").items().size(), at(tuned, "evaluations/of").items().size());
  EXPECT_EQ(at(tuned, "gains").items().size(), 2U);
  const long chosen = at(tuned, "evaluations/chosen").as_integer();
  EXPECT_TRUE(at(tuned, "evaluations/feasible").items().at(static_cast<std::size_t>(chosen)).as_boolean());
  for (const char* part : {"sensitivity", "margins", "front"}) EXPECT_NE(tuned.find(part), nullptr) << part;
}

TEST_F(Report, OfAFrontShowsTheStartAndOneOfItsPoints) {
  ASSERT_EQ(run_program({"pareto", files_.path(), "--out", files_ / "front", "--max-evaluations", "12",
                         "--levels", "2"})
                .exit_code,
            0);
  const auto front = data(files_ / "front");
  EXPECT_EQ(at(front, "kind").as_string(), "pareto");
  expect_replays(front, 2, 2);
  std::vector<std::string> roles;
  for (const yaml::Node& point : at(front, "front/points").items())
    roles.push_back(at(point, "role").as_string());
  EXPECT_EQ(std::count(roles.begin(), roles.end(), "start"), 1);
  EXPECT_EQ(std::count(roles.begin(), roles.end(), "shown"), 1);
  EXPECT_EQ(std::count(roles.begin(), roles.end(), "chosen"), 0) << "nobody chose one";
}

TEST_F(Report, OfManyArmsShowsTheirSpreadAndTheNominalArm) {
  ASSERT_EQ(run_program({"robustness", files_ / "gains.yaml", "--scenarios", files_ / "short.yaml",
                         "--samples", "4", "--out", files_ / "arms"})
                .exit_code,
            0);
  const auto arms = data(files_ / "arms");
  EXPECT_EQ(at(arms, "kind").as_string(), "robustness");
  expect_replays(arms, 1, 1);
  EXPECT_EQ(at(arms, "robustness/samples").as_integer(), 4);
  for (const yaml::Node& histogram : at(arms, "robustness/histograms").items()) {
    if (at(histogram, "metric").as_string() == "joint_velocity/max_ratio") {
      EXPECT_EQ(at(histogram, "limit").as_number(), 1.0);
    }
    EXPECT_NE(at(histogram, "nominal").kind(), yaml::Node::Kind::kNull);
  }
}

TEST_F(Report, ThatCannotBeWrittenDoesNotMakeTheRunFail) {
  Program running(
      {"simulate", files_ / "short.yaml", "--gains", files_ / "gains.yaml", "--out", files_ / "run"},
      files_ / "");
  // The program makes its folder, looks whether it is empty, then simulates; a folder where the page is to go
  // is in its way.
  for (int i = 0; i < 6000 && !fs::exists(files_ / "run"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  fs::create_directory(files_ / "run/report.html");
  const Finished finished = running.wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.err, testing::AllOf(HasSubstr("the run is finished"), HasSubstr("report.html")));
  EXPECT_TRUE(fs::exists(files_ / "run/run.json"));
  EXPECT_THAT(finished.out, testing::AllOf(HasSubstr("scene.json"), testing::Not(HasSubstr("report.html"))));
}

TEST_F(Report, GoesWhereItIsToldAndRefusesOtherFolders) {
  ASSERT_EQ(run_program({"simulate", files_ / "short.yaml", "--gains", files_ / "gains.yaml", "--out",
                         files_ / "run"})
                .exit_code,
            0);
  const Finished elsewhere = run_program({"report", files_ / "run", "--out", files_ / "mine.html"});
  EXPECT_EQ(elsewhere.exit_code, 0);
  EXPECT_EQ(test::read_text(files_ / "mine.html"), test::read_text(files_ / "run/report.html"));
  for (const std::string& folder : {files_ / "", files_ / "missing"}) {
    const Finished refused = run_program({"report", folder});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(folder));
  }
}

TEST(ReportPage, WhereItIsNotBuiltInSaysHowToGetIt) {
  if (report::available()) GTEST_SKIP() << "built with the page";
  const ShortStudy files;
  const Finished run = run_program(
      {"simulate", files / "short.yaml", "--gains", files / "gains.yaml", "--out", files / "run"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_FALSE(fs::exists(files / "run/report.html"));
  const Finished refused = run_program({"report", files / "run"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, testing::AllOf(HasSubstr("node"), HasSubstr("ARMTUNE_REPORT")));
}

}  // namespace report_test
}  // namespace armtune::internal

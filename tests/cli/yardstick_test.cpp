// `armtune yardstick` and --yardstick as a person runs them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include "tests/cli/support/program.hpp"
#include "tests/cli/support/refused_command.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/report/support/decode.hpp"
#include "tests/tuner/run/support/records.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/report/report.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {
namespace yardstick_test {

namespace fs = std::filesystem;
using test::Csv;
using test::Finished;
using test::read_text;
using test::refused_at;
using test::refused_command;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Quick gains and a scenario of 6 s whose targets switch at 4 s.
class YardstickProgram : public testing::Test {
 protected:
  Finished simulate(const std::string& out, std::vector<std::string> more = {}) const {
    std::vector<std::string> args = {"simulate", scenario_,   "--gains", files_ / "gains.yaml",
                                     "--out",    files_ / out};
    args.insert(args.end(), more.begin(), more.end());
    return run_program(args);
  }

  const test::ShortStudy files_;
  const std::string scenario_ =
      files_.write("quick_switch.yaml", "base: target_switch\nduration: 6\nswitch_every: 4\n");
};

TEST_F(YardstickProgram, HoldsARunsEventsAgainstTheirLimits) {
  ASSERT_EQ(simulate("run").exit_code, 0);
  const std::string columns = read_text(files_ / "run/columns.csv");
  const Finished held = run_program({"yardstick", files_ / "run", "--knots", "60"});
  ASSERT_EQ(held.exit_code, 0) << held.err;
  EXPECT_EQ(held.err, "");
  EXPECT_THAT(held.out, AllOf(HasSubstr("quick_switch:"), HasSubstr("switch at 4 s: "),
                              HasSubstr("the joint limits allow "), HasSubstr("yardstick.csv")));
  const Csv csv = test::read_csv(files_ / "run/yardstick.csv");
  ASSERT_EQ(csv.rows.size(), 2U) << "the first return and a switch";
  EXPECT_EQ(csv.at(0, "event"), "return");
  EXPECT_EQ(csv.at(1, "event"), "switch");
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(csv.at(r, "status"), "solved");
    EXPECT_GT(std::stod(csv.at(r, "limit")), 0.0);
    if (csv.at(r, "ratio").empty()) continue;  // not reached
    EXPECT_NEAR(std::stod(csv.at(r, "ratio")),
                std::stod(csv.at(r, "reached")) / std::stod(csv.at(r, "limit")), 1e-12);
  }
  const RunRecord record = parse_run_record(read_text(files_ / "run/yardstick.json"), "yardstick.json");
  EXPECT_EQ(record.kind, RunKind::kYardstick);
  ASSERT_TRUE(record.yardstick);
  EXPECT_EQ(record.yardstick->events, 2);
  EXPECT_EQ(record.yardstick->knots, 60);
  for (const char* input : {"run/rollout_quick_switch.csv", "run/gains.yaml"})
    EXPECT_NE(test::input_in(record, files_ / input).hash, "");
  const std::string extended = read_text(files_ / "run/columns.csv");
  EXPECT_THAT(extended, testing::StartsWith(columns));
  EXPECT_THAT(extended, HasSubstr("\nyardstick.csv,limit,"));
  // Again: the same, and its columns stand once.
  ASSERT_EQ(run_program({"yardstick", files_ / "run", "--knots", "60"}).exit_code, 0);
  EXPECT_EQ(read_text(files_ / "run/columns.csv"), extended);
  if (!report::available()) return;
  const auto data = test::parsed(test::data_of(read_text(files_ / "run/report.html")));
  EXPECT_EQ(test::at(data, "yardstick").items().size(), 2U);
  EXPECT_EQ(test::at(data, "yardstick/1/event").as_string(), "switch");
}

TEST_F(YardstickProgram, TellsOfTheRecordingsThatItRead) {
  ASSERT_EQ(simulate("run").exit_code, 0);
  const std::string recording = files_ / "run/rollout_quick_switch.csv";
  const std::string before = hash_of_file(recording);
  const std::string told = files_ / "told.txt";
  test::Program program({"yardstick", files_ / "run", "--knots", "100"}, files_ / "",
                        {"/bin/sh", "-c", "exec \"$@\" > " + told, "sh"});
  while (program.running() && (!fs::exists(told) || read_text(told).empty()))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  files_.write("run/rollout_quick_switch.csv", read_text(recording) + "edited\n");
  ASSERT_TRUE(program.running()) << "another event is planned for";
  const Finished held = program.wait();
  ASSERT_EQ(held.exit_code, 0) << held.err;
  const RunRecord run = parse_run_record(read_text(files_ / "run/yardstick.json"), "yardstick.json");
  EXPECT_EQ(test::input_in(run, recording).hash, before);
}

TEST_F(YardstickProgram, WritesElsewhereAndLeavesTheRunAsItIs) {
  ASSERT_EQ(simulate("run").exit_code, 0);
  const std::string columns = read_text(files_ / "run/columns.csv");
  const Finished held =
      run_program({"yardstick", files_ / "run", "--knots", "40", "--out", files_ / "mine.csv"});
  ASSERT_EQ(held.exit_code, 0) << held.err;
  EXPECT_TRUE(fs::exists(files_ / "mine.csv"));
  EXPECT_TRUE(fs::exists(files_ / "mine.json"));
  EXPECT_FALSE(fs::exists(files_ / "run/yardstick.csv"));
  EXPECT_EQ(read_text(files_ / "run/columns.csv"), columns);
  EXPECT_THAT(refused_command({"yardstick", files_ / "run", "--out", files_ / "mine.csv"}),
              refused_at({.file = files_ / "mine.csv"}));
}

TEST_F(YardstickProgram, ReadsTheRunsOwnScenariosAndSaysWhatIsWrongWithThem) {
  ASSERT_EQ(simulate("run").exit_code, 0);
  const auto refused = [&](std::vector<std::string> args) {
    args.insert(args.begin(), "yardstick");
    return refused_command(args);
  };
  files_.write("quick_switch.yaml", "base: target_switch\nduration: 6\nswitch_every: 3\n");
  EXPECT_THAT(refused({files_ / "run"}), refused_at({.file = testing::EndsWith("quick_switch.yaml")}));
  fs::rename(scenario_, files_ / "away.yaml");
  const auto of_rollout = refused_at({.file = testing::EndsWith("/run/rollout_quick_switch.csv")});
  const InputError moved = refused({files_ / "run"});
  EXPECT_THAT(moved, of_rollout);
  EXPECT_THAT(moved.what(), testing::ContainsRegex("no longer exists.*--scenarios FILE"));
  fs::remove(files_ / "run/run.json");
  const InputError unknown = refused({files_ / "run"});
  EXPECT_THAT(unknown, of_rollout);
  EXPECT_THAT(unknown.what(), testing::ContainsRegex("is not bundled.*--scenarios FILE"));
  EXPECT_THAT(refused({files_ / "run", "--scenarios", "moving_target"}).what(),
              HasSubstr("/run/rollout_moving_target.csv: "));
  const InputError above = refused({files_ / ""});
  EXPECT_THAT(above, refused_at({.file = files_ / ""}));
  EXPECT_THAT(above.what(), testing::EndsWith("/run"));
  EXPECT_THAT(refused({files_ / "nowhere"}), refused_at({.file = files_ / "nowhere"}));
}

TEST_F(YardstickProgram, NoticesAChangedScenarioThatTheRunNamedByARelativePath) {
  const Finished done =
      test::Program({"simulate", "quick_switch.yaml", "--gains", "gains.yaml", "--out", "run"}, files_ / "")
          .wait();
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(test::Program({"yardstick", "run", "--knots", "60"}, files_ / "").wait().exit_code, 0);
  files_.write("quick_switch.yaml", "base: target_switch\nduration: 6\nswitch_every: 3\n");
  for (const std::string& folder : {files_ / "", std::string("/")}) {
    const Finished refused = test::Program({"yardstick", files_ / "run"}, folder).wait();
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr(folder == "/" ? "no longer exists" : "has changed"));
  }
}

TEST_F(YardstickProgram, AtTheEndOfASimulationItsLimitStandsBesideTheTime) {
  ASSERT_EQ(simulate("plain").exit_code, 0);
  const Finished held = simulate("held", {"--yardstick"});
  ASSERT_EQ(held.exit_code, 0) << held.err;
  const Csv plain = test::read_csv(files_ / "plain/errors.csv");
  const Csv errors = test::read_csv(files_ / "held/errors.csv");
  ASSERT_EQ(errors.header.size(), plain.header.size() + 1);
  for (const std::string& name : plain.header) EXPECT_EQ(errors.at(0, name), plain.at(0, name)) << name;
  const Csv yardstick = test::read_csv(files_ / "held/yardstick.csv");
  double largest = 0.0;
  for (std::size_t r = 0; r < yardstick.rows.size(); ++r) {
    if (yardstick.at(r, "event") == "switch")
      largest = std::fmax(largest, std::stod(yardstick.at(r, "limit")));
  }
  EXPECT_EQ(std::stod(errors.at(0, "reacquisition/limit")), largest);
  // Rows are 10 ms apart.
  EXPECT_LE(largest, std::stod(errors.at(0, "reacquisition/time")) + 0.01);
  EXPECT_THAT(read_text(files_ / "held/columns.csv"),
              AllOf(HasSubstr("\nerrors.csv,reacquisition/limit,s,"), HasSubstr("\nyardstick.csv,ratio,1,")));
  EXPECT_FALSE(fs::exists(files_ / "plain/yardstick.csv"));
  EXPECT_THAT(read_text(files_ / "plain/columns.csv"), Not(HasSubstr("limit,s,")));
  const Finished nowhere = run_program({"simulate", scenario_, "--yardstick"});
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("--out"));
}

TEST_F(YardstickProgram, OfATunedRunIsOfBothGainSets) {
  files_.write("study.yaml", "gains: gains.yaml\nscenarios: [quick_switch.yaml]\n" + test::kShortParameters +
                                 "objective:\n  - {metric: error/orientation/rms, weight: 1}\n" +
                                 test::kShortConstraints + test::kShortSearch);
  const Finished tuned = run_program({"tune", files_.path(), "--out", files_ / "run", "--max-evaluations",
                                      "3", "--no-analysis", "--yardstick"});
  ASSERT_TRUE(tuned.exit_code == 0 || tuned.exit_code == 3) << tuned.err;
  for (const char* set : {"run/start", "run"}) {
    const Csv errors = test::read_csv(files_ / (std::string(set) + "/errors.csv"));
    EXPECT_GT(std::stod(errors.at(0, "reacquisition/limit")), 0.0) << set;
    EXPECT_TRUE(fs::exists(files_ / (std::string(set) + "/yardstick.csv"))) << set;
  }
  // One of its sets, by the study of the run above it.
  const Finished start = run_program({"yardstick", files_ / "run/start", "--knots", "40"});
  EXPECT_EQ(start.exit_code, 0) << start.err;
  if (!report::available()) return;
  EXPECT_THAT(start.out, HasSubstr("run/report.html"));
  const auto data = test::parsed(test::data_of(read_text(files_ / "run/report.html")));
  EXPECT_EQ(test::at(data, "yardstick").items().size(), 4U);
  // Behind the simulation checks.
  bool told = false;
  for (const yaml::Node& detail : test::at(data, "verdict/details").items())
    told = told || detail.as_string().find("the joint limits allow") != std::string::npos;
  EXPECT_TRUE(told);
}

}  // namespace yardstick_test
}  // namespace armtune::internal

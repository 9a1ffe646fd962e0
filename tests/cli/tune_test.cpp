#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/cli/support/program.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace tune_test {

namespace fs = std::filesystem;
using test::Finished;
using test::Program;
using test::run_program;
using test::ShortStudy;
using testing::HasSubstr;

/// What a run folder holds at least; the start's own files stand beside them under other names.
constexpr const char* kFiles[] = {
    "study.yaml",  "gains.yaml", "evaluations.csv",   "errors.csv",
    "columns.csv", "run.json",   "rollout_short.csv", "rollout_short_realistic.csv"};

void expect_whole_run(const std::string& folder) {
  for (const char* file : kFiles) EXPECT_TRUE(fs::exists(folder + "/" + file)) << file;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_directory()) continue;
    EXPECT_NE(entry.path().extension(), ".partial") << entry.path();
    EXPECT_GT(fs::file_size(entry.path()), 0U) << entry.path();
  }
  const auto journal = test::read_csv(folder + "/evaluations.csv");
  EXPECT_FALSE(journal.rows.empty());
  EXPECT_EQ(journal.at(0, "phase"), "start");
  EXPECT_EQ(journal.at(0, "objective"), "1");
  EXPECT_TRUE(test::read_text(folder + "/evaluations.csv").ends_with('\n'));
}

TEST(TuneCommand, LeavesGainsThatTheOtherCommandsTake) {
  const ShortStudy files;
  const Finished tuned = run_program({"tune", files.path(), "--out", files / "run", "--workers", "2",
                                      "--max-evaluations", "8", "--seed", "5", "--no-analysis"});
  ASSERT_EQ(tuned.exit_code, 0) << tuned.err << tuned.out;
  EXPECT_EQ(tuned.err, "") << "quiet where there is no terminal";
  EXPECT_THAT(tuned.out, testing::AllOf(HasSubstr("start"), HasSubstr("tuned"),
                                        HasSubstr("every constraint holds"), HasSubstr(files / "run")));
  expect_whole_run(files / "run");
  EXPECT_LE(test::read_csv(files / "run/evaluations.csv").rows.size(), 8U);

  const Finished again =
      run_program({"simulate", files / "short.yaml", files / "short_realistic.yaml", "--gains",
                   files / "run/gains.yaml", "--out", files / "again", "--workers", "1"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(test::read_text(files / "again/errors.csv"), test::read_text(files / "run/errors.csv"))
      << "the reported figures are those of the gains file";

  const Finished compared = run_program({"compare", files / "run", "--out", files / "compared"});
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_EQ(test::read_text(files / "compared/errors_run.csv"), test::read_text(files / "run/errors.csv"))
      << "a run folder stands for its gains and its study's scenarios";
}

TEST(TuneCommand, BeginsWithFirstGainsOfItsOwnWhereThoseOfTheStudyDiverge) {
  const ShortStudy files(
      "parameters:\n  - {name: task_space_gains_p/rx}\n  - {name: slerpDurationErrorGain}\n");
  files.write("short.yaml", "base: moving_target\nduration: 20\n");
  files.write("short_realistic.yaml", "base: realistic_moving_target\nduration: 20\n");
  Gains ringing = test::quick_gains(test::scenario_of("moving_target"));
  ringing.task_space_gains_p *= 100.0;
  files.write("gains.yaml", gains_yaml(ringing, {}));
  const std::vector<std::string> words = {"tune", files.path(),    "--workers", "2", "--max-evaluations",
                                          "6",    "--no-analysis", "--out"};
  const auto run_to = [&](const std::string& folder) {
    std::vector<std::string> all = words;
    all.push_back(files / folder);
    return run_program(all);
  };
  const Finished tuned = run_to("run");
  EXPECT_THAT(tuned.exit_code, testing::AnyOf(0, 3)) << tuned.err;
  EXPECT_THAT(tuned.err, HasSubstr("cannot be a reference"));
  EXPECT_THAT(tuned.out, HasSubstr("given"));
  ASSERT_TRUE(fs::exists(files / "run/gains.yaml")) << tuned.err;
  expect_whole_run(files / "run");
  const auto given = test::read_csv(files / "run/given/errors.csv");
  const auto start = test::read_csv(files / "run/start/errors.csv");
  EXPECT_EQ(start.at(0, "status"), "completed");
  EXPECT_THAT((std::vector{given.at(0, "status"), given.at(1, "status")}),
              testing::Contains(testing::Ne("completed")));
  EXPECT_TRUE(fs::exists(files / "run/given/gains.yaml"));
  EXPECT_THAT(test::read_text(files / "run/verdict.yaml"), HasSubstr("cannot be a reference"));
  EXPECT_THAT(test::read_text(files / "run/scene.json"), HasSubstr("given/errors.csv"));
  const std::string report = test::read_text(files / "run/report.html");
  EXPECT_NE(report.find(R"(["start","given",)"), std::string::npos) << "the page shows all three";
  EXPECT_EQ(run_to("second").exit_code, tuned.exit_code);
  EXPECT_EQ(test::read_text(files / "second/gains.yaml"), test::read_text(files / "run/gains.yaml"));
}

TEST(TuneCommand, EndsWithMarginsAndWhichGainsMatterAsTheirOwnCommandsDo) {
  const ShortStudy files;
  const Finished tuned =
      run_program({"tune", files.path(), "--out", files / "run", "--workers", "2", "--max-evaluations", "6"});
  ASSERT_EQ(tuned.exit_code, 0) << tuned.err;
  EXPECT_THAT(tuned.out, HasSubstr("gain, most important first"));
  const Finished margins =
      run_program({"margins", files / "run", "--out", files / "margins", "--workers", "1"});
  ASSERT_EQ(margins.exit_code, 0) << margins.err;
  EXPECT_EQ(test::read_text(files / "margins/margins.csv"), test::read_text(files / "run/margins.csv"));
  EXPECT_TRUE(fs::exists(files / "run/start/margins.csv"));
  const Finished again =
      run_program({"sensitivity", files / "run", "--out", files / "again", "--workers", "1"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  for (const char* file : {"/sensitivity.csv", "/reduced_study.yaml"}) {
    EXPECT_EQ(test::read_text(files / "again" + file), test::read_text(files / "run" + file)) << file;
  }
  const Finished reduced = run_program({"tune", files / "run/reduced_study.yaml", "--out", files / "reduced",
                                        "--max-evaluations", "3", "--no-analysis"});
  EXPECT_EQ(reduced.exit_code, 0) << reduced.err;
  EXPECT_THAT(reduced.out, HasSubstr("1 gains, 2 scenarios"));
  EXPECT_FALSE(fs::exists(files / "reduced/sensitivity.csv"));
  const Finished none = run_program({"sensitivity", files / "nothing"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("nothing/study.yaml"));
}

TEST(TuneCommand, ItsResolvedStudyGivesTheSameEvaluationsAgain) {
  const ShortStudy files;
  ASSERT_EQ(run_program({"tune", files.path(), "--out", files / "a", "--workers", "1", "--max-evaluations",
                         "6", "--no-analysis"})
                .exit_code,
            0);
  const Finished again =
      run_program({"tune", files / "a/study.yaml", "--out", files / "b", "--workers", "2", "--no-analysis"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto a = test::read_csv(files / "a/evaluations.csv");
  const auto b = test::read_csv(files / "b/evaluations.csv");
  ASSERT_EQ(a.header, b.header);
  ASSERT_EQ(a.header.back(), "time/wall");
  ASSERT_EQ(a.rows.size(), b.rows.size());
  for (std::size_t r = 0; r < a.rows.size(); ++r) {
    for (std::size_t c = 0; c + 1 < a.header.size(); ++c)
      EXPECT_EQ(a.rows[r][c], b.rows[r][c]) << a.header[c];
  }
}

TEST(TuneCommand, WithoutAFeasiblePointItEndsWithThreeAndSaysWhatIsMissed) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective,
                         "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: 0.01}\n");
  const Finished tuned = run_program({"tune", files.path(), "--out", files / "run", "--max-evaluations", "3",
                                      "--workers", "2", "--no-analysis"});
  EXPECT_EQ(tuned.exit_code, 3) << tuned.err;
  EXPECT_THAT(tuned.out,
              testing::AllOf(HasSubstr("NOT feasible"), HasSubstr("joint_velocity/max_ratio <= 0.01")));
  expect_whole_run(files / "run");
}

TEST(TuneCommand, InterruptedItKeepsEverythingSoFar) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         "search: {max_evaluations: 100000, x_tolerance: 0, objective_tolerance: 0}\n");
  Program tuning({"tune", files.path(), "--out", files / "run", "--workers", "2"}, testing::TempDir());
  const std::string journal = files / "run/evaluations.csv";
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  const auto rows = [&] {
    const std::string text = test::read_text(journal);
    return std::count(text.begin(), text.end(), '\n') - 1;
  };
  while (rows() < 3 && tuning.running() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ASSERT_GE(rows(), 3);
  ASSERT_TRUE(tuning.running());
  tuning.interrupt();
  const Finished ended = tuning.wait();
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("interrupted"));
  expect_whole_run(files / "run");
  EXPECT_EQ(run_program({"simulate", files / "short.yaml", "--gains", files / "run/gains.yaml"}).exit_code,
            0);
}

TEST(TuneCommand, InterruptedInTheAnalysisItSaysSoAndKeepsTheRun) {
  const ShortStudy files;
  Program tuning({"tune", files.path(), "--out", files / "run", "--workers", "2", "--max-evaluations", "2"},
                 testing::TempDir());
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  // The last file before the analysis.
  while (!fs::exists(files / "run/run.json") && tuning.running() &&
         std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_TRUE(tuning.running());
  tuning.interrupt();
  const Finished ended = tuning.wait();
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("the analysis after it was not"));
  expect_whole_run(files / "run");
}

TEST(TuneCommand, OnManyArmsItReportsTheMeasureAndTheScenariosOwnArmApart) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         "robust: {samples: 2, measure: worst}\n");
  const Finished tuned = run_program({"tune", files.path(), "--out", files / "run", "--workers", "2",
                                      "--max-evaluations", "4", "--no-analysis"});
  ASSERT_TRUE(tuned.exit_code == 0 || tuned.exit_code == 3) << tuned.err;
  EXPECT_THAT(tuned.out, testing::AllOf(HasSubstr("(worst of 3 arms in each scenario)"),
                                        HasSubstr("The nominal arm alone")));
  const auto robust = test::read_csv(files / "run/robust_errors.csv");
  const auto own = test::read_csv(files / "run/errors.csv");
  const auto journal = test::read_csv(files / "run/evaluations.csv");
  ASSERT_EQ(robust.rows.size(), 2U);
  EXPECT_NE(robust.at(1, "effort_rate/rms"), own.at(1, "effort_rate/rms"));
  const auto start = test::read_csv(files / "run/start/robust_errors.csv");
  EXPECT_EQ(start.at(0, "error/orientation/rms"), journal.at(0, "short/error/orientation/rms"));
}

TEST(TuneCommand, AWarmStartIsKeptInTheRunFolderSoThatTheRunItCameFromMayGo) {
  const ShortStudy files;
  const auto tune = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"tune"});
    arguments.insert(arguments.end(), {"--workers", "2", "--max-evaluations", "5", "--no-analysis"});
    return run_program(arguments);
  };
  ASSERT_EQ(tune({files.path(), "--out", files / "first"}).exit_code, 0);
  const Finished warm =
      tune({files.path(), "--warm-start", files / "first", "--warm-parameters", "task_space_gains_p",
            "--warm-box", "0.3", "--warm-step", "0.05", "--out", files / "warm"});
  ASSERT_EQ(warm.exit_code, 0) << warm.err;
  const auto journal = test::read_csv(files / "warm/evaluations.csv");
  EXPECT_EQ(journal.at(1, "phase"), "warm");
  fs::remove_all(files / "first");
  const Finished again = tune({files / "warm/study.yaml", "--out", files / "again"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto repeated = test::read_csv(files / "again/evaluations.csv");
  ASSERT_EQ(repeated.rows.size(), journal.rows.size());
  for (std::size_t r = 0; r < journal.rows.size(); ++r) {
    EXPECT_EQ(repeated.at(r, "objective"), journal.at(r, "objective"));
  }
}

TEST(TuneCommand, SaysWhichGainsOfAWarmStartItsBoundsDoNotAllow) {
  const ShortStudy files;
  Gains gains = load_study(files.path()).space.start;
  gains.slerpDurationErrorGain = 77.0;
  files.write("far.yaml", gains_yaml(gains, {}));
  const Finished tuned = run_program({"tune", files.path(), "--warm-start", files / "far.yaml", "--out",
                                      files / "run", "--max-evaluations", "3", "--no-analysis"});
  ASSERT_TRUE(tuned.exit_code == 0 || tuned.exit_code == 3) << tuned.err;
  EXPECT_THAT(tuned.err, testing::AllOf(HasSubstr("warning"), HasSubstr("slerpDurationErrorGain"),
                                        HasSubstr("77"), HasSubstr("1 .. 4")));
}

TEST(TuneCommand, AWarmStartThatIsNoneIsRefused) {
  const ShortStudy files;
  const auto refused = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"tune", files.path(), "--out", files / "run"});
    const Finished finished = run_program(arguments);
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_FALSE(fs::exists(files / "run"));
    return finished.err;
  };
  EXPECT_THAT(refused({"--warm-box", "0.5"}), HasSubstr("--warm-start"));
  EXPECT_THAT(refused({"--warm-start", files / "nowhere.yaml"}), HasSubstr("nowhere.yaml"));
  EXPECT_THAT(refused({"--warm-start", files / "gains.yaml", "--warm-parameters", "adaptation_gain"}),
              HasSubstr("'adaptation_gain' is not tuned"));
  EXPECT_THAT(refused({"--warm-start", files / "gains.yaml", "--warm-box", "1.5"}), HasSubstr("--warm-box"));
}

TEST(TuneCommand, SaysThatTheSweepUsesUpTheBudget) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         "sweep: [{parameters: [task_space_gains_p/rx], factors: [0.8, 0.9, 1.1]}]\n"
                         "search: {max_evaluations: 3, max_minutes: 5}\n");
  const Finished cut = run_program({"tune", files.path(), "--out", files / "cut", "--no-analysis"});
  EXPECT_THAT(
      cut.out,
      testing::AllOf(HasSubstr("3 evaluations or 5 minutes, 2 rollouts per evaluation"),
                     HasSubstr("the sweep's 3 points take all evaluations of the budget: only 2 of them")));
  const Finished whole = run_program(
      {"tune", files.path(), "--max-evaluations", "4", "--out", files / "whole", "--no-analysis"});
  EXPECT_THAT(whole.out, HasSubstr("take all evaluations of the budget: no evaluation is left"));
  const Finished enough = run_program(
      {"tune", files.path(), "--max-evaluations", "5", "--out", files / "enough", "--no-analysis"});
  EXPECT_THAT(enough.out, testing::Not(HasSubstr("use up")));
}

/// Nothing that breaks a constraint, and nothing that is no better than the start, is called tuned.
TEST(TuneCommand, ASearchThatFailsSaysSoAndNamesWhatIsInTheWay) {
  const std::string impossible = "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: 0.001}\n";
  for (const char* evaluations : {"1", "6"}) {
    const ShortStudy files(test::kShortParameters, test::kShortObjective, impossible);
    const Finished done = run_program({"tune", files.path(), "--out", files / "run", "--workers", "2",
                                       "--max-evaluations", evaluations, "--no-analysis"});
    EXPECT_EQ(done.exit_code, 3) << done.err;
    EXPECT_FALSE(test::read_text(files / "run/gains.yaml").starts_with("# tuned"));
    EXPECT_THAT(done.out, testing::Not(testing::ContainsRegex("\n[a-z_]+ +start +tuned +ratio")));
    EXPECT_THAT(done.out, HasSubstr("joint_velocity/max_ratio <= 0.001"));
    EXPECT_THAT(done.out, HasSubstr("Simulation checks: failed"));
    const bool one = std::string(evaluations) == "1";
    EXPECT_THAT(done.out, HasSubstr(one ? "the start gains" : "least violation"));
  }
}

TEST(TuneCommand, ASearchThatFindsNothingBetterKeepsTheStartGains) {
  const ShortStudy files;
  const Finished done = run_program({"tune", files.path(), "--out", files / "run", "--workers", "2",
                                     "--max-evaluations", "1", "--no-analysis"});
  EXPECT_EQ(done.exit_code, 3) << done.err;
  const auto joints = joint_names(*test::scenario_of("moving_target").robot);
  const Gains kept = load_gains(files / "run/gains.yaml", joints);
  const Gains start = load_gains(files / "run/start/gains.yaml", joints);
  EXPECT_EQ(gains_yaml(kept, {}), gains_yaml(start, {}));
  EXPECT_THAT(done.out, HasSubstr("nothing better than the start"));
}

}  // namespace tune_test
}  // namespace armtune::internal

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <thread>

#include "sim/scenario/gains_file.hpp"
#include "sim/yaml/document.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/report/report.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace simulate_test {

namespace fs = std::filesystem;
using test::Finished;
using test::run_program;
using test::ShortStudy;
using testing::HasSubstr;

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename());
  return names;
}

// What is doubtful about an arm is said before anything rests on it.
TEST(Simulate, AndTuneWarnOfADoubtfulArm) {
  const ShortStudy files;
  files.write(
      "light.yaml",
      "urdf: " + test::source_dir() +
          "/sim/robots/ur10.urdf\nrotor_inertia: [1, 1, 1, 0.2, 0.2, 0.2]\ninertia:\n  upper_arm_link: {mass: "
          "0.01, center: [0, 0, 0.2], moments: [1.0e-4, 0, 0, 1.0e-4, 0, 1.0e-5]}\n");
  const std::string own = files.write("own.yaml", "base: short.yaml\nrobot: light.yaml\n");
  const Finished simulated = run_program({"simulate", own, "--gains", files / "gains.yaml"});
  EXPECT_THAT(simulated.err, HasSubstr("armtune: warning: ur10: upper_arm_link (0.01 kg)"));
  const std::string study =
      files.write("doubtful.yaml",
                  "gains: gains.yaml\nscenarios: [own.yaml]\nparameters: [{name: task_space_gains_p}]\n"
                  "objective: [{metric: error/position/rms, weight: 1}]\n");
  const Finished tuned =
      run_program({"tune", study, "--max-evaluations", "1", "--no-analysis", "--out", files / "doubtful"});
  EXPECT_THAT(tuned.err, HasSubstr("armtune: warning: ur10: upper_arm_link (0.01 kg)"));
}

TEST(Simulate, WritesTheFilesItNames) {
  const ShortStudy files;
  const Finished done = run_program({"simulate", files / "short.yaml", "--gains", files / "gains.yaml",
                                     "--out", files / "run", "--workers", "1"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.err, "") << "quiet where there is no terminal";
  std::vector<std::string> expected = {"errors.csv", "rollout_short.csv", "columns.csv", "gains.yaml",
                                       "run.json",   "verdict.yaml",      "scene.json",  "inputs"};
  if (report::available()) expected.emplace_back("report.html");
  EXPECT_THAT(files_in(files / "run"), testing::UnorderedElementsAreArray(expected));
  for (const std::string& file : expected) {
    EXPECT_THAT(done.out, HasSubstr(file == "rollout_short.csv" ? "rollout_<scenario>.csv" : file));
  }
  const auto errors = test::read_csv(files / "run/errors.csv");
  ASSERT_EQ(errors.rows.size(), 1U);
  EXPECT_EQ(errors.at(0, "scenario"), "short");
  EXPECT_EQ(errors.at(0, "status"), "completed");
  EXPECT_GT(std::stod(errors.at(0, "samples")), 100.0);
  EXPECT_THAT(done.out, HasSubstr("error/orientation/max"));
  const RunRecord run = find_run_record(files / "run").value();
  EXPECT_EQ(run.kind, RunKind::kSimulate);
  EXPECT_EQ(run.seed, 1U);
  ASSERT_TRUE(run.simulation);
  EXPECT_EQ(run.simulation->engine, Engine::kSimbody);
  EXPECT_EQ(run.simulation->gains_hash, hash_of_file(files / "run/gains.yaml"));
}

TEST(Simulate, ItsGainsFileGivesTheSameRunAgain) {
  const ShortStudy files;
  ASSERT_EQ(
      run_program({"simulate", files / "short.yaml", "--gains", files / "gains.yaml", "--out", files / "a"})
          .exit_code,
      0);
  ASSERT_EQ(
      run_program({"simulate", files / "short.yaml", "--gains", files / "a/gains.yaml", "--out", files / "b"})
          .exit_code,
      0);
  EXPECT_EQ(test::read_text(files / "a/errors.csv"), test::read_text(files / "b/errors.csv"));
  EXPECT_EQ(test::read_text(files / "a/rollout_short.csv"), test::read_text(files / "b/rollout_short.csv"));
}

TEST(Simulate, OverwritesNoFinishedRun) {
  const ShortStudy files;
  std::filesystem::create_directory(files / "run");
  files.write("run/kept.txt", "precious");
  const Finished refused = run_program({"simulate", files / "short.yaml", "--out", files / "run"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr(files / "run"));
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  EXPECT_THAT(files_in(files / "run"), testing::ElementsAre("kept.txt"));
  EXPECT_EQ(test::read_text(files / "run/kept.txt"), "precious");
}

TEST(Simulate, RefusesAFolderThatAnotherRunIsAboutToWriteInto) {
  const ShortStudy files;
  const FolderLock other = make_run_folder(files / "run");
  const Finished refused = run_program({"simulate", files / "short.yaml", "--out", files / "run"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, testing::AllOf(HasSubstr(files / "run"), HasSubstr("another run")));
  EXPECT_TRUE(files_in(files / "run").empty());
}

TEST(Simulate, ADeadlineEndsAScenarioWithAStatusAndLosesNoOther) {
  const ShortStudy files;
  const Finished late =
      run_program({"simulate", files / "short.yaml", files / "short_realistic.yaml", "--gains",
                   files / "gains.yaml", "--out", files / "run", "--rollout-deadline", "1e-9"});
  EXPECT_EQ(late.exit_code, 3);
  const auto errors = test::read_csv(files / "run/errors.csv");
  ASSERT_EQ(errors.rows.size(), 2U);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(errors.at(row, "status"), "interrupted");
    EXPECT_EQ(errors.at(row, "error/position/max"), "") << "not 0: it was never computed";
    EXPECT_THAT(errors.at(row, "reason"),
                testing::AllOf(HasSubstr("interrupted at 0.000 s of 8 s"), HasSubstr("--rollout-deadline")));
  }
}

TEST(Simulate, ItsCommandInTheRecordMakesTheRunAgainFromAShell) {
  const ShortStudy files;
  const std::string odd = "it's $HOME; <b>.yaml";  // a shell would do something with every part of this
  fs::copy_file(files / "short.yaml", files / odd);
  ASSERT_EQ(run_program({"simulate", files / odd, "--gains", files / "gains.yaml", "--out", files / "run"})
                .exit_code,
            0);
  const std::string errors = test::read_text(files / "run/errors.csv");
  const std::string command = find_run_record(files / "run").value().command;
  fs::remove_all(files / "run");
  fs::create_symlink(test::program_path(), files / "armtune");
  const std::string found = "PATH=\"" + (files / "") + ":$PATH\"; ";
  ASSERT_EQ(std::system((found + command + " > " + (files / "output.txt")).c_str()), 0) << command;
  EXPECT_EQ(test::read_text(files / "run/errors.csv"), errors);
}

TEST(Simulate, ARunThatDivergesOrDoesNotTrackFailsAndSaysWhy) {
  const ShortStudy files;
  files.write("too_short.yaml", "base: moving_target\nduration: 3\n");
  const Finished failed = run_program(
      {"simulate", files / "too_short.yaml", "--gains", files / "gains.yaml", "--out", files / "run"});
  EXPECT_EQ(failed.exit_code, 3);
  EXPECT_THAT(failed.out, HasSubstr("counted as tracking"));
  const auto errors = test::read_csv(files / "run/errors.csv");
  EXPECT_EQ(errors.at(0, "status"), "no_samples");
  EXPECT_EQ(errors.at(0, "error/position/max"), "");
}

TEST(Compare, GivesTheNumbersOfTheRunItself) {
  const ShortStudy files;
  ASSERT_EQ(run_program({"simulate", files / "short.yaml", files / "short_realistic.yaml", "--gains",
                         files / "gains.yaml", "--out", files / "run"})
                .exit_code,
            0);
  const Finished done =
      run_program({"compare", files / "gains.yaml", files / "run", "--scenarios", files / "short.yaml",
                   files / "short_realistic.yaml", "--out", files / "comparison", "--workers", "2"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(test::read_text(files / "comparison/errors_run.csv"), test::read_text(files / "run/errors.csv"));
  const auto errors = test::read_csv(files / "run/errors.csv");
  const auto comparison = test::read_csv(files / "comparison/comparison.csv");
  std::map<std::string, std::size_t> rows = {{"short", 0}, {"short_realistic", 1}};
  EXPECT_FALSE(comparison.rows.empty());
  for (std::size_t r = 0; r < comparison.rows.size(); ++r) {
    EXPECT_EQ(comparison.at(r, "run"),
              errors.at(rows.at(comparison.at(r, "scenario")), comparison.at(r, "metric")));
  }
  EXPECT_THAT(done.out, HasSubstr("ratio"));
}

/// Kp a hundredfold: the command says so with joint and time, last on the screen, in the file and as exit
/// code.
TEST(Simulate, SaysWhichCheckFailedAndEndsWithThree) {
  const ShortStudy files;
  Gains wild = test::quick_gains(test::scenario_of("moving_target"));
  wild.task_space_gains_p *= 100.0;
  files.write("wild.yaml", gains_yaml(wild, {}));
  const Finished failed =
      run_program({"simulate", files / "short.yaml", "--gains", files / "wild.yaml", "--out", files / "run"});
  EXPECT_EQ(failed.exit_code, 3) << failed.err;
  const auto verdict = yaml::parse_file(files / "run/verdict.yaml");
  EXPECT_FALSE(verdict.find("passed")->as_boolean());
  bool effort = false;
  for (const yaml::Node& check : verdict.find("checks")->items()) {
    if (check.find("check")->as_string() != "effort limit") continue;
    effort = true;
    EXPECT_FALSE(check.find("passed")->as_boolean());
    const std::string joint = check.find("joint")->as_string();
    EXPECT_THAT(failed.out, HasSubstr(joint));
    EXPECT_GT(check.find("time")->as_number(), 0.0);
    EXPECT_GT(check.find("value")->as_number(), check.find("threshold")->as_number());
  }
  EXPECT_TRUE(effort);
  EXPECT_GT(failed.out.rfind("Simulation checks: failed"), failed.out.rfind("wrote "));
  if (report::available()) {
    EXPECT_THAT(test::read_text(files / "run/report.html"), HasSubstr("Simulation checks: failed"));
  }
  // The same gains as they were pass, and what was not checked is named.
  const Finished passed = run_program({"simulate", files / "short.yaml", "--gains", files / "gains.yaml"});
  EXPECT_EQ(passed.exit_code, 0) << passed.err;
  EXPECT_THAT(passed.out, HasSubstr("Not checked: "));
}

TEST(Simulate, EnduranceExtendsTheScenarioAndNamesWhatBreaks) {
  const test::TemporaryFolder folder;
  Gains gains = load_gains("extended_tuned", joint_names(*test::scenario_of("moving_target").robot));
  gains.roll_centering_gain = 0.0;
  const std::string winding = folder.write("winding.yaml", gains_yaml(gains, {}));
  const std::string scenario = "identified_realistic_moving_target";
  const Finished failed = run_program({"simulate", scenario, "--gains", winding, "--engine", "native",
                                       "--endurance", "4", "--out", folder / "run"});
  EXPECT_EQ(failed.exit_code, 3) << failed.err;
  EXPECT_THAT(failed.out, HasSubstr("wrist_3_joint"));
  const auto verdict = yaml::parse_file(folder / "run/verdict.yaml");
  for (const yaml::Node& check : verdict.find("checks")->items()) {
    // Forty seconds show nothing of it.
    EXPECT_EQ(check.find("passed")->as_boolean(), check.find("check")->as_string() != "endurance");
  }
  const Finished held = run_program(
      {"simulate", scenario, "--gains", "extended_tuned", "--engine", "native", "--endurance", "4"});
  EXPECT_EQ(held.exit_code, 0) << held.out;
}

/// Hours of simulated time take long enough that an interrupt meets them. What is not done has passed
/// nothing.
TEST(Simulate, AnInterruptedEnduranceIsNoVerdict) {
  const test::TemporaryFolder folder;
  for (const char* command : {"simulate", "compare"}) {
    const std::string out = folder / command;
    std::vector<std::string> words = {command};
    if (std::string(command) == "simulate") {
      words.insert(words.end(), {"fixed_target", "--gains", "extended_tuned", "--engine", "native"});
    } else {
      words.insert(words.end(), {"extended_tuned", "--scenarios", "fixed_target"});
    }
    words.insert(words.end(), {"--endurance", "1440", "--out", out});
    test::Program program(words, folder.path());
    // Its own 40 s are recorded within seconds; a day of it takes minutes.
    const std::string recording = out +
                                  (std::string(command) == "simulate" ? "" : "/rollouts_extended_tuned") +
                                  "/rollout_fixed_target.csv";
    for (int i = 0; i < 1200 && !std::filesystem::exists(recording); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    std::this_thread::sleep_for(std::chrono::seconds(5));
    ASSERT_TRUE(program.running()) << command;
    const std::string results =
        out + (std::string(command) == "simulate" ? "/errors.csv" : "/comparison.csv");
    for (const std::string& file : {results, out + "/run.json"})
      EXPECT_NE(test::read_text(file), "") << "what is finished is written before what takes hours";
    const std::string before = test::read_text(results);
    program.interrupt();
    const Finished finished = program.wait();
    EXPECT_EQ(test::read_text(results), before);
    EXPECT_EQ(finished.exit_code, 130) << finished.out << finished.err;
    EXPECT_THAT(finished.out, testing::Not(HasSubstr("Simulation checks"))) << command;
    EXPECT_FALSE(std::filesystem::exists(out + "/verdict.yaml")) << command;
  }
}

/// A circle about the base with a fixed orientation of the tool turns the first joint round and round.
TEST(Simulate, APathThatWindsAJointUpIsRefusedByTheJointsName) {
  const test::TemporaryFolder folder;
  const std::string scenario = folder.write("laps.yaml",
                                            "base: moving_target\nduration: 60\npath:\n  center: [0, 0, "
                                            "0.4]\n  frequency: 0.6283185307179586\n  terms:\n"
                                            "    - {order: 1, cos: [-0.6, 0, 0], sin: [0, -0.6, 0]}\n"
                                            "targets:\n  - {name: below, center: [0, 0, 0], frequency: "
                                            "0.6283185307179586, terms: [{order: 1, cos: [-0.6, 0, 0], "
                                            "sin: [0, -0.6, 0]}]}\n");
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"simulate", scenario, "--gains", "extended_tuned"},
           {"simulate", scenario, "--gains", "published"},
           {"compare", "published", "extended_tuned", "--scenarios", scenario},
           {"margins", "extended_tuned", "--scenarios", scenario},
           {"robustness", "extended_tuned", "--scenarios", scenario, "--samples", "2", "--out",
            folder / "arms"}}) {
    const Finished refused = run_program(command);
    EXPECT_EQ(refused.exit_code, 2) << command.front() << refused.out;
    EXPECT_THAT(refused.err, HasSubstr("shoulder_pan_joint")) << command.front();
  }
}

}  // namespace simulate_test
}  // namespace armtune::internal

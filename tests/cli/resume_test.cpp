// Killed at any moment, a run resumes as if it had not been.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/cli/support/program.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace resume_test {

namespace fs = std::filesystem;
using test::Finished;
using test::Program;
using test::run_program;
using test::ShortStudy;
using testing::AllOf;
using testing::HasSubstr;

std::size_t lines_of(const std::string& path) {
  if (!fs::exists(path)) return 0;
  const std::string text = test::read_text(path);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// A CSV file without its last column, the wall time.
std::string without_time(const std::string& path) {
  std::string text;
  std::istringstream lines(test::read_text(path));
  for (std::string line; std::getline(lines, line);) text += line.substr(0, line.rfind(',')) + '\n';
  return text;
}

std::size_t finished_in(const std::string& journal) {
  if (!fs::exists(journal)) return 0;
  const std::string text = test::read_text(journal);
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find("finished\t", at)) != std::string::npos; ++at) ++count;
  return count;
}

/// Starts the command and kills it once its journal holds that many finished ones.
void run_and_kill(const std::vector<std::string>& arguments, const std::string& journal,
                  std::size_t finished) {
  const test::TemporaryFolder folder;
  Program program(arguments, folder.path());
  while (program.running() && finished_in(journal) < finished) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  program.kill();
  EXPECT_EQ(program.wait().exit_code, -1) << "it was to be killed under way";
}

void expect_same_run(const std::string& a, const std::string& b, const std::vector<std::string>& files) {
  EXPECT_EQ(without_time(a + "/evaluations.csv"), without_time(b + "/evaluations.csv"));
  for (const std::string& file : files) {
    EXPECT_NE(test::read_text(a + "/" + file), "") << file;
    EXPECT_EQ(test::read_text(a + "/" + file), test::read_text(b + "/" + file)) << file;
  }
}

TEST(Resume, ATuningKilledAgainAndAgainEndsAsIfItHadNotBeen) {
  const ShortStudy files;
  const std::vector<std::string> begin = {"tune", files.path(), "--no-analysis", "--seed", "3"};
  auto with = [&begin](const std::string& folder) {
    auto all = begin;
    all.insert(all.end(), {"--out", folder});
    return all;
  };
  ASSERT_EQ(run_program(with(files / "whole")).exit_code, 0);
  run_and_kill(with(files / "killed"), files / "killed/journal.txt", 3);
  const std::vector<std::string> resume = {"tune", "--resume", files / "killed", "--workers", "1"};
  run_and_kill(resume, files / "killed/journal.txt", 7);
  const std::size_t finished = finished_in(files / "killed/journal.txt");
  const Finished ended = run_program(resume);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(fmt::format("resuming after {} finished evaluations", finished)));
  expect_same_run(files / "whole", files / "killed",
                  {"gains.yaml", "errors.csv", "study.yaml", "rollout_short.csv"});
  EXPECT_EQ(finished_in(files / "killed/journal.txt"), lines_of(files / "whole/evaluations.csv") - 1)
      << "no finished evaluation was repeated";

  const std::string before = test::read_text(files / "killed/run.json");
  const Finished again = run_program(resume);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.out, AllOf(HasSubstr("there is nothing to resume"), HasSubstr("--warm-start")));
  EXPECT_EQ(test::read_text(files / "killed/run.json"), before);
}

TEST(Resume, ANativeSearchKilledInItsLastStepsEndsAsIfItHadNotBeen) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         test::kShortNativeSearch);
  ASSERT_EQ(run_program({"tune", files.path(), "--no-analysis", "--out", files / "whole"}).exit_code, 0);
  run_and_kill({"tune", files.path(), "--no-analysis", "--out", files / "killed"},
               files / "killed/journal.txt", 19);
  EXPECT_THAT(test::read_text(files / "killed/journal.txt"), HasSubstr("\tverify\t")) << "in its last steps";
  ASSERT_EQ(run_program({"tune", "--resume", files / "killed"}).exit_code, 0);
  expect_same_run(files / "whole", files / "killed", {"gains.yaml", "errors.csv", "study.yaml"});
  EXPECT_EQ(finished_in(files / "killed/journal.txt"), lines_of(files / "whole/evaluations.csv") - 1);
}

TEST(Resume, AnInterruptedNativeSearchLeavesSimbodysFigures) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                         test::kShortNativeSearch);
  const test::TemporaryFolder folder;
  Program program({"tune", files.path(), "--no-analysis", "--out", files / "run"}, folder.path());
  while (program.running() && finished_in(files / "run/journal.txt") < 6) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  program.interrupt();
  const Finished ended = program.wait();
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_THAT(test::read_text(files / "run/gains.yaml"), testing::Not(HasSubstr("not yet simulated")));
  ASSERT_EQ(run_program({"simulate", files / "short.yaml", files / "short_realistic.yaml", "--gains",
                         files / "run/gains.yaml", "--out", files / "again"})
                .exit_code,
            0);
  EXPECT_EQ(test::read_text(files / "run/errors.csv"), test::read_text(files / "again/errors.csv"));
}

// What was recorded is recalled first, whenever the signal comes: files never hold less than before.
TEST(Resume, AnInterruptWhileItRecallsLosesNothing) {
  const ShortStudy files;
  run_and_kill({"tune", files.path(), "--no-analysis", "--out", files / "run"}, files / "run/journal.txt", 8);
  const std::size_t finished = finished_in(files / "run/journal.txt");
  const test::TemporaryFolder folder;
  for (const int wait : {0, 10, 20, 30, 40, 60}) {
    Program program({"tune", "--resume", files / "run", "--workers", "1"}, folder.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(wait));
    program.interrupt();
    const Finished ended = program.wait();
    // Before the program listens to signals one ends it, and nothing was touched. On a busy machine the run
    // may end before the signal arrives.
    EXPECT_THAT(ended.exit_code, testing::AnyOf(0, 130, -1)) << ended.err;
    if (ended.exit_code != -1) {
      EXPECT_GE(lines_of(files / "run/evaluations.csv"), finished + 1) << wait;
    }
  }
  ASSERT_EQ(run_program({"tune", files.path(), "--no-analysis", "--out", files / "whole"}).exit_code, 0);
  ASSERT_EQ(run_program({"tune", "--resume", files / "run"}).exit_code, 0);
  expect_same_run(files / "whole", files / "run", {"gains.yaml", "errors.csv"});
}

TEST(Resume, AWarmStartIsThereFromTheFirstMoment) {
  const ShortStudy files;
  std::string warm = test::read_text(files / "gains.yaml");
  const std::string own = "slerpDurationErrorGain: 2.5";
  ASSERT_NE(warm.find(own), std::string::npos);
  warm.replace(warm.find(own), own.size(), "slerpDurationErrorGain: 2.2");
  files.write("warm.yaml", warm);
  const auto with = [&files](const std::string& folder) {
    return std::vector<std::string>{
        "tune", files.path(), "--no-analysis", "--warm-start", files / "warm.yaml", "--out", folder};
  };
  ASSERT_EQ(run_program(with(files / "whole")).exit_code, 0);
  run_and_kill(with(files / "killed"), files / "killed/journal.txt", 1);
  fs::remove(files / "warm.yaml");
  const Finished ended = run_program({"tune", "--resume", files / "killed"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  expect_same_run(files / "whole", files / "killed", {"gains.yaml", "errors.csv", "start/warm_gains.yaml"});
}

TEST(Resume, AFrontKilledEndsAsIfItHadNotBeen) {
  const ShortStudy files;
  const std::vector<std::string> begin = {"pareto", files.path(), "--levels", "2", "--max-evaluations", "24"};
  auto with = [&begin](const std::string& folder) {
    auto all = begin;
    all.insert(all.end(), {"--out", folder});
    return all;
  };
  ASSERT_EQ(run_program(with(files / "whole")).exit_code, 0);
  run_and_kill(with(files / "killed"), files / "killed/journal.txt", 9);
  ASSERT_EQ(run_program({"pareto", "--resume", files / "killed"}).exit_code, 0);
  expect_same_run(files / "whole", files / "killed", {"pareto.csv", "study.yaml", "points/01.yaml"});
}

TEST(Resume, SamplesOfAKilledRunAreNotDrawnAgain) {
  const ShortStudy files;
  const std::vector<std::string> begin = {"robustness",
                                          files / "gains.yaml",
                                          "--scenarios",
                                          files / "short.yaml",
                                          files / "short_realistic.yaml",
                                          "--samples",
                                          "9",
                                          "--seed",
                                          "4"};
  auto with = [&begin](const std::string& folder) {
    auto all = begin;
    all.insert(all.end(), {"--out", folder});
    return all;
  };
  ASSERT_EQ(run_program(with(files / "whole")).exit_code, 0);
  run_and_kill(with(files / "killed"), files / "killed/journal.txt", 4);
  const Finished ended = run_program({"robustness", "--resume", files / "killed"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("resuming after "));
  for (const char* file : {"/samples.csv", "/summary.csv"}) {
    EXPECT_EQ(test::read_text(files / "whole" + file), test::read_text(files / "killed" + file)) << file;
  }
  EXPECT_EQ(finished_in(files / "killed/journal.txt"), 9U);
}

TEST(Resume, RefusesWhatIsNotTheSameRun) {
  const ShortStudy files;
  run_and_kill({"tune", files.path(), "--no-analysis", "--out", files / "run"}, files / "run/journal.txt", 2);
  const auto refusal = [](const std::vector<std::string>& arguments) {
    const Finished ended = run_program(arguments);
    EXPECT_EQ(ended.exit_code, 2) << ended.out;
    return ended.err;
  };
  EXPECT_THAT(refusal({"tune", "--resume", files / "nowhere"}),
              HasSubstr("nowhere/journal.txt: cannot be read"));
  EXPECT_THAT(refusal({"pareto", "--resume", files / "run"}), HasSubstr("was started by 'armtune tune"));
  EXPECT_THAT(refusal({"tune", "--resume", files / "run", "--seed", "4"}),
              HasSubstr("'--seed' cannot be changed"));

  const std::string study = test::read_text(files.path());
  std::string other = study;
  other.replace(other.find("max_evaluations: 12"), 19, "max_evaluations: 13");
  files.write("study.yaml", other);
  EXPECT_THAT(
      refusal({"tune", "--resume", files / "run"}),
      AllOf(HasSubstr("study was '"), HasSubstr("max_evaluations: 12"), HasSubstr("max_evaluations: 13")));
  files.write("study.yaml", study);

  files.write("short.yaml", "base: moving_target\nduration: 8.5\n");
  EXPECT_THAT(refusal({"tune", "--resume", files / "run"}), HasSubstr("short.yaml was 'fnv1a-"));
  files.write("short.yaml", "base: moving_target\nduration: 8\n");

  std::string journal = test::read_text(files / "run/journal.txt");
  journal[journal.find("finished\t0\t") + 20] ^= 1;
  files.write("run/journal.txt", journal);
  EXPECT_THAT(refusal({"tune", "--resume", files / "run"}), HasSubstr("record 0 is damaged"));
}

/// The only file in the run's inputs/ whose name ends so.
std::string copy_of(const std::string& run, const std::string& name) {
  std::vector<std::string> found;
  if (fs::exists(run + "/inputs")) {
    for (const auto& file : fs::directory_iterator(run + "/inputs")) {
      if (file.path().filename().string().ends_with("_" + name)) found.push_back(file.path().string());
    }
  }
  EXPECT_EQ(found.size(), 1U) << name;
  return found.empty() ? std::string() : found.front();
}

TEST(Resume, AnInputEditedAfterAKillCanBePutBackFromItsCopy) {
  const ShortStudy files;
  const std::string run = files / "run";
  const std::vector<std::string> command = {"tune", files.path(), "--no-analysis"};
  const auto with = [&](const std::string& folder) {
    auto all = command;
    all.insert(all.end(), {"--out", folder});
    return all;
  };
  run_and_kill(with(run), run + "/journal.txt", 2);
  const std::string before = test::read_text(files / "short.yaml");
  const std::string copy = copy_of(run, "short.yaml");
  ASSERT_EQ(test::read_text(copy), before);
  const std::vector<std::string> resume = {"tune", "--resume", run};

  files.write("short.yaml", "base: moving_target\nduration: 8.5\n");
  const Finished edited = run_program(resume);
  EXPECT_EQ(edited.exit_code, 2) << edited.err;
  EXPECT_THAT(edited.err, AllOf(HasSubstr(files / "short.yaml"), HasSubstr(copy)));

  for (const char* name : {"short.yaml", "gains.yaml", "study.yaml"}) {  // broken, then gone
    const std::string kept = test::read_text(name == std::string("short.yaml") ? copy : files / name);
    files.write(name, "neither: this\n");
    const Finished broken = run_program(resume);
    EXPECT_EQ(broken.exit_code, 2) << name;
    EXPECT_THAT(broken.err, AllOf(HasSubstr(name), HasSubstr(run + "/inputs"))) << name;
    fs::remove(files / name);
    const Finished gone = run_program(resume);
    EXPECT_EQ(gone.exit_code, 2) << name;
    EXPECT_THAT(gone.err, AllOf(HasSubstr(name), HasSubstr(run + "/inputs"))) << name;
    ASSERT_EQ(test::read_text(copy_of(run, name)), kept) << name;
    fs::copy_file(copy_of(run, name), files / name);
  }
  ASSERT_EQ(run_program(resume).exit_code, 0);
  ASSERT_EQ(run_program(with(files / "whole")).exit_code, 0);
  expect_same_run(files / "whole", run, {"gains.yaml", "errors.csv"});
  for (const auto& file : fs::directory_iterator(files / "whole/inputs")) {
    const std::string name = file.path().filename().string();
    EXPECT_EQ(test::read_text(file.path().string()), test::read_text(run + "/inputs/" + name)) << name;
  }
}

TEST(Resume, EveryCommandWithAJournalKeepsItsInputsFromTheBeginning) {
  const ShortStudy files;
  run_and_kill({"pareto", files.path(), "--levels", "2", "--max-evaluations", "24", "--out", files / "front"},
               files / "front/journal.txt", 1);
  run_and_kill({"robustness", files / "gains.yaml", "--scenarios", files / "short.yaml", "--samples", "9",
                "--out", files / "samples"},
               files / "samples/journal.txt", 1);
  for (const char* run : {"front", "samples"}) {
    for (const char* name : {"short.yaml", "gains.yaml", "ur10.urdf"})
      EXPECT_NE(test::read_text(copy_of(files / run, name)), "") << run;
  }
  EXPECT_EQ(test::read_text(copy_of(files / "front", "study.yaml")), test::read_text(files.path()));
}

TEST(Resume, NeverWritesThroughALinkInTheRunsFolder) {
  const ShortStudy files;
  const std::string run = files / "run";
  run_and_kill({"tune", files.path(), "--no-analysis", "--out", run}, run + "/journal.txt", 2);
  const std::string input = fs::path(copy_of(run, "gains.yaml")).filename().string();
  fs::create_directory(files / "elsewhere");
  files.write("elsewhere/file", "not the run's\n");
  const auto outside = [&files] {
    std::string all;
    for (const auto& file : fs::recursive_directory_iterator(files / "elsewhere"))
      all += file.path().string() + test::read_text(file.path().string());
    return all;
  };
  const std::string before = outside();
  for (const std::string& name :
       {std::string("errors.csv"), std::string("start"), std::string("inputs"), "inputs/" + input,
        std::string("start/errors.csv"), std::string("evaluations.csv"), std::string("journal.txt")}) {
    const bool is_there = fs::exists(run + "/" + name);
    if (is_there) fs::rename(run + "/" + name, files / "aside");
    const bool folder = name == "start" || name == "inputs";
    if (folder && is_there)
      for (const auto& file : fs::directory_iterator(files / "aside"))
        fs::copy_file(file.path(), files / "elsewhere" / file.path().filename());
    const std::string there = outside();
    fs::create_symlink(folder ? files / "elsewhere" : files / "elsewhere/file", run + "/" + name);
    const Finished refused = run_program({"tune", "--resume", run});
    EXPECT_EQ(refused.exit_code, 2) << name << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(run + "/" + name));
    EXPECT_EQ(outside(), there) << name;
    fs::remove(run + "/" + name);
    if (is_there) fs::rename(files / "aside", run + "/" + name);
    for (const auto& file : fs::directory_iterator(files / "elsewhere"))
      if (file.path().filename() != "file") fs::remove(file.path());
  }
  EXPECT_EQ(outside(), before);
  const Finished ended = run_program({"tune", "--resume", run});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

TEST(Resume, SamplesKeepToTheOrderOfTheirScenarios) {
  const ShortStudy files;
  // The folder stands for a run: its gains.yaml, and the scenarios of its study.yaml.
  run_and_kill({"robustness", files / "", "--samples", "9", "--out", files / "run"},
               files / "run/journal.txt", 2);
  std::string study = test::read_text(files.path());
  const std::string order = "[short.yaml, short_realistic.yaml]";
  study.replace(study.find(order), order.size(), "[short_realistic.yaml, short.yaml]");
  files.write("study.yaml", study);
  const Finished refused = run_program({"robustness", "--resume", files / "run"});
  EXPECT_EQ(refused.exit_code, 2) << refused.out;
  EXPECT_THAT(refused.err, HasSubstr("scenarios was 'short', is 'short_realistic'"));
}

TEST(Resume, AnInterruptedRunSaysHowToGoOn) {
  const ShortStudy files;
  const test::TemporaryFolder folder;
  Program program({"tune", files.path(), "--no-analysis", "--out", files / "run"}, folder.path());
  while (program.running() && finished_in(files / "run/journal.txt") < 3) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  program.interrupt();
  const Finished ended = program.wait();
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_THAT(ended.out, HasSubstr("tune --resume " + (files / "run")));
  ASSERT_EQ(run_program({"tune", files.path(), "--no-analysis", "--out", files / "whole"}).exit_code, 0);
  ASSERT_EQ(run_program({"tune", "--resume", files / "run"}).exit_code, 0);
  expect_same_run(files / "whole", files / "run", {"gains.yaml", "errors.csv"});
}

}  // namespace resume_test
}  // namespace armtune::internal

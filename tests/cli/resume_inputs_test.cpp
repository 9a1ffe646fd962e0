// A run resumes only from the inputs that it began with, and keeps copies of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/support/killed_run.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace resume_inputs_test {

namespace fs = std::filesystem;
using test::expect_same_run;
using test::Finished;
using test::run_and_kill;
using test::run_program;
using test::ShortStudy;
using testing::AllOf;
using testing::HasSubstr;

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

}  // namespace resume_inputs_test
}  // namespace armtune::internal

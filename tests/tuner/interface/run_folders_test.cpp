// Folders, verdicts and records of runs that a program makes through the interface.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armtune/error.hpp"
#include "armtune/robustness.hpp"
#include "armtune/run_record.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/run/run_record.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune {
namespace run_folders_test {

using internal::test::read_text;
using internal::test::refused_at;
using testing::IsSupersetOf;

/// A scenario of 8 s in a file, and gains for it.
struct Example {
  internal::test::ShortStudy files = internal::test::ShortStudy();
  Scenario scenario = Scenario::load(files / "short.yaml");
  Gains gains = Gains::load(files / "gains.yaml", scenario.robot());
};

TEST(FolderOfSimulate, HasTheResultsThatTheCallReturns) {
  const Example example;
  SimulateOptions options;
  options.engine = Engine::kNative;
  const Simulated bare = simulate({example.scenario}, example.gains, options);
  options.folder = example.files / "run";
  const Simulated kept = simulate({example.scenario}, example.gains, options);
  EXPECT_TRUE(bare.files.empty());
  EXPECT_THAT(kept.files, IsSupersetOf({"errors.csv", "gains.yaml", "run.json", "verdict.yaml"}));
  EXPECT_EQ(read_text(options.folder + "/errors.csv"), errors_csv(bare.rollouts));
  EXPECT_EQ(errors_csv(kept.rollouts), errors_csv(bare.rollouts));
  ASSERT_GT(bare.rollouts[0].rows(), 100U);
  EXPECT_TRUE(std::ranges::equal(kept.rollouts[0].values(), bare.rollouts[0].values()));
  EXPECT_FALSE(read_text(options.folder + "/rollout_short.csv").empty());
  EXPECT_EQ(Gains::load(options.folder + "/gains.yaml", example.scenario.robot()).text(),
            example.gains.text());
  ASSERT_FALSE(bare.verdict.checks.empty());
  EXPECT_EQ(to_text(bare.verdict), to_text(kept.verdict)) << "the task and the arm give no cause for a note";
  EXPECT_EQ(read_text(options.folder + "/verdict.yaml"), internal::verdict_yaml(kept.verdict));
}

TEST(FolderOfSimulate, IsOnlyForFilesRecordingsAndOneGainSet) {
  const Example example;
  SimulateOptions options;
  options.engine = Engine::kNative;
  options.folder = example.files.write("taken", "a file");
  EXPECT_THROW(simulate({example.scenario}, example.gains, options), InputError);
  options.folder = example.files / "run";
  EXPECT_THAT([&] { return simulate_sets({example.scenario}, {example.gains}, options); },
              refused_at({.key = "folder"}));
  Scenario changed = example.scenario;
  changed.set_duration(7.0);
  EXPECT_THAT([&] { return simulate({changed}, example.gains, options); },
              refused_at({.file = options.folder}));
  options.record_every = 0;
  EXPECT_THAT([&] { return simulate({example.scenario}, example.gains, options); },
              refused_at({.key = "record_every", .value = "0", .limit = testing::HasSubstr("1")}));
  EXPECT_FALSE(std::ifstream(options.folder + "/run.json").good());
}

TEST(FolderOfMargins, HasTheMarginsGainsAndVerdictThatTheCallReturns) {
  const Example example;
  MarginsOptions options;
  options.engine = Engine::kNative;
  options.folder = example.files / "margins";
  const Margins found = margins({example.scenario}, example.gains, options);
  EXPECT_THAT(found.files, IsSupersetOf({"margins.csv", "gains.yaml", "run.json", "verdict.yaml"}));
  EXPECT_EQ(Gains::load(options.folder + "/gains.yaml", example.scenario.robot()).text(),
            example.gains.text());
  EXPECT_EQ(read_text(options.folder + "/verdict.yaml"), internal::verdict_yaml(found.verdict));
  EXPECT_TRUE(found.verdict.passed());
  ASSERT_EQ(found.verdict.checks.size(), found.margins.size()) << "one scenario";
  for (std::size_t i = 0; i < found.margins.size(); ++i) {
    EXPECT_EQ(found.verdict.checks[i].value, found.margins[i].stands);
    EXPECT_EQ(found.verdict.checks[i].unit, found.margins[i].unit);
  }
  EXPECT_THROW(margins({example.scenario}, example.gains, options), InputError) << "the folder is used";
}

TEST(VerdictOnMargins, FailsWhereTheUnchangedLoopDoes) {
  const Example example;
  Gains wild = example.gains;
  for (double& gain : wild.numbers("task_space_gains_p")) gain *= 100.0;
  MarginsOptions options;
  options.engine = Engine::kNative;
  const Margins found = margins({example.scenario}, wild, options);
  EXPECT_FALSE(found.verdict.passed());
  EXPECT_FALSE(found.interrupted);
  for (const Check& check : found.verdict.checks) {
    EXPECT_FALSE(check.passed);
    EXPECT_EQ(check.scenario, "short");
  }
  const std::atomic<bool> stop{true};
  options.watch.stop = &stop;
  const Margins cut = margins({example.scenario}, wild, options);
  EXPECT_TRUE(cut.interrupted);
  EXPECT_TRUE(cut.verdict.checks.empty());
}

TEST(RecordOfARun, IsThatOfItsFile) {
  const Example example;
  SimulateOptions options;
  options.engine = Engine::kNative;
  options.folder = example.files / "run";
  simulate({example.scenario}, example.gains, options);
  const RunRecord record = run_record(options.folder);
  EXPECT_EQ(record.kind, "simulate");
  EXPECT_EQ(record.workers, 1);
  EXPECT_EQ(record.json, read_text(options.folder + "/run.json"));
  EXPECT_EQ(record.date, internal::find_run_record(options.folder)->date);
  EXPECT_THAT(record.versions, testing::Contains(testing::Key("armtune")));
  const auto input = std::ranges::find(record.inputs, example.files / "short.yaml", &RunInput::path);
  ASSERT_NE(input, record.inputs.end());
  EXPECT_EQ(read_text(options.folder + "/" + input->copy), read_text(input->path));
  EXPECT_THAT([&] { return run_record(example.files / "none"); },
              refused_at({.file = example.files / "none"}));
}

}  // namespace run_folders_test
}  // namespace armtune

#include "tuner/run/run_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "sim/yaml/document.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/run/support/records.hpp"

namespace armtune::internal {
namespace run_record_test {

using testing::HasSubstr;

RunRecord read_back(const RunRecord& run) {
  return parse_run_record(run_record_json(run), "run.json");
}

/// The text of the whole record with one part of it replaced, which is there.
std::string whole_with(const std::string& part, const std::string& by) {
  std::string text = run_record_json(test::whole_record());
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part << " in " << text;
  return text.replace(at, part.size(), by);
}

auto reading(const std::string& text) {
  return [text] { (void)parse_run_record(text, "run.json"); };
}

TEST(RunRecord, EveryMemberReadsBackAsItWas) {
  EXPECT_EQ(read_back(test::whole_record()), test::whole_record());
}

TEST(RunRecord, WithoutAnyOptionalMemberItReadsBackAsItWas) {
  EXPECT_EQ(read_back({}), RunRecord());
  RunRecord parts;  // each part with its own defaults
  parts.simulation.emplace();
  parts.compare.emplace();
  parts.search.emplace();
  parts.tuned.emplace();
  parts.front.emplace();
  parts.robustness.emplace();
  parts.distribution.emplace();
  parts.margins.emplace();
  parts.plan.emplace();
  parts.identification.emplace();
  parts.validation.emplace();
  parts.calibration.emplace();
  parts.excitation.emplace();
  parts.yardstick.emplace();
  EXPECT_EQ(read_back(parts), parts);
}

TEST(RunRecord, EachOptionalPartMayBeTheOnlyOneThatIsMissing) {
  const auto without = [](auto RunRecord::*part) {
    RunRecord run = test::whole_record();
    (run.*part).reset();
    EXPECT_EQ(read_back(run), run);
  };
  without(&RunRecord::simulation);
  without(&RunRecord::compare);
  without(&RunRecord::search);
  without(&RunRecord::tuned);
  without(&RunRecord::front);
  without(&RunRecord::robustness);
  without(&RunRecord::distribution);
  without(&RunRecord::margins);
  without(&RunRecord::plan);
  without(&RunRecord::identification);
  without(&RunRecord::validation);
  without(&RunRecord::calibration);
  without(&RunRecord::excitation);
  without(&RunRecord::yardstick);
}

TEST(RunRecord, EveryWordOfItsEnumerationsReadsBack) {
  RunRecord run = test::whole_record();
  for (int kind = 0; kind <= static_cast<int>(RunKind::kBenchmark); ++kind) {
    run.kind = static_cast<RunKind>(kind);
    EXPECT_EQ(read_back(run).kind, run.kind);
  }
  for (int end = 0; end <= static_cast<int>(SearchEnd::kSolverGaveUp); ++end) {
    run.search->ended = static_cast<SearchEnd>(end);
    EXPECT_EQ(read_back(run).search->ended, run.search->ended);
  }
  for (const Engine engine : kEngines) {
    run.search->engine = engine;
    EXPECT_EQ(read_back(run).search->engine, engine);
  }
  for (const Stepper stepper : kSteppers) {
    run.search->stepper = stepper;
    EXPECT_EQ(read_back(run).search->stepper, stepper);
  }
}

TEST(RunRecord, ANumberThatIsNotFiniteIsMissing) {
  for (const double value : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    RunRecord run = test::whole_record();
    run.front->hypervolume = value;
    run.identification->condition_number = value;
    run.plan->between_knots[0].share = value;
    const RunRecord read = read_back(run);
    EXPECT_EQ(read.front->hypervolume, std::nullopt);
    EXPECT_EQ(read.identification->condition_number, std::nullopt);
    EXPECT_EQ(read.plan->between_knots[0].share, std::nullopt);
  }
}

TEST(RunRecord, AnotherFormatIsRefusedBeforeItsKeysAre) {
  std::string text = whole_with("\"format\": 1", "\"format\": 2");
  text.replace(text.find("\"kind\""), 6, "\"of what kind\"");
  EXPECT_THAT(reading(text),
              test::refused_at({.file = "run.json", .line = 2, .key = "format", .value = "2", .limit = "1"}));
}

TEST(RunRecord, ValuesOfAnotherTypeAreRefusedWithTheirPlace) {
  EXPECT_THAT(reading(whole_with("\"workers\": 3", "\"workers\": \"3\"")),
              test::refused_at({.file = "run.json", .line = 8, .key = "workers"}));
  EXPECT_THAT(reading(whole_with("\"workers\": 3", "\"workers\": 99999999999")),
              test::refused_at({.file = "run.json", .line = 8, .key = "workers"}));
  EXPECT_THAT(reading(whole_with("\"seed\": 9007199254740993", "\"seed\": -1")),
              test::refused_at({.file = "run.json", .line = 7, .key = "seed"}));
  EXPECT_THAT(reading(whole_with("\"kind\": \"pareto\"", "\"kind\": \"tuned\"")),
              test::refused_at({.file = "run.json", .line = 3, .key = "kind", .value = "tuned"}));
  EXPECT_THAT(reading(whole_with("\"points\": 49", "\"points\": [49]")),
              test::refused_at({.file = "run.json", .key = "front/points"}));
  EXPECT_THAT(reading(whole_with("\"command\": ", "\"comand\": ")), test::refused_at({.file = "run.json"}));
  EXPECT_THAT(reading(whole_with("\"relation\": \"at_most\"", "\"relation\": \"about\"")),
              test::refused_at({.file = "run.json", .key = "robustness/limits/0/relation"}));
}

TEST(RunRecord, TextThatIsNoRecordIsRefused) {
  for (const char* text : {"", "[]", "1", "null", "{", "{\"format\": 1}", "{\"format\": {}}", "\xff"})
    EXPECT_THAT(reading(text), test::refused_at({.file = "run.json"})) << text;
  const std::string whole = run_record_json(test::whole_record());
  for (std::size_t end = 0; end + 2 < whole.size(); end += 7)  // without its last brace
    EXPECT_THAT(reading(whole.substr(0, end)), test::refused_at({.file = "run.json"})) << end;
}

TEST(RunRecord, TextThatIsTooDeepOrTooLongIsRefused) {
  const std::string deep = std::string(yaml::kMaxDepth, '[') + std::string(yaml::kMaxDepth, ']');
  EXPECT_THAT(reading(whole_with("\"points\": 49", "\"points\": " + deep)),
              test::refused_at({.file = "run.json"}));
  EXPECT_THAT(reading(whole_with("armtune pareto", std::string(yaml::kMaxBytes, 'a'))),
              test::refused_at({.file = "run.json"}));
  std::string many;
  for (std::size_t i = 0; i < yaml::kMaxItems; ++i) many += "0,";
  EXPECT_THAT(reading(whole_with("\"objective\", \"gaze/rms\"", many + "0")),
              test::refused_at({.file = "run.json"}));
}

TEST(RunRecord, IsFoundInTheFolderAsItIsNow) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(find_run_record(folder.path()), std::nullopt);
  RunRecord run = test::whole_record();
  folder.write(kRunRecord, run_record_json(run));
  EXPECT_EQ(find_run_record(folder.path()), run);
  run.workers = 8;
  folder.write(kRunRecord, run_record_json(run));
  EXPECT_EQ(find_run_record(folder.path()), run);
  folder.write(kRunRecord, "{}");
  EXPECT_THAT([&] { (void)find_run_record(folder.path()); }, test::refused_at({.file = folder / kRunRecord}));
  std::filesystem::remove(folder / kRunRecord);
  folder.write("elsewhere.json", run_record_json(run));
  std::filesystem::create_symlink(folder / "elsewhere.json", folder / kRunRecord);
  EXPECT_THAT([&] { (void)find_run_record(folder.path()); }, test::refused_at({.file = folder / kRunRecord}));
}

TEST(RunRecord, NamesTheVersionOfArmtune) {
  EXPECT_EQ(armtune_version(test::whole_record()), "0.1.0");
  EXPECT_EQ(armtune_version({}), "");
}

}  // namespace run_record_test
}  // namespace armtune::internal

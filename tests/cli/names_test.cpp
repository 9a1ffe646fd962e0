// Names of scenarios and gain sets, and the files that are called after them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/common/file_name.hpp"
#include "core/common/utf8.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/yaml/document.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/cli/set_labels.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace names_test {

namespace fs = std::filesystem;
using test::Finished;
using test::run_program;
using test::ShortStudy;
using testing::HasSubstr;

/// True if no line commands a terminal.
bool is_harmless(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return is_printable(text);
}

TEST(Names, ThatNoFileOfResultsCouldHaveAreRefusedBeforeAnythingIsSimulated) {
  const ShortStudy files;
  const std::string run = files / "run";
  for (const std::string& name :
       {std::string(kLongestName + 1, 'n'), std::string(240, 'n'), std::string("a\x1b[31mred"),
        std::string("a\x7f"), std::string("a\rb"), std::string("a\xC2\x85 x: 1"),
        std::string("a\xE2\x80\xA8x: 1"), std::string("caf\xE9")}) {
    const std::string scenario = files / (name + ".yaml");
    const std::string gains = files / ("g" + name + ".yaml");
    fs::copy_file(files / "short.yaml", scenario);
    fs::copy_file(files / "gains.yaml", gains);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"simulate", scenario, "--gains", files / "gains.yaml", "--out", run},
          {"compare", gains, files / "gains.yaml", "--scenarios", files / "short.yaml", "--out", run},
          {"robustness", files / "gains.yaml", "--samples", "1", "--scenarios", scenario, "--out", run}}) {
      const Finished done = run_program(command);
      EXPECT_EQ(done.exit_code, 2) << command.front() << testing::PrintToString(name) << done.err;
      EXPECT_THAT(done.err, HasSubstr("rename"));
      EXPECT_TRUE(is_harmless(done.err)) << testing::PrintToString(done.err);
      EXPECT_FALSE(fs::exists(run));
    }
  }
}

TEST(Names, NoScenarioHasTheNameOfAllOfThem) {
  const ShortStudy files;
  fs::copy_file(files / "short.yaml", files / "all.yaml");
  const Finished done = run_program({"margins", files / "gains.yaml", "--scenarios", files / "all.yaml"});
  EXPECT_EQ(done.exit_code, 2) << done.err;
  EXPECT_THAT(done.err, testing::AllOf(HasSubstr("all.yaml"), HasSubstr("rename")));
}

TEST(Names, InWarningsCommandNoTerminal) {
  testing::internal::CaptureStderr();
  cli::print_warning("scenario \x1b[31mx\nis not there");
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_THAT(text, HasSubstr("is not there"));
  EXPECT_TRUE(is_harmless(text)) << testing::PrintToString(text);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

TEST(Names, TheLongestThatIsAcceptedServesForEveryFile) {
  const ShortStudy files;
  const std::string scenario = files / (std::string(kLongestName, 's') + ".yaml");
  const std::string gains = files / (std::string(kLongestName, 'g') + ".yaml");
  fs::copy_file(files / "short.yaml", scenario);
  fs::copy_file(files / "gains.yaml", gains);
  const std::string study = files / (std::string(kLongestName, 't') + ".yaml");
  std::string text = test::read_text(files.path());
  const std::string named = "scenarios: [short.yaml, short_realistic.yaml]";
  text.replace(text.find(named), named.size(), "scenarios: [" + scenario + ", short_realistic.yaml]");
  const std::string of_one = "scenarios: [short]";
  text.replace(text.find(of_one), of_one.size(), "scenarios: [" + std::string(kLongestName, 's') + "]");
  files.write(fs::path(study).filename().string(), text);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"simulate", scenario, "--gains", gains, "--out", files / "simulated"},
        {"compare", gains, files / "gains.yaml", "--scenarios", scenario, "--out", files / "compared"},
        {"robustness", gains, "--samples", "1", "--scenarios", scenario, "--out", files / "robust"},
        {"tune", study, "--no-analysis"}}) {
    const Finished done = test::Program(command, files / "").wait();
    EXPECT_THAT(done.exit_code, testing::AnyOf(0, 3)) << command.front() << done.err;
    EXPECT_THAT(done.err, testing::Not(HasSubstr("too long")));
  }
}

TEST(Names, OfComparedSetsAreAllDifferent) {
  EXPECT_THAT(cli::set_labels({"p/a", "p/a_3", "q/a"}), testing::ElementsAre("a", "a_3", "a_2"));
  EXPECT_THAT(cli::set_labels({"p/a_2", "p/a", "q/a/", "r/a.yaml"}),
              testing::ElementsAre("a_2", "a", "a_3", "a_4"));
  EXPECT_THAT(cli::set_labels({"scenario.yaml", "metric.yaml", "unit"}),
              testing::ElementsAre("scenario_2", "metric_2", "unit_2"))
      << "comparison.csv has columns of these names";
  const std::string here = fs::current_path().filename().string();
  EXPECT_THAT(cli::set_labels({"p/a//", "p/b/.", "p/c/../d"}), testing::ElementsAre("a", "b", "d"));
  EXPECT_THAT(cli::set_labels({"."}), testing::ElementsAre(here));
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "real/start");
  std::filesystem::create_directory_symlink(folder / "real/start", folder / "link");
  EXPECT_THAT(cli::set_labels({folder / "link/.."}), testing::ElementsAre("real"));
  std::vector<std::string> sets;
  for (int i = 0; i < 40; ++i)
    sets.push_back(std::to_string(i) + "/a" + (i % 3 == 0 ? "" : "_" + std::to_string(i)));
  auto labels = cli::set_labels(sets);
  std::sort(labels.begin(), labels.end());
  EXPECT_EQ(std::adjacent_find(labels.begin(), labels.end()), labels.end());
}

TEST(Names, OfComparedSetsThatAreTooLongWithTheirNumberAreToldOfAsTheyAre) {
  const ShortStudy files;
  const std::string name(kLongestName, 'g');
  for (const char* folder : {"p", "q"}) {
    fs::create_directory(files / folder);
    fs::copy_file(files / "gains.yaml", files / (folder + ("/" + name) + ".yaml"));
  }
  const Finished done =
      run_program({"compare", files / ("p/" + name + ".yaml"), files / ("q/" + name + ".yaml"), "--scenarios",
                   files / "short.yaml", "--out", files / "run"});
  EXPECT_EQ(done.exit_code, 2) << done.err;
  EXPECT_THAT(done.err, testing::AllOf(HasSubstr("/q/" + name), HasSubstr("'_2'"), HasSubstr("198 bytes"),
                                       testing::Not(HasSubstr("202 bytes"))));
  EXPECT_FALSE(fs::exists(files / "run"));
}

TEST(Names, OfComparedSetsGiveEachItsOwnFilesAndColumns) {
  const ShortStudy files;
  for (const char* folder : {"p", "q"}) fs::create_directory(files / folder);
  for (const char* set : {"p/a.yaml", "p/a_3.yaml", "q/a.yaml"})
    fs::copy_file(files / "gains.yaml", files / set);
  const Finished done = run_program({"compare", files / "p/a.yaml", files / "p/a_3.yaml", files / "q/a.yaml",
                                     "--scenarios", files / "short.yaml", "--out", files / "run"});
  EXPECT_THAT(done.exit_code, testing::AnyOf(0, 3)) << done.err;
  const CsvTable table = CsvTable::read(files / "run/comparison.csv");  // refuses two columns of one name
  EXPECT_THAT(table.header(), testing::IsSupersetOf({"a", "a_3", "a_2"}));
  for (const char* set : {"a", "a_3", "a_2"}) {
    EXPECT_TRUE(fs::exists(files / "run/rollouts_" + set + "/rollout_short.csv")) << set;
    EXPECT_TRUE(fs::exists(files / "run/errors_" + set + ".csv")) << set;
  }
}

TEST(Names, InAHostileRecordStayInTheCommentsOfWhatIsExported) {
  const ShortStudy files;
  ASSERT_EQ(
      run_program({"simulate", files / "short.yaml", "--gains", files / "gains.yaml", "--out", files / "run"})
          .exit_code,
      0);
  RunRecord run = find_run_record(files / "run").value();
  run.search.emplace().study =
      std::string("x\xE2\x80\xA8injected: 1\xC2\x85injected: 2\r\n\ninjected: 3\x1b[31m") + '\0';
  run.inputs.push_back({"a\xE2\x80\xA9injected: 4", "b\rinjected: 5", ""});
  files.write("run/run.json", run_record_json(run));
  const std::vector<std::string> robot = {"--robot", "ur10"};
  for (const char* format : {"yaml", "ros1", "ros2"}) {
    const Finished done = run_program({"export", files / "run", "--robot", "ur10", "--format", format});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_THAT(done.out, HasSubstr("injected"));
    EXPECT_TRUE(is_harmless(done.out)) << done.out;
    EXPECT_THAT(done.out, testing::Not(testing::ContainsRegex("\ninjected")));
  }
}

}  // namespace names_test
}  // namespace armtune::internal

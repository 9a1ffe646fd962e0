// A run folder that somebody else has made: its page holds nothing from outside of it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/tuner/report/support/written_run.hpp"
#include "tuner/journal/journal.hpp"
#include "tuner/report/run_report.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::report {
namespace untrusted_folder_test {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using test::write_run;
using testing::Contains;
using testing::HasSubstr;

constexpr const char* kSecret = "secret_from_outside";

/// A kind of file in a run folder, and what must be away for the page to need it.
struct Kind {
  const char* file;
  std::vector<const char*> without;
};

const std::vector<Kind> kKinds = {{"scene.json", {}},
                                  {"errors.csv", {}},
                                  {"robust_errors.csv", {}},
                                  {"rollout_only.csv", {}},
                                  {"run.json", {}},
                                  {"study.yaml", {}},
                                  {"verdict.yaml", {}},
                                  {"journal.txt", {}},
                                  {"gains.yaml", {}},
                                  {"evaluations.csv", {}},
                                  {"sensitivity.csv", {}},
                                  {"margins.csv", {}},
                                  {"yardstick.csv", {}},
                                  {"pareto.csv", {}},
                                  {"samples.csv", {}},
                                  {"motion.csv", {"errors.csv"}},
                                  {"limits.csv", {"errors.csv"}}};

class UntrustedFolder : public testing::TestWithParam<Kind> {
 protected:
  UntrustedFolder() {
    fs::create_directories(files_ / "run");
    fs::create_directories(files_ / "outside");
    const TemporaryFolder made;
    write_run(made, {"only"}, {{"gains", ".", "errors.csv"}}, 1, 20);
    made.write("study.yaml",
               "parameters: [{name: a, start: 1, lower: 0, upper: 2, scale: log}]\nobjective: []\n");
    if (std::string(GetParam().file) == "limits.csv") made.write("motion.csv", "time\n0\n1\n");
    for (const auto& entry : fs::directory_iterator(made.path()))
      fs::copy(entry.path(), files_ / ("run/" + entry.path().filename().string()));
    for (const char* name : GetParam().without) fs::remove(files_ / (std::string("run/") + name));
    fs::remove(file_);
  }
  /// Files of the page that could not be used, one a line.
  std::string left_out(std::string* page = nullptr) const {
    const ReportData data = report_of(files_ / "run");
    if (page != nullptr) *page = report_json(data);
    std::string lines;
    for (const std::string& why : data.left_out) lines += why + '\n';
    return lines;
  }

  TemporaryFolder files_;
  std::string file_ = files_ / (std::string("run/") + GetParam().file);
};

TEST_P(UntrustedFolder, FollowsNoLinkInPlaceOfAFile) {
  files_.write("outside/file", std::string("a,b\n") + kSecret + ",1\n");
  fs::create_symlink(files_ / "outside/file", file_);
  std::string page;
  EXPECT_THAT(left_out(&page), HasSubstr(file_));
  EXPECT_THAT(page, testing::Not(HasSubstr(kSecret)));
}

TEST_P(UntrustedFolder, DoesNotWaitForAPipeInPlaceOfAFile) {
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  EXPECT_THAT(left_out(), HasSubstr(file_));
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, UntrustedFolder, testing::ValuesIn(kKinds), [](const auto& kind) {
  std::string name = kind.param.file;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == '_'; }, 'X');
  return name;
});

class UntrustedName : public testing::Test {
 protected:
  UntrustedName() {
    fs::create_directories(files_ / "outside");
    fs::create_directories(files_ / "run/rollout_");  // without which the name would lead nowhere
    const TemporaryFolder made;
    write_run(made, {"only"}, {{"gains", ".", "errors.csv"}}, 1, 20);
    fs::copy(made / "rollout_only.csv", files_ / "outside/secret.csv");
    fs::copy(made / "errors.csv", files_ / "run/errors.csv");
    fs::copy(made / "scene.json", files_ / "run/scene.json");
  }
  void expect_nothing_from_outside() const {
    const ReportData data = report_of(files_ / "run");
    for (const ReportScenario& scenario : data.scenarios) EXPECT_TRUE(scenario.runs.empty()) << scenario.name;
    EXPECT_THAT(data.left_out, Contains(HasSubstr("outside/secret")));
  }

  TemporaryFolder files_;
  const std::string name_ = "/../../outside/secret";
};

TEST_F(UntrustedName, OfAScenarioInTheSceneLeadsNowhere) {
  Scene scene = read_scene(files_ / "run/scene.json");
  scene.scenarios.front().name = name_;
  files_.write("run/scene.json", scene_json(scene));
  expect_nothing_from_outside();
}

TEST_F(UntrustedName, OfAScenarioInErrorsLeadsNowhere) {
  fs::remove(files_ / "run/scene.json");
  ScenarioResult result;
  result.scenario = name_;
  files_.write("run/errors.csv", errors_csv({result}));
  expect_nothing_from_outside();
}

TEST_F(UntrustedName, OfASetInAComparisonLeadsNowhere) {
  fs::remove(files_ / "run/scene.json");
  fs::create_directories(files_ / "run/rollouts_");
  RunRecord run;
  run.kind = RunKind::kCompare;
  run.compare = {{name_}};
  files_.write("run/run.json", run_record_json(run));
  fs::rename(files_ / "run/errors.csv", files_ / "run/errors_.csv");
  const ReportData data = report_of(files_ / "run");
  EXPECT_TRUE(data.tables.empty());
  EXPECT_THAT(data.left_out, Contains(HasSubstr("outside/secret")));
}

}  // namespace untrusted_folder_test
}  // namespace armtune::internal::report

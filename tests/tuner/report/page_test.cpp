// Whole run folders as pages: what is in them, what is inert in them, how large they are.

#include "tuner/report/page.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "sim/rollout/error_report.hpp"
#include "tests/tuner/report/support/decode.hpp"
#include "tests/tuner/report/support/recorded.hpp"
#include "tests/tuner/report/support/written_run.hpp"
#include "tuner/journal/journal.hpp"
#include "tuner/report/kind_of_folder.hpp"
#include "tuner/report/report.hpp"
#include "tuner/report/run_report.hpp"
#include "tuner/report/tables.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::report {
namespace page_test {

using test::at;
using test::data_of;
using test::kTwoSets;
using test::parsed;
using test::TemporaryFolder;
using test::write_run;
using testing::HasSubstr;

TEST(Page, TakesTheDataInPlaceOfItsMark) {
  EXPECT_EQ(filled_page("<p><!--report-data--></p>", "{\"a\": 1}"),
            "<p><script id=\"report-data\" type=\"application/json\">{\"a\": 1}</script></p>");
  EXPECT_THROW(filled_page("<p></p>", "{}"), std::runtime_error);
  EXPECT_THROW(filled_page("<!--report-data--><!--report-data-->", "{}"), std::runtime_error);
}

TEST(Page, HasItsMarkOnceAndNamesNoPlaceToLoadFrom) {
  if (!available()) GTEST_SKIP() << "built without the page";
  EXPECT_NO_THROW(filled_page(page_text(), "{}"));
  const std::string page(page_text());
  for (const char* loads : {"<link", "src=\"http", "src='http", "href=\"http", "@import", "url(http"}) {
    EXPECT_THAT(page, testing::Not(HasSubstr(loads)));
  }
}

TEST(Page, OfTwoGainSetsOverFourScenariosOfAMinuteIsAtMostSixMegabytes) {
  if (!available()) GTEST_SKIP() << "built without the page";
  const TemporaryFolder folder;
  write_run(folder, {"a", "b", "c", "d"}, kTwoSets, 8);
  const std::size_t size = write_report(folder.path(), folder / "report.html").bytes;
  EXPECT_EQ(size, std::filesystem::file_size(folder / "report.html"));
  EXPECT_LE(size, 6'000'000U);
  const auto data = parsed(data_of(test::read_text(folder / "report.html")));
  EXPECT_EQ(at(data, "scenarios").items().size(), 4U);
  EXPECT_EQ(at(data, "scenarios/3/runs").items().size(), 2U);
  // 700 buckets of two points, two bytes each, and a replay of 64 s at 25 a second: nothing was coarsened.
  EXPECT_EQ(test::base64_bytes(at(data, "scenarios/0/runs/0/time/u16").as_string()).size(), 2800U);
  EXPECT_EQ(at(data, "scenarios/0/runs/0/replay/n").as_integer(), 1600);
}

TEST(Page, OfManyScenariosIsCoarserAndStillAtMostSixMegabytes) {
  if (!available()) GTEST_SKIP() << "built without the page";
  const TemporaryFolder folder;
  std::vector<std::string> names;
  for (int i = 0; i < 40; ++i) names.push_back(fmt::format("scenario_{}", i));
  write_run(folder, names, kTwoSets, 2);
  Scene scene = read_scene(folder / "scene.json");
  // More obstacles and a heavier arm than any estimate thought of.
  for (SceneScenario& s : scene.scenarios) s.obstacles.resize(12, s.obstacles.front());
  ArmShape mesh;
  mesh.kind = ShapeKind::kMesh;
  mesh.triangles = std::string(1'400'000, 'A');
  scene.arms.front().shapes.push_back(mesh);
  folder.write("scene.json", scene_json(scene));
  EXPECT_LE(write_report(folder.path(), folder / "report.html").bytes, 6'000'000U);
}

TEST(Page, ShowsMarkupInNamesAndNeverHoldsIt) {
  const TemporaryFolder folder;
  const std::string evil = "<img src=x onerror=alert(1)>";
  write_run(folder, {"plain"}, {{evil, ".", "errors.csv"}}, 1);
  Scene scene = read_scene(folder / "scene.json");
  scene.arms.front().name = "</script><script>alert(2)</script>";
  folder.write("scene.json", scene_json(scene));
  RunRecord run;
  run.command = "armtune <script>alert(3)</script>";
  folder.write(kRunRecord, run_record_json(run));
  const std::string json = report_json(report_of(folder.path()));
  EXPECT_EQ(json.find('<'), std::string::npos);
  const auto data = parsed(json);
  EXPECT_EQ(at(data, "sets/0").as_string(), evil);
  EXPECT_EQ(at(data, "robots/0/name").as_string(), scene.arms.front().name);
  EXPECT_THAT(at(data, "provenance/command").as_string(), HasSubstr("<script>"));
}

TEST(RunReport, LeavesOutWhatTheFolderDoesNotHold) {
  const TemporaryFolder folder;
  write_run(folder, {"only"}, {{"gains", ".", "errors.csv"}}, 1);
  std::filesystem::remove(folder / "scene.json");
  ReportData data = report_of(folder.path());
  EXPECT_EQ(data.kind, RunKind::kSimulate);
  ASSERT_EQ(data.scenarios.size(), 1U);
  ASSERT_EQ(data.scenarios[0].runs.size(), 1U);
  EXPECT_EQ(data.scenarios[0].runs[0].replay.n, 0U);
  EXPECT_FALSE(data.scenarios[0].runs[0].columns.empty());
  EXPECT_TRUE(data.arms.empty());
  EXPECT_EQ(data.scenarios[0].arm, -1);
  EXPECT_FALSE(data.evaluations || data.front || data.robustness);
  EXPECT_THAT(data.verdict.details, testing::Contains(HasSubstr("scene.json")));
  data.scenarios[0].runs[0].start = 8.25;
  const auto json = parsed(report_json(data));
  EXPECT_EQ(at(json, "scenarios/0/runs/0/start").as_number(), 8.25);
  for (const char* part : {"evaluations", "gains", "sensitivity", "margins", "front", "robustness"}) {
    EXPECT_EQ(json.find(part), nullptr) << part;
  }
  std::filesystem::remove(folder / "rollout_only.csv");
  EXPECT_TRUE(report_of(folder.path()).scenarios[0].runs.empty());
}

TEST(RunReport, KnowsARunByItsFilesAndRefusesWhatIsNone) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { kind_of(folder.path()); }, test::refused_at({.file = folder.path()}));
  EXPECT_THAT([&] { kind_of(folder / "missing"); }, test::refused_at({.file = folder / "missing"}));
  folder.write("errors.csv", "");
  EXPECT_EQ(kind_of(folder.path()), RunKind::kSimulate);
  folder.write("evaluations.csv", "");
  EXPECT_EQ(kind_of(folder.path()), RunKind::kTune);
  folder.write("pareto.csv", "");
  EXPECT_EQ(kind_of(folder.path()), RunKind::kPareto);
  std::filesystem::remove(folder / "pareto.csv");
  RunHeader header;
  header.arguments = {"pareto", "study.yaml"};
  Journal::begin(folder / "journal.txt", header);
  EXPECT_EQ(kind_of(folder.path()), RunKind::kPareto) << "killed before there was a front";
  RunRecord run;
  run.kind = RunKind::kCompare;
  folder.write(kRunRecord, run_record_json(run));
  EXPECT_EQ(kind_of(folder.path()), RunKind::kCompare) << "its record tells it";
  run.kind = RunKind::kMargins;
  folder.write(kRunRecord, run_record_json(run));
  EXPECT_EQ(kind_of(folder.path()), RunKind::kPareto) << "the other files decide: this kind has no page";
  folder.write(kRunRecord, "{");
  EXPECT_EQ(kind_of(folder.path()), RunKind::kPareto) << "the other files decide: the record is damaged";
}

TEST(RunReport, DrawsEveryScenarioWithItsOwnArm) {
  const TemporaryFolder folder;
  write_run(folder, {"one", "two"}, {{"gains", ".", "errors.csv"}}, 1);
  Scene scene = read_scene(folder / "scene.json");
  scene.arms.push_back(scene.arms.front());
  scene.arms[1].tool.p.z() += 0.1;
  scene.scenarios[1].arm = 1;
  folder.write("scene.json", scene_json(scene));
  const ReportData data = report_of(folder.path());
  ASSERT_EQ(data.arms.size(), 2U);
  EXPECT_EQ(data.scenarios[1].arm, 1);
  EXPECT_GT(data.scenarios[1].runs[0].replay.n, 0U);
}

TEST(RunReport, LeavesOutTheFileThatCannotBeUnderstoodAndNamesIt) {
  const TemporaryFolder folder;
  write_run(folder, {"only"}, {{"gains", ".", "errors.csv"}}, 1);
  folder.write("rollout_only.csv", "time,state\n0,zero\n");
  folder.write(kRunRecord, "{\"command\": [");
  const ReportData data = report_of(folder.path());
  ASSERT_EQ(data.left_out.size(), 2U);
  EXPECT_THAT(data.left_out[0], HasSubstr(kRunRecord));
  EXPECT_THAT(data.left_out[1], HasSubstr("rollout_only.csv"));
  EXPECT_THAT(data.verdict.details, testing::Contains("Left out: " + data.left_out[1]));
  EXPECT_EQ(data.tables.size(), 1U) << "the rest is there";
}

TEST(RunReport, OfAnOlderArmtuneSaysSoAndDoesNotCallTheRunUnfinished) {
  const TemporaryFolder folder;
  write_run(folder, {"only"}, kTwoSets, 1);
  folder.write("evaluations.csv", "phase,objective,feasible,violation\nstart,1,1,0\n");
  EXPECT_THAT(report_of(folder.path()).verdict.sentence, HasSubstr("not finished"));
  folder.write(kOldRunRecord, "command: \"armtune tune\"\n");
  const ReportData data = report_of(folder.path());
  EXPECT_THAT(data.verdict.sentence, testing::Not(HasSubstr("not finished")));
  EXPECT_THAT(data.left_out, testing::Contains(HasSubstr(folder / kOldRunRecord)));
}

TEST(RunReport, OfManyArmsNamesNoMomentThatIsNoArms) {
  const TemporaryFolder folder;
  write_run(folder, {"only"}, kTwoSets, 1);
  ScenarioResult worst{"only", {}};
  worst.result.metrics[Metric::kJointVelocityMaxRatio] = 0.9;
  worst.result.metrics[Metric::kJointVelocityMaxRatioTime] = 3.0;
  worst.result.metrics.max_ratio_joint = "elbow_joint";
  folder.write("robust_errors.csv", errors_csv({worst}));
  folder.write("evaluations.csv", "phase,objective,feasible,violation\nstart,1,1,0\n");
  const ReportData data = report_of(folder.path());
  ASSERT_TRUE(data.judged);
  EXPECT_EQ(value_of(data.judged->tables[0], Metric::kJointVelocityMaxRatio, 1), 0.9);
  for (const MetricRow& row : data.judged->tables[0].rows) EXPECT_TRUE(row.text.empty());
}

TEST(RunReport, TellsARunThatEndedEarlyWithItsReason) {
  const TemporaryFolder folder;
  write_run(folder, {"only"}, {{"gains", ".", "errors.csv"}}, 1);
  ScenarioResult result{"only", {}};
  result.result.status = RolloutStatus::kDiverged;
  result.result.reason = "diverged at 4.206 s in followTrajectory: wrist moves at 64, over its limit";
  folder.write("errors.csv", errors_csv({result}));
  const auto run = report_of(folder.path()).scenarios[0].runs[0];
  const CsvTable& table = test::recorded().table;
  EXPECT_EQ(run.reason, result.result.reason);
  EXPECT_EQ(run.end, table.number(table.rows() - 1, table.column("time")));
}

}  // namespace page_test
}  // namespace armtune::internal::report

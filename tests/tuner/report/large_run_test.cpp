// Runs with very much in them: their pages have at most 6 MB, and say what they do not show.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/tuner/report/support/decode.hpp"
#include "tests/tuner/report/support/two_sets.hpp"
#include "tests/tuner/report/support/written_run.hpp"
#include "tuner/report/nearest_obstacles.hpp"
#include "tuner/report/report.hpp"
#include "tuner/report/run_report.hpp"
#include "tuner/report/shorten.hpp"
#include "tuner/rollouts/comparison.hpp"

namespace armtune::internal::report {
namespace large_run_test {

using test::TemporaryFolder;
using test::write_run;
using testing::Contains;
using testing::HasSubstr;

const std::vector<SceneSet> kOneSet = {{"gains", ".", "errors.csv"}};

/// With so many obstacles, one beside the other from the tool's path outwards.
void add_obstacles(const TemporaryFolder& folder, std::size_t count) {
  Scene scene = read_scene(folder / "scene.json");
  for (SceneScenario& s : scene.scenarios) {
    const SceneObstacle like = s.obstacles.front();
    s.obstacles.clear();
    for (std::size_t i = 0; i < count; ++i) {
      s.obstacles.push_back(like);
      s.obstacles.back().path.center.x() += 0.1 * static_cast<double>(i);
    }
  }
  folder.write("scene.json", scene_json(scene));
}

TEST(LargeRun, Of700ObstaclesShowsTheReplayOfAllOfThem) {
  const TemporaryFolder folder;
  write_run(folder, {"only"}, kOneSet, 1);
  add_obstacles(folder, 700);
  const ReportData data = report_of(folder.path());
  ASSERT_EQ(data.scenarios[0].runs.size(), 1U);
  EXPECT_EQ(data.scenarios[0].runs[0].replay.obstacles.size(), 700U);
  EXPECT_EQ(data.scenarios[0].obstacles.size(), 700U);
  EXPECT_GE(data.scenarios[0].runs[0].replay.n, 100U);
  EXPECT_LE(report_json(data).size(), 5'000'000U);
}

TEST(LargeRun, OfManySetsAndObstaclesShowsTheNearestAndSaysHowManyItLeavesOut) {
  const TemporaryFolder folder;
  std::vector<std::string> names;
  for (int i = 0; i < 30; ++i) names.push_back(fmt::format("s{}", i));
  write_run(folder, names, test::kTwoSets, 1, 30);
  add_obstacles(folder, 120);
  const ReportData data = report_of(folder.path());
  EXPECT_LE(report_json(data).size(), 5'000'000U);
  EXPECT_LT(data.scenarios.front().obstacles.size(), 120U);
  std::size_t hidden = 0, scenarios = 0;
  for (const ReportScenario& s : data.scenarios) {
    ASSERT_EQ(s.runs.size(), 2U);
    ASSERT_EQ(s.runs[1].replay.obstacles.size(), s.obstacles.size());
    if (s.obstacles.size() == 120) continue;  // those before have left it enough room
    hidden += 120 - s.obstacles.size();
    ++scenarios;
  }
  ASSERT_GT(scenarios, 1U);
  EXPECT_THAT(
      data.thinned,
      Contains(fmt::format("{} of {} obstacles in the replays of {} scenarios, those farthest from the tool",
                           hidden, 120 * scenarios, scenarios)));
}

TEST(LargeRun, ObstaclesThatComeNearestToTheToolAreKept) {
  const CsvTable& table = test::recorded().table;
  SceneScenario scenario = test::recorded().shown();
  const SceneObstacle like = scenario.obstacles.front();
  scenario.obstacles.clear();
  for (const double away : {3.0, 0.0, 2.0, 0.1, 4.0}) {
    scenario.obstacles.push_back(like);
    scenario.obstacles.back().path.center.z() += away;
  }
  const double first = scenario.obstacles[1].path.center.z();
  const double second = scenario.obstacles[3].path.center.z();
  keep_nearest(table, 2, scenario);
  ASSERT_EQ(scenario.obstacles.size(), 2U);
  EXPECT_EQ(scenario.obstacles[0].path.center.z(), first);
  EXPECT_EQ(scenario.obstacles[1].path.center.z(), second);
}

TEST(LargeRun, Of1000ScenariosShowsThoseThatFailedAndCountsTheOthers) {
  const TemporaryFolder folder;
  std::vector<std::string> names;
  for (int i = 0; i < 1000; ++i) names.push_back(fmt::format("scenario_{}", i));
  write_run(folder, names, kOneSet, 1, 4);
  std::vector<ScenarioResult> results;
  for (const std::string& name : names) {
    results.push_back(test::result_of(name, {{Metric::kPositionMax, 0.001}, {Metric::kOrientationMax, 0.1}}));
    if (name == "scenario_990") results.back().result.status = RolloutStatus::kDiverged;
  }
  folder.write("errors.csv", errors_csv(results));
  const ReportData data = report_of(folder.path());
  EXPECT_LE(report_json(data).size(), 5'000'000U);
  std::size_t shown = 0;
  for (const ReportScenario& s : data.scenarios) shown += s.runs.empty() ? 0 : 1;
  EXPECT_GT(shown, 50U);
  EXPECT_LT(shown, 1000U);
  EXPECT_FALSE(data.scenarios[990].runs.empty());
  EXPECT_THAT(data.thinned, Contains(HasSubstr(fmt::format("{} of 1000 scenarios", 1000 - shown))));
  EXPECT_THAT(data.verdict.sentence, HasSubstr("1 of 1000 scenarios failed"));
}

TEST(LargeRun, TablesThatDoNotFitAreCounted) {
  const TemporaryFolder folder;
  std::vector<ScenarioResult> results;
  for (int i = 0; i < 4000; ++i) {
    results.push_back(test::result_of(fmt::format("s{}", i), {{Metric::kPositionMax, 0.001}}));
    for (const Metric metric : headline_metrics())
      results.back().result.metrics[metric] = 0.12345678901234567;
  }
  folder.write("errors.csv", errors_csv(results));
  const ReportData data = report_of(folder.path());
  EXPECT_LT(data.tables.size(), 4000U);
  EXPECT_LE(report_json(data).size(), 5'000'000U);
  EXPECT_THAT(data.thinned,
              Contains(HasSubstr(fmt::format("numbers of {} of 4000 scenarios", 4000 - data.tables.size()))));
}

Evaluations random_evaluations(std::size_t count) {
  std::mt19937 draw(1);
  Evaluations e;
  e.phases = {"start", "search"};
  for (std::size_t i = 0; i < count; ++i) {
    e.of.push_back(i == 0 ? 0 : 1);
    const double objective = std::uniform_real_distribution<>(0.0, 2.0)(draw);
    e.objective.push_back(draw() % 10 == 0 ? NAN : objective);
    e.feasible.push_back(draw() % 3 == 0);
    e.violation.push_back(e.feasible.back() ? 0.0 : objective);
    e.native.push_back(draw() % 2 == 0);
  }
  e.start = 0;
  e.chosen = 12'345;
  return e;
}

TEST(LargeRun, OfThinnedEvaluationsTheBestSoFarAndEveryCountAreThoseOfAll) {
  const Evaluations all = random_evaluations(50'000);
  Evaluations e = all;
  thin(e);
  ASSERT_TRUE(e.thinned);
  EXPECT_LE(e.objective.size(), 20'000U);
  const std::size_t n = e.objective.size();
  for (const std::size_t size :
       {e.of.size(), e.feasible.size(), e.violation.size(), e.native.size(), e.thinned->number.size()})
    EXPECT_EQ(size, n);
  double best = INFINITY;
  double shown_best = INFINITY;
  std::size_t next = 0;
  for (std::size_t i = 0; i < all.objective.size(); ++i) {
    if (all.feasible[i] && all.objective[i] < best) best = all.objective[i];
    if (next == n || e.thinned->number[next] != i) continue;
    EXPECT_TRUE(e.objective[next] == all.objective[i] || std::isnan(all.objective[i]));
    EXPECT_EQ(e.feasible[next], all.feasible[i]);
    if (e.feasible[next] && e.objective[next] < shown_best) {
      shown_best = e.objective[next];
      EXPECT_EQ(shown_best, best) << "the best of its stretch, at its own place";
    }
    ++next;
  }
  EXPECT_EQ(next, n);
  EXPECT_EQ(shown_best, best);
  EXPECT_EQ(e.thinned->total, 50'000U);
  EXPECT_EQ(e.thinned->feasible,
            static_cast<std::size_t>(std::count(all.feasible.begin(), all.feasible.end(), true)));
  EXPECT_EQ(e.thinned->native,
            static_cast<std::size_t>(std::count(all.native.begin(), all.native.end(), true)));
  EXPECT_EQ(e.thinned->number[static_cast<std::size_t>(e.chosen)], 12'345U);
  EXPECT_EQ(e.thinned->number[static_cast<std::size_t>(e.start)], 0U);
  ASSERT_EQ(e.thinned->phase_runs.size(), 2U);
  EXPECT_EQ(e.thinned->phase_runs[1].from, 1U);
  EXPECT_EQ(e.thinned->phase_runs[1].to, 49'999U);
}

TEST(LargeRun, Of150000EvaluationsHasAPageAndCountsAllOfThem) {
  if (!available()) GTEST_SKIP() << "built without the page";
  const TemporaryFolder folder;
  write_run(folder, {"only"}, kOneSet, 1);
  std::string text = "phase,objective,feasible,violation\nstart,1,1,0\n";
  for (int i = 0; i < 150'000; ++i)
    text += fmt::format("search,{},{},{}\n", 1.0 + 1.0 / (i + 3), i % 2, 0.5 / (i + 3));
  folder.write("evaluations.csv", text);
  EXPECT_LE(write_report(folder.path(), folder / "report.html").bytes, 6'000'000U);
  const auto data = test::parsed(test::data_of(test::read_text(folder / "report.html")));
  EXPECT_EQ(test::at(data, "evaluations/thinned/total").as_integer(), 150'001);
  EXPECT_EQ(test::at(data, "scenarios/0/runs").items().size(), 1U) << "recordings have their room still";
  bool told = false;
  for (const auto& line : test::at(data, "verdict/details").items())
    told = told || line.as_string().find("of 150001 evaluations") != std::string::npos;
  EXPECT_TRUE(told);
}

TEST(LargeRun, ABadRecordingIsNamedAndTheOthersAreShown) {
  const TemporaryFolder folder;
  write_run(folder, {"good", "empty", "falling"}, kOneSet, 1, 5);
  const std::string text = test::read_text(folder / "rollout_good.csv");
  std::istringstream lines(text);
  std::string empty;
  std::string falling;
  int row = 0;
  for (std::string line; std::getline(lines, line); ++row) {
    const std::string rest = line.substr(line.find(','));
    empty += (row == 0 ? "time" : "") + rest + '\n';
    falling += (row == 0 ? "time" : fmt::format("{}", 10 - row)) + rest + '\n';
  }
  folder.write("rollout_empty.csv", empty);
  folder.write("rollout_falling.csv", falling);
  const ReportData data = report_of(folder.path());
  EXPECT_EQ(data.scenarios[0].runs.size(), 1U);
  EXPECT_TRUE(data.scenarios[1].runs.empty() && data.scenarios[2].runs.empty());
  EXPECT_THAT(data.left_out, Contains(HasSubstr("rollout_empty.csv:2")));
  EXPECT_THAT(data.left_out, Contains(HasSubstr("rollout_falling.csv:3")));
}

}  // namespace large_run_test
}  // namespace armtune::internal::report

// The loop around each kind of search.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/tuner/support/tuned.hpp"

namespace armtune::internal {
namespace tune_search_test {

using test::run;
using test::ShortStudy;
using test::Tuned;
using test::without_times;

/// The short study with this search, and whatever keys follow.
Study searched(const ShortStudy& files, const std::string& search) {
  const std::string text = test::read_text(files.path());
  return load_study(files.write("searched.yaml", text.substr(0, text.find("search:")) + search));
}

std::vector<std::string> phases(const std::string& journal) {
  std::vector<std::string> all;
  std::istringstream lines(journal);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const auto begin = line.find(',') + 1;
    all.push_back(line.substr(begin, line.find(',', begin) - begin));
  }
  return all;
}

TEST(Tune, GivesTheSameJournalForAnyNumberOfWorkersWhateverTheSearchIs) {
  const ShortStudy files;
  int run_number = 0;
  for (const char* search :
       {"search: {algorithm: SLSQP, max_evaluations: 9}\n", "search: {starts: 3, max_evaluations: 11}\n",
        "search: {global: ISRES, algorithm: BOBYQA, constraints: penalty, max_evaluations: 14}\n",
        "search: {algorithm: CRS2, constraints: penalty, starts: 2, max_evaluations: 13}\n"}) {
    const Study study = searched(files, search);
    const std::string name = std::to_string(run_number++);
    const Tuned one = run(study, 1, files / (name + "_one.csv"));
    const Tuned three = run(study, 3, files / (name + "_three.csv"));
    EXPECT_EQ(without_times(one.journal), without_times(three.journal)) << search;
    EXPECT_EQ(one.result.evaluations, study.max_evaluations) << search;
    EXPECT_EQ(one.result.reason, three.result.reason);
    EXPECT_EQ(one.result.ended, three.result.ended);
    for (const Evaluation& e : one.evaluations) EXPECT_FALSE(better(e, one.result.best));
  }
}

TEST(Tune, PointsThatFormDerivativesCountAndAreMarkedInTheJournal) {
  const ShortStudy files;
  const Tuned tuned =
      run(searched(files, "search: {algorithm: SLSQP, max_evaluations: 8}\n"), 2, files / "evaluations.csv");
  const auto names = phases(tuned.journal);
  ASSERT_EQ(names.size(), 8U);
  // The start is known: its derivatives take one point per gain.
  EXPECT_THAT((std::vector<std::string>(names.begin(), names.begin() + 4)),
              testing::ElementsAre("start", "gradient", "gradient", "search"));
  for (std::size_t g = 1; g < 3; ++g) {
    const auto& x = tuned.evaluations[g].x;
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(std::abs(x[i] - tuned.result.start.x[i]), i + 1 == g ? 0.01 : 0.0, 1e-12);
    }
  }
}

TEST(Tune, StartsTakeTurns) {
  const ShortStudy files;
  const Study study = searched(files, "search: {algorithm: SLSQP, starts: 3, max_evaluations: 16}\n");
  const Tuned tuned = run(study, 2, files / "evaluations.csv");
  // First round: derivatives at the start, which is known; then each other start with its derivatives.
  EXPECT_THAT(phases(tuned.journal),
              testing::ElementsAre("start", "gradient", "gradient", "search", "gradient", "gradient",
                                   "search", "gradient", "gradient", testing::_, testing::_, testing::_,
                                   testing::_, testing::_, testing::_, testing::_));
  EXPECT_NE(tuned.evaluations[3].x, tuned.evaluations[6].x);
}

TEST(Tune, AGlobalSearchTakesItsShareAndTheLocalOneBeginsAtTheBestPoint) {
  const ShortStudy files;
  const Study study = searched(files,
                               "search: {global: CRS2, global_share: 0.5, algorithm: COBYLA, constraints: "
                               "penalty, max_evaluations: 21}\n");
  const Tuned tuned = run(study, 2, files / "evaluations.csv");
  const auto names = phases(tuned.journal);
  ASSERT_EQ(names.size(), 21U);
  EXPECT_EQ(std::count(names.begin(), names.end(), "global"), 10) << "half of the 20 that the start leaves";
  EXPECT_EQ(names[10], "global");
  EXPECT_EQ(names[11], "search");
  const auto best = std::min_element(tuned.evaluations.begin(), tuned.evaluations.begin() + 11, better);
  // A local search begins with steps along single gains.
  const auto& first = tuned.evaluations[11].x;
  EXPECT_EQ((first[0] != best->x[0]) + (first[1] != best->x[1]), 1);
}

TEST(Tune, AWarmStartBeginsThereKeepsToItsBoxAndStaysRelativeToTheStart) {
  const ShortStudy files;
  Study study = load_study(files.path());
  study.warm.emplace();
  study.warm->gains = study.space.start;
  study.warm->gains.task_space_gains_p[3] = 45.0;
  study.warm->box = 0.2;
  study.warm->step = 0.05;
  const WarmPoint point = warm_point(study.space, *study.warm);
  const Tuned tuned = run(study, 2, files / "evaluations.csv");
  const auto names = phases(tuned.journal);
  EXPECT_EQ(tuned.result.start.objective, 1.0);
  ASSERT_GE(names.size(), 4U);
  EXPECT_EQ(names[0], "start");
  EXPECT_EQ(names[1], "warm");
  EXPECT_EQ(tuned.evaluations[0].x, study.space.start_point());
  EXPECT_EQ(tuned.evaluations[1].x, point.x);
  EXPECT_EQ(names[2], "search");
  for (std::size_t e = 1; e < tuned.evaluations.size(); ++e) {
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_GE(tuned.evaluations[e].x[i], point.lower[i]);
      EXPECT_LE(tuned.evaluations[e].x[i], point.upper[i]);
    }
  }
  const auto& first = tuned.evaluations[2].x;
  EXPECT_NEAR(std::max(std::abs(first[0] - point.x[0]), std::abs(first[1] - point.x[1])), 0.05, 1e-9);
}

}  // namespace tune_search_test
}  // namespace armtune::internal

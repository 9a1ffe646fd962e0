// A box of which no loop survives half or more: the search ends with a point that does, and no figure on the
// way is infinite.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ostream>
#include <random>
#include <string>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/search/tune.hpp"

namespace armtune::internal {
namespace half_diverges_test {

/// All of Kp grows together, on a linear scale from 0.4 to 400 times the published. From 100 times on it
/// diverges (rollout_test.cpp), which is three quarters of the box; long before, Kp dt > 2 turns every error
/// around and makes it larger in one period.
const std::string kParameters =
    "parameters:\n"
    "  - {name: task_space_gains_p/rx, lower: 10, upper: 1e4, scale: linear}\n"
    "  - {name: slerpDurationErrorGain, lower: 1, upper: 4, scale: linear}\n"
    "  - {name: task_space_gains_p/x, link: task_space_gains_p/rx, factor: 3.2}\n"
    "  - {name: task_space_gains_p/y, link: task_space_gains_p/rx, factor: 2}\n"
    "  - {name: task_space_gains_p/z, link: task_space_gains_p/rx, factor: 2}\n"
    "  - {name: task_space_gains_p/ry, link: task_space_gains_p/rx, factor: 0.6}\n"
    "  - {name: task_space_gains_p/rz, link: task_space_gains_p/rx, factor: 0.12}\n";

bool completed(const RolloutResult& result) {
  return result.status == RolloutStatus::kCompleted;
}

struct Search {
  const char* name;
  const char* keys;
  bool global;
};

std::ostream& operator<<(std::ostream& out, const Search& search) {
  return out << search.name;
}

test::ShortStudy files_of(const std::string& search_keys) {
  return test::ShortStudy(kParameters, test::kShortObjective, test::kShortConstraints,
                          "search: {" + search_keys + "}\n");
}

class HalfDiverges : public testing::TestWithParam<Search> {};

TEST_P(HalfDiverges, EndsWithAFiniteFeasibleBest) {
  const test::ShortStudy files = files_of(GetParam().keys);
  const Study study = load_study(files.path());
  CandidateRunner pool(study.scenarios, study.stepper, 2);
  std::atomic<bool> stop{false};
  long all = 0, lost = 0;
  TuneCallbacks callbacks;
  callbacks.evaluated = [&](const char*, const Evaluation& e) {
    ++all;
    EXPECT_TRUE(std::isfinite(e.objective));
    EXPECT_TRUE(std::isfinite(e.violation));
    if (std::all_of(e.results.begin(), e.results.end(), completed)) return;
    ++lost;
    EXPECT_FALSE(e.feasible);
  };
  const TuneResult result = tune(study, pool, stop, callbacks);
  // A local search goes there with its first step and comes back.
  EXPECT_GE(lost, GetParam().global ? (all + 5) / 6 : 1) << lost << " of " << all << " did not complete";
  EXPECT_TRUE(result.best.feasible);
  EXPECT_TRUE(std::all_of(result.best.results.begin(), result.best.results.end(), completed));
  EXPECT_TRUE(std::isfinite(result.best.objective));
  EXPECT_LE(result.best.objective, 1.0) << "the start is feasible, and scores 1";
}

constexpr Search kSearches[] = {
    {"DIRECT_L", "algorithm: DIRECT_L, max_evaluations: 60, engine: native", true},
    {"CRS2", "algorithm: CRS2, max_evaluations: 60, engine: native", true},
    {"ESCH", "algorithm: ESCH, max_evaluations: 60, engine: native", true},
    {"COBYLA_simbody", "algorithm: COBYLA, initial_step: 0.4, max_evaluations: 12, engine: simbody", false},
    {"BOBYQA_simbody", "algorithm: BOBYQA, initial_step: 0.4, max_evaluations: 12, engine: simbody", false},
};

INSTANTIATE_TEST_SUITE_P(Each, HalfDiverges, testing::ValuesIn(kSearches),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BoxThatHalfDiverges, HalfOfItDoes) {
  const test::ShortStudy files = files_of(kSearches[0].keys);
  const Study study = load_study(files.path());
  Rollout rollout(study.scenarios.front(), study.stepper, Engine::kNative);
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  constexpr int kPoints = 64;
  int diverged = 0;
  for (int point = 0; point < kPoints; ++point) {
    std::vector<double> x(study.space.free.size());
    for (double& coordinate : x) coordinate = uniform(generator);
    diverged += rollout.run(study.space.gains_at(x)).status == RolloutStatus::kDiverged ? 1 : 0;
  }
  EXPECT_GE(2 * diverged, kPoints) << diverged << " of " << kPoints << " diverged";
  EXPECT_LT(diverged, kPoints) << "the other part is there too";
}

}  // namespace half_diverges_test
}  // namespace armtune::internal

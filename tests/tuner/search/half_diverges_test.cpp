// A box much of which no loop survives: the search ends with a point that does, and no figure on the way is
// infinite.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/search/tune.hpp"

namespace armtune {
namespace {

class HalfDiverges : public testing::TestWithParam<const char*> {};

TEST_P(HalfDiverges, EndsWithAFiniteFeasibleBest) {
  const test::ShortStudy files(
      "parameters:\n"
      "  - {name: task_space_gains_p/rx, lower: 10, upper: 1e5}\n"
      "  - {name: slerpDurationErrorGain, lower: 1, upper: 4, scale: linear}\n",
      test::kShortObjective, test::kShortConstraints,
      std::string("search: {algorithm: ") + GetParam() + ", max_evaluations: 60, engine: native}\n");
  const Study study = load_study(files.path());
  Workers pool(study.scenarios, study.stepper, 2);
  std::atomic<bool> stop{false};
  long all = 0, lost = 0;
  TuneCallbacks callbacks;
  callbacks.evaluated = [&](const char*, const Evaluation& e) {
    ++all;
    const auto completed = [](const RolloutResult& r) { return r.status == RolloutStatus::kCompleted; };
    if (std::all_of(e.results.begin(), e.results.end(), completed)) return;
    ++lost;
    EXPECT_FALSE(e.feasible);
    EXPECT_TRUE(std::isfinite(e.objective));
    EXPECT_TRUE(std::isfinite(e.violation));
  };
  const TuneResult result = tune(study, pool, stop, callbacks);
  EXPECT_GE(6 * lost, all) << lost << " of " << all << " did not complete";
  EXPECT_TRUE(result.best.feasible);
  EXPECT_TRUE(std::isfinite(result.best.objective));
  EXPECT_LE(result.best.objective, 1.0) << "the start is feasible, and scores 1";
}

INSTANTIATE_TEST_SUITE_P(Each, HalfDiverges, testing::Values("DIRECT_L", "CRS2", "ESCH"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace armtune

// Studies that search in the native engine: Simbody has the first and the last word.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>
#include <vector>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/search/tune.hpp"

namespace armtune::internal {
namespace native_search_test {

using test::ShortStudy;

const std::string kSweep = "sweep: [{parameters: [task_space_gains_p/rx], factors: [0.8, 2]}]\n";
const std::string kNativeSearch =
    "search: {algorithm: COBYLA, max_evaluations: 20, engine: native, verify_share: 0.3}\n";

class NativeSearch : public testing::Test {
 protected:
  struct Seen {
    std::string phase;
    Evaluation evaluation;
  };

  Study study(const std::string& search = kSweep + kNativeSearch) {
    files_ = std::make_unique<ShortStudy>(test::kShortParameters, test::kShortObjective,
                                          test::kShortConstraints, search);
    return load_study(files_->path());
  }

  TuneResult tune(const Study& study, int workers = 2, std::size_t stop_after = 0) {
    seen_.clear();
    std::atomic<bool> stop{false};
    CandidateRunner pool(study.scenarios, study.stepper, workers);
    TuneCallbacks callbacks;
    callbacks.evaluated = [&](const char* phase, const Evaluation& e) {
      seen_.push_back({phase, e});
      if (seen_.size() == stop_after) stop = true;
    };
    return armtune::internal::tune(study, pool, stop, callbacks);
  }

  /// Whether the metrics are, to the bit, what that engine gives for the gains.
  static bool comes_from(Engine engine, const Study& study, const Evaluation& e) {
    for (std::size_t s = 0; s < study.scenarios.size(); ++s) {
      const RolloutResult again = Rollout(study.scenarios[s], study.stepper, engine).run(e.gains);
      if (test::bits(again.metrics) != test::bits(e.results[s].metrics)) return false;
    }
    return true;
  }

  std::unique_ptr<ShortStudy> files_;
  std::vector<Seen> seen_;
};

TEST_F(NativeSearch, StartAndLastStepsAreSimbodysAndAllBetweenNative) {
  const Study study = this->study();
  const TuneResult result = tune(study);
  std::set<std::string> phases;
  for (const Seen& s : seen_) {
    phases.insert(s.phase);
    const bool judged = &s == &seen_.front() || s.phase == "verify";
    EXPECT_EQ(s.evaluation.engine, judged ? Engine::kSimbody : Engine::kNative) << s.phase;
    EXPECT_TRUE(comes_from(judged ? Engine::kSimbody : Engine::kNative, study, s.evaluation)) << s.phase;
    EXPECT_FALSE(comes_from(judged ? Engine::kNative : Engine::kSimbody, study, s.evaluation)) << s.phase;
    if (s.phase == "start") {
      EXPECT_EQ(s.evaluation.objective, 1.0) << "each engine's own start scores 1";
    }
  }
  EXPECT_THAT(phases, testing::ElementsAre("search", "start", "sweep", "verify"));
  EXPECT_EQ(seen_.front().phase, "start");
  EXPECT_EQ(seen_.back().phase, "verify");
  EXPECT_EQ(result.evaluations, static_cast<long>(seen_.size()));
  EXPECT_LE(result.evaluations, study.max_evaluations);
}

TEST_F(NativeSearch, TheResultIsTheBestThatSimbodySaw) {
  const Study study = this->study();
  const TuneResult result = tune(study);
  const Evaluation* best = nullptr;
  const Evaluation* best_native = nullptr;
  for (const Seen& s : seen_) {
    const bool judged = s.evaluation.engine == Engine::kSimbody;
    const Evaluation*& of_engine = judged ? best : best_native;
    if (of_engine == nullptr || better(s.evaluation, *of_engine)) of_engine = &s.evaluation;
  }
  ASSERT_NE(best, nullptr);
  ASSERT_NE(best_native, nullptr);
  EXPECT_EQ(result.best.x, best->x);
  EXPECT_EQ(result.best.objective, best->objective);
  EXPECT_TRUE(result.best.feasible);
  EXPECT_LT(result.best.objective, 1.0);
  EXPECT_LE(result.best.objective, best_native->objective + 1e-9) << "nothing found is lost";
  ASSERT_TRUE(result.best_of_sweep.has_value());
  EXPECT_TRUE(comes_from(Engine::kSimbody, study, *result.best_of_sweep));
}

TEST_F(NativeSearch, KeepsAShareOfTheEvaluationsForSimbody) {
  tune(study());
  const auto judged =
      std::count_if(seen_.begin(), seen_.end(), [](const Seen& s) { return s.phase == "verify"; });
  EXPECT_GE(judged, 3) << "the best three at least";
  EXPECT_LE(judged, 6) << "0.3 of 20";
  const auto native = std::count_if(seen_.begin(), seen_.end(),
                                    [](const Seen& s) { return s.evaluation.engine == Engine::kNative; });
  EXPECT_LE(native + 1, 14);
}

TEST_F(NativeSearch, DoesNotDependOnTheWorkers) {
  const Study study = this->study();
  tune(study, 1);
  const auto alone = seen_;
  tune(study, 3);
  ASSERT_EQ(seen_.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(seen_[i].phase, alone[i].phase);
    EXPECT_EQ(seen_[i].evaluation.x, alone[i].evaluation.x);
    EXPECT_EQ(seen_[i].evaluation.objective, alone[i].evaluation.objective);
  }
}

TEST_F(NativeSearch, InterruptedItEndsWithTheBestOfEitherEngineAndSaysWhose) {
  // Stiffer wrists are better: the sweep's last point beats the start.
  const Study study = this->study(
      "sweep: [{parameters: [task_space_gains_p/rx], factors: [1.2, 1.5, 1.8]}]\n" + kNativeSearch);
  const TuneResult result = tune(study, 1, 5);
  EXPECT_TRUE(result.interrupted);
  ASSERT_EQ(seen_.size(), 5U);
  EXPECT_NE(result.best.x, result.start.x) << "what the native engine found is kept";
  EXPECT_EQ(result.best.engine, Engine::kNative);
  EXPECT_LT(result.best.objective, 1.0);
  EXPECT_EQ(result.start.engine, Engine::kSimbody);
  EXPECT_FALSE(result.best_of_sweep.has_value()) << "Simbody has not seen it";
}

TEST_F(NativeSearch, ABudgetTooSmallForBothIsSimbodys) {
  const TuneResult result = tune(study("search: {algorithm: COBYLA, max_evaluations: 4, engine: native}\n"));
  EXPECT_EQ(result.evaluations, 4);
  for (const Seen& s : seen_) EXPECT_EQ(s.evaluation.engine, Engine::kSimbody);
}

// The limit is the start's own value: rounding between the engines must not break it.
TEST_F(NativeSearch, WhatEqualsTheStartIsFeasibleInBothEngines) {
  files_ =
      std::make_unique<ShortStudy>(test::kShortParameters, test::kShortObjective,
                                   "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: start}\n"
                                   "  - {metric: joint_position/min_margin, at_least: start}\n",
                                   kNativeSearch);
  tune(load_study(files_->path()));
  int starts = 0;
  for (const Seen& s : seen_) {
    if (s.phase != "start") continue;
    ++starts;
    EXPECT_TRUE(s.evaluation.feasible) << name(s.evaluation.engine);
  }
  EXPECT_EQ(starts, 2);
}

// The start is the sweep's best: Simbody has seen it already.
TEST_F(NativeSearch, TheBestOfTheSweepIsSimbodysAlsoWhereItIsTheStart) {
  const TuneResult result =
      tune(study("sweep: [{parameters: [slerpDurationErrorGain], factors: [1, 1.5]}]\n" + kNativeSearch));
  ASSERT_TRUE(result.best_of_sweep.has_value());
  EXPECT_EQ(result.best_of_sweep->engine, Engine::kSimbody);
}

// Factors beyond the bound are clamped to the same point.
TEST_F(NativeSearch, SimulatesNoPointTwiceInOneEngine) {
  tune(study("sweep: [{parameters: [slerpDurationErrorGain], factors: [0.9, 4, 8]}]\n" + kNativeSearch));
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    for (std::size_t j = 0; j < i && seen_[i].phase != "sweep"; ++j) {
      const Evaluation& a = seen_[i].evaluation;
      const Evaluation& b = seen_[j].evaluation;
      EXPECT_FALSE(a.engine == b.engine && a.x == b.x) << i << ", " << j;
    }
  }
}

// CRS2 goes on from nowhere: the last steps are a local search's.
TEST_F(NativeSearch, AGlobalSearchEndsWithLocalSteps) {
  const TuneResult result =
      tune(study("search: {algorithm: CRS2, constraints: penalty, max_evaluations: 60, engine: native}\n"));
  const auto first =
      std::find_if(seen_.begin(), seen_.end(), [](const Seen& s) { return s.phase == "verify"; });
  ASSERT_GE(seen_.end() - first, 5);
  const Evaluation* best = nullptr;
  for (auto s = first; s < first + 3; ++s) {
    if (best == nullptr || better(s->evaluation, *best)) best = &s->evaluation;
  }
  for (auto s = first + 3; s < seen_.end(); ++s) {
    for (std::size_t i = 0; i < best->x.size(); ++i) {
      EXPECT_NEAR(s->evaluation.x[i], best->x[i], 0.1) << "five steps of 0.02";
    }
  }
  EXPECT_FALSE(better(*best, result.best));
}

}  // namespace native_search_test
}  // namespace armtune::internal

// Studies that search in the native engine: Simbody has the first and the last word.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>
#include <vector>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/search/tune.hpp"

namespace armtune {
namespace {

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
    Workers pool(study.scenarios, study.stepper, workers);
    TuneCallbacks callbacks;
    callbacks.evaluated = [&](const char* phase, const Evaluation& e) {
      seen_.push_back({phase, e});
      if (seen_.size() == stop_after) stop = true;
    };
    return armtune::tune(study, pool, stop, callbacks);
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
    const bool judged = s.phase == "start" || s.phase == "verify";
    EXPECT_TRUE(comes_from(judged ? Engine::kSimbody : Engine::kNative, study, s.evaluation)) << s.phase;
    EXPECT_FALSE(comes_from(judged ? Engine::kNative : Engine::kSimbody, study, s.evaluation)) << s.phase;
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
    const bool judged = s.phase == "start" || s.phase == "verify";
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
  EXPECT_GE(judged, 4) << "the best three, and the best of the sweep among them or not";
  EXPECT_LE(judged, 6) << "0.3 of 20";
  const auto native = std::count_if(seen_.begin(), seen_.end(),
                                    [](const Seen& s) { return s.phase == "sweep" || s.phase == "search"; });
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

TEST_F(NativeSearch, InterruptedItStillEndsWithSimbodysFigures) {
  // Stiffer wrists are better: the sweep's last point beats the start.
  const Study study = this->study(
      "sweep: [{parameters: [task_space_gains_p/rx], factors: [1.2, 1.5, 1.8]}]\n" + kNativeSearch);
  const TuneResult result = tune(study, 1, 4);
  EXPECT_TRUE(result.interrupted);
  ASSERT_EQ(seen_.size(), 4U);
  EXPECT_TRUE(comes_from(Engine::kSimbody, study, result.best));
  EXPECT_NE(result.best.x, result.start.x) << "what the native engine found is kept";
  EXPECT_LT(result.best.objective, 1.0);
}

TEST_F(NativeSearch, ABudgetTooSmallForBothIsSimbodys) {
  const TuneResult result = tune(study("search: {algorithm: COBYLA, max_evaluations: 4, engine: native}\n"));
  EXPECT_EQ(result.evaluations, 4);
  for (const Seen& s : seen_) EXPECT_TRUE(s.phase == "start" || s.phase == "verify") << s.phase;
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

}  // namespace
}  // namespace armtune

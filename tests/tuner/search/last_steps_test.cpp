// A wall-time budget holds for a search in the native engine together with Simbody's last steps.

#include "tuner/search/last_steps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/journal/journal.hpp"
#include "tuner/search/tune.hpp"

namespace armtune::internal {
namespace last_steps_test {

using testing::HasSubstr;

Study budget_of(long evaluations, double minutes, double share) {
  Study study;
  study.max_evaluations = evaluations;
  study.max_minutes = minutes;
  study.verify_share = share;
  return study;
}

TEST(LastSteps, KeepTheirShareOfEvaluationsAndTime) {
  EXPECT_EQ(kept_evaluations(budget_of(300, 0.0, 0.1)), 30);
  EXPECT_EQ(kept_evaluations(budget_of(300, 0.0, 0.0)), 5) << "the best few are judged in any case";
  // Time is short, evaluations are not: a tenth of an hour.
  EXPECT_DOUBLE_EQ(kept_seconds(budget_of(100000, 60.0, 0.1), 2.0), 360.0);
  // Evaluations are short: no more than the thirty of them take.
  EXPECT_DOUBLE_EQ(kept_seconds(budget_of(300, 60.0, 0.1), 2.0), 60.0);
  // Enough to judge the best few, whatever the share.
  EXPECT_DOUBLE_EQ(kept_seconds(budget_of(100000, 60.0, 0.0), 2.0), 10.0);
  EXPECT_DOUBLE_EQ(kept_seconds(budget_of(100000, 1.0, 0.1), 2.0), 10.0);
}

TEST(LastSteps, LeaveTheRestToTheSearch) {
  Study study = budget_of(300, 0.0, 0.1);
  EXPECT_EQ(engine_of_search(study), Engine::kSimbody);
  EXPECT_EQ(evaluations_to_search(study), 299) << "all but the start";
  study.engine = Engine::kNative;
  EXPECT_EQ(engine_of_search(study), Engine::kNative);
  EXPECT_EQ(evaluations_to_search(study), 268) << "two starts, and thirty for Simbody";
  for (const long evaluations : {1, 5, 6}) {
    study.max_evaluations = evaluations;
    EXPECT_EQ(engine_of_search(study), Engine::kSimbody) << evaluations << " are too few for both";
    EXPECT_EQ(evaluations_to_search(study), evaluations - 1);
  }
  study.max_evaluations = 7;
  EXPECT_EQ(engine_of_search(study), Engine::kNative);
}

class LastStepsInTime : public testing::Test {
 protected:
  /// A search that ends for nothing but its budget. `units`: of time, each what the start takes on Simbody.
  void begin(double units) {
    study_ = load_study(files_.path());
    study_.solver.x_tolerance = 0.0;
    CandidateRunner workers(study_.scenarios, study_.stepper, 1);
    const auto began = std::chrono::steady_clock::now();
    workers.run({&study_.space.start, 1}, stop_);
    unit_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    study_.max_minutes = units * unit_ / 60.0;
  }

  struct Done {
    TuneResult result;
    std::vector<std::string> phases;  ///< with the engine of each evaluation
    std::vector<std::vector<double>> points;
    double seconds = 0.0;  ///< when the last evaluation was finished
    long rollouts = 0;
  };

  Done tune(Journal* journal) {
    Done done;
    CandidateRunner workers(study_.scenarios, study_.stepper, 1);
    TuneCallbacks callbacks;
    callbacks.evaluated = [&done](const char* phase, const Evaluation& e) {
      done.phases.push_back(std::string(phase) + " " + name(e.engine));
      done.points.push_back(e.x);
      done.seconds = e.seconds;
    };
    done.result = armtune::internal::tune(study_, workers, stop_, callbacks, journal);
    done.rollouts = workers.rollouts_done();
    return done;
  }

  std::unique_ptr<Journal> journal_begun() { return Journal::begin(path(), {}); }
  std::unique_ptr<Journal> resumed() {
    std::string warning;
    return Journal::resume(path(), {}, warning);
  }
  std::string path() const { return files_ / "journal.txt"; }

  /// Ends the journal behind `more` lines after the first that holds the text.
  void cut_behind(const std::string& text, int more) const {
    std::istringstream lines(test::read_text(path()));
    std::string kept;
    bool found = false;
    for (std::string line; std::getline(lines, line) && (!found || more-- > 0);) {
      kept += line + "\n";
      found = found || line.find(text) != std::string::npos;
    }
    ASSERT_TRUE(found) << text;
    std::ofstream(path(), std::ios::binary) << kept;
  }

  static long count(const Done& done, const std::string& phase) {
    return std::count(done.phases.begin(), done.phases.end(), phase);
  }

  test::ShortStudy files_{test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                          "search: {algorithm: CRS2, constraints: penalty, max_evaluations: 100000, "
                          "engine: native, verify_share: 0.5}\n"};
  Study study_;
  std::atomic<bool> stop_{false};
  double unit_ = 0.0;  ///< [s]
};

TEST_F(LastStepsInTime, TheBudgetHoldsForThemToo) {
  begin(40.0);
  const auto journal = journal_begun();
  const Done done = tune(journal.get());
  const long native = count(done, "search native");
  const long judged = count(done, "verify simbody");
  EXPECT_GE(native, 8);
  EXPECT_GT(judged, 5) << "time is left to refine what was judged";
  EXPECT_EQ(journal->time_was_up(Minutes::kSearch), static_cast<std::uint64_t>(native + 2));
  EXPECT_EQ(journal->time_was_up(Minutes::kRun), static_cast<std::uint64_t>(done.result.evaluations));
  EXPECT_EQ(done.result.ended, SearchEnd::kTime) << "the end of the search, not of the last steps";
  // The last portion was begun in time: eight evaluations, on a machine that others use as well.
  EXPECT_LT(done.seconds, 60.0 * study_.max_minutes + 24.0 * unit_);
}

TEST_F(LastStepsInTime, AGlobalSearchLeavesItsShareToTheLocalOne) {
  begin(40.0);
  study_.global_algorithm = "CRS2";
  study_.global_share = 0.5;
  study_.solver.algorithm = "SBPLX";
  Done whole;
  std::uint64_t global = 0;
  {
    const auto journal = journal_begun();
    whole = tune(journal.get());
    ASSERT_TRUE(journal->time_was_up(Minutes::kGlobal).has_value());
    global = *journal->time_was_up(Minutes::kGlobal);
  }
  EXPECT_EQ(count(whole, "global native"), static_cast<long>(global) - 2);
  EXPECT_GE(count(whole, "search native"), 8);
  // Killed in the local search, the global one ends where it did.
  cut_behind("global-time-up", 3);
  {
    const auto journal = resumed();
    const Done again = tune(journal.get());
    EXPECT_EQ(journal->time_was_up(Minutes::kGlobal), global);
    EXPECT_EQ(count(again, "global native"), count(whole, "global native"));
    EXPECT_TRUE(std::equal(whole.points.begin(),
                           whole.points.begin() + static_cast<std::ptrdiff_t>(global) + 3,
                           again.points.begin()));
  }
}

TEST_F(LastStepsInTime, AreTheSameWhereTheRunGoesOn) {
  begin(20.0);
  Done whole;
  {
    const auto journal = journal_begun();
    whole = tune(journal.get());
  }
  {
    const auto journal = resumed();
    const Done again = tune(journal.get());
    EXPECT_EQ(again.rollouts, 0);
    EXPECT_EQ(again.phases, whole.phases);
    EXPECT_EQ(again.points, whole.points);
    EXPECT_EQ(again.result.reason, whole.result.reason);
    EXPECT_EQ(again.result.best.x, whole.result.best.x);
    EXPECT_EQ(again.result.best.objective, whole.result.best.objective);
  }
  // Killed in its last steps: what is recorded of them stands, and the search before them ends where it did.
  cut_behind("search-time-up", 2);
  const auto journal = resumed();
  const auto recorded = static_cast<std::ptrdiff_t>(journal->records());
  const Done again = tune(journal.get());
  EXPECT_EQ(count(again, "search native"), count(whole, "search native"));
  EXPECT_EQ(again.rollouts, (again.result.evaluations - recorded) * 2) << "two scenarios each";
  ASSERT_GE(again.points.size(), journal->time_was_up(Minutes::kSearch).value() + 2);
  EXPECT_TRUE(std::equal(whole.points.begin(), whole.points.begin() + recorded, again.points.begin()));
}

TEST_F(LastStepsInTime, TooLittleTimeForTwoEnginesIsSimbodys) {
  begin(3.0);
  Done whole;
  {
    const auto journal = journal_begun();
    whole = tune(journal.get());
    EXPECT_EQ(journal->time_was_up(Minutes::kSearch), 1U);
  }
  EXPECT_GE(whole.result.evaluations, 2);
  for (const std::string& phase : whole.phases) EXPECT_THAT(phase, HasSubstr("simbody"));
  study_.max_minutes *= 1000.0;  // whatever there would be time for now
  const auto journal = resumed();
  const Done again = tune(journal.get());
  EXPECT_EQ(again.phases, whole.phases);
  EXPECT_EQ(again.points, whole.points);
  EXPECT_EQ(again.rollouts, 0);
}

}  // namespace last_steps_test
}  // namespace armtune::internal

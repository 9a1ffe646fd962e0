// A short study with a final phase, from start to end.

#include "tuner/search/final_phase.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/evaluation/evaluations_file.hpp"
#include "tuner/journal/journal.hpp"
#include "tuner/search/tune.hpp"

namespace armtune::internal {
namespace final_phase_test {

const std::string kSearchOfTest =
    "search: {algorithm: COBYLA, constraints: penalty, max_evaluations: 40, engine: native, verify_share: 0, "
    "final_phase: minimax, final_share: 0.9}\n";

class FinalPhase : public testing::Test {
 protected:
  struct Done {
    TuneResult result;
    std::vector<std::string> phases;
    std::vector<Evaluation> evaluations;
    std::string table;  ///< evaluations.csv without its last column, the time
    double simulated = 0.0;
  };

  Done tune(int workers, Journal* journal = nullptr, std::size_t stop_after = 0) const {
    Done done;
    std::atomic<bool> stop{false};
    CandidateRunner runner(study_.scenarios, study_.stepper, workers);
    const std::string path = files_ / "evaluations.csv";
    std::remove(path.c_str());
    EvaluationsFile file(path, study_);
    TuneCallbacks callbacks;
    callbacks.evaluated = [&](const char* phase, const Evaluation& e) {
      done.phases.emplace_back(phase);
      done.evaluations.push_back(e);
      file.append(phase, e);
      if (done.phases.size() == stop_after) stop = true;
    };
    done.result = armtune::internal::tune(study_, runner, stop, callbacks, journal);
    done.simulated = runner.simulated();
    std::istringstream lines(test::read_text(path));
    for (std::string line; std::getline(lines, line);) done.table += line.substr(0, line.rfind(',')) + "\n";
    return done;
  }
  std::string journal_path() const { return files_ / "journal.txt"; }

  test::ShortStudy files_{test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                          kSearchOfTest};
  Study study_ = load_study(files_.path());
};

TEST_F(FinalPhase, FollowsTheLocalSearchAndNeverEndsWithWorseGains) {
  const Done done = tune(2);
  const auto first = std::find(done.phases.begin(), done.phases.end(), "final");
  ASSERT_NE(first, done.phases.end());
  const auto before = static_cast<std::size_t>(first - done.phases.begin());
  EXPECT_EQ(done.phases[before - 1], "search");
  EXPECT_EQ(std::count(first, done.phases.end(), "search"), 0);
  const Evaluation* best_of_search = nullptr;
  const Evaluation* best_of_final = nullptr;
  for (std::size_t e = 1; e < done.phases.size(); ++e) {
    if (done.phases[e] == "verify") continue;
    const Evaluation*& best = e < before ? best_of_search : best_of_final;
    if (best == nullptr || better(done.evaluations[e], *best)) best = &done.evaluations[e];
  }
  EXPECT_TRUE(better(*best_of_final, *best_of_search)) << "the local search has not converged";
  EXPECT_TRUE(best_of_final->feasible);
  EXPECT_LE(done.result.best.objective, best_of_final->objective + 1e-9);
}

TEST_F(FinalPhase, CopiesCountInTheBudgetAndInTheTable) {
  const Done done = tune(2);
  EXPECT_GT(done.result.copies, 0);
  EXPECT_EQ(done.result.copies % copies_per_iteration(study_), 0);
  EXPECT_LE(done.result.evaluations + done.result.copies, study_.max_evaluations);
  long last = 0;
  for (std::size_t e = 0; e < done.phases.size(); ++e) {
    const long copies = done.evaluations[e].copies;
    EXPECT_GE(copies, last);
    if (done.phases[e] == "search") {
      EXPECT_EQ(copies, 0);
    }
    last = copies;
  }
  EXPECT_EQ(last, done.result.copies);
  EXPECT_THAT(done.table.substr(0, done.table.find('\n')), testing::HasSubstr(",copies"));
  EXPECT_THAT(done.table, testing::EndsWith("," + std::to_string(last) + "\n"));
  // Every rollout that completes takes the scenario's 8 s, of a copy as of a candidate.
  const double each = 8.0 * static_cast<double>(study_.scenarios.size());
  EXPECT_NEAR(done.simulated, each * static_cast<double>(done.result.evaluations + done.result.copies), 1e-6);
}

TEST_F(FinalPhase, DoesNotDependOnTheWorkers) {
  const Done one = tune(1);
  const Done three = tune(3);
  EXPECT_EQ(one.table, three.table);
  EXPECT_EQ(one.result.reason, three.result.reason);
}

TEST_F(FinalPhase, ResumedAnywhereInItTheRunIsTheSame) {
  Done whole;
  {
    const auto journal = Journal::begin(journal_path(), {});
    whole = tune(2, journal.get());
  }
  const std::string text = test::read_text(journal_path());
  const auto finals = std::count(whole.phases.begin(), whole.phases.end(), "final");
  ASSERT_GE(finals, 2);
  for (const long kept : {1L, finals - 1}) {
    // Ends the journal behind so many records of the final phase.
    std::istringstream lines(text);
    std::string part;
    long found = 0;
    for (std::string line; found < kept && std::getline(lines, line);) {
      part += line + "\n";
      found += line.find("\tfinal\t") != std::string::npos ? 1 : 0;
    }
    ASSERT_EQ(found, kept);
    std::ofstream(journal_path(), std::ios::binary) << part;
    std::string warning;
    const auto journal = Journal::resume(journal_path(), {}, warning);
    const Done again = tune(3, journal.get());
    EXPECT_EQ(again.table, whole.table) << kept;
    EXPECT_EQ(again.result.best.x, whole.result.best.x);
    EXPECT_EQ(again.result.reason, whole.result.reason);
    EXPECT_EQ(again.result.copies, whole.result.copies);
  }
}

TEST_F(FinalPhase, InterruptedInItTheRunSaysSo) {
  const Done whole = tune(2);
  const auto first = std::find(whole.phases.begin(), whole.phases.end(), "final") - whole.phases.begin();
  const Done done = tune(2, nullptr, static_cast<std::size_t>(first) + 1);
  EXPECT_TRUE(done.result.interrupted);
  EXPECT_EQ(done.result.ended, SearchEnd::kInterrupted);
  EXPECT_EQ(done.phases.size(), static_cast<std::size_t>(first) + 1);
}

TEST_F(FinalPhase, IsLeftOutWhereItsShareIsTooSmallForOneIteration) {
  EXPECT_EQ(copies_per_iteration(study_), 3) << "two gains, and the gain set itself";
  study_.final_share = 0.5;
  EXPECT_EQ(final_evaluations(study_, 6), 0) << "three copies, and nothing left to try a step";
  EXPECT_EQ(final_evaluations(study_, 8), 4);
  study_.final_phase = false;
  EXPECT_EQ(final_evaluations(study_, 100), 0);
  const Done done = tune(2);
  EXPECT_EQ(std::count(done.phases.begin(), done.phases.end(), "final"), 0);
  EXPECT_EQ(done.result.copies, 0);
}

TEST_F(FinalPhase, WithSimbodyAsTheEngineSimbodyJudgesEveryStep) {
  study_.engine = Engine::kSimbody;
  study_.max_evaluations = 20;
  const Done done = tune(2);
  EXPECT_GT(std::count(done.phases.begin(), done.phases.end(), "final"), 0);
  for (const Evaluation& e : done.evaluations) EXPECT_EQ(e.engine, Engine::kSimbody);
  EXPECT_LE(done.result.evaluations + done.result.copies, 20);
}

}  // namespace final_phase_test
}  // namespace armtune::internal

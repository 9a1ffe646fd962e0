#include "tuner/report/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/tuner/report/support/two_sets.hpp"
#include "tuner/report/findings.hpp"
#include "tuner/report/tables.hpp"

namespace armtune::internal::report {
namespace report_verdict_test {

using test::errors_of;
using test::result_of;
using test::two_sets;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Verdict, NamesTheJointClosestToItsLimitWithPlaceAndTime) {
  EXPECT_EQ(closest_joint(two_sets(), 1), "wrist comes closest to its velocity limit, 88 % at 6.01 s in b");
  EXPECT_EQ(closest_joint(two_sets(), 0), "elbow comes closest to its velocity limit, 70 % at 2.00 s in a");
  EXPECT_EQ(closest_joint({}, 0), "");
  const auto over = tables_of({errors_of({result_of(
      "a", {{Metric::kJointVelocityMaxRatio, 1.21}, {Metric::kJointVelocityMaxRatioTime, 3.0}})})});
  EXPECT_THAT(closest_joint(over, 0), HasSubstr("breaks its velocity limit, 121 % at 3.00 s"));
  const auto barely = tables_of({errors_of(
      {result_of("a", {{Metric::kJointVelocityMaxRatio, 1.000002}, {Metric::kJointVelocityMaxRatioTime, 3.0}},
                 "motor at the elbow")})});
  EXPECT_EQ(closest_joint(barely, 0),
            "motor at the elbow breaks its velocity limit, 100.0002 % at 3.00 s in a");
  const auto timeless =
      tables_of({errors_of({result_of("a", {{Metric::kJointVelocityMaxRatio, 0.5}}, "motor at the elbow")})});
  EXPECT_EQ(closest_joint(timeless, 0), "motor at the elbow comes closest to its velocity limit, 50 % in a");
  EXPECT_THAT(violations(barely, {{Metric::kJointVelocityMaxRatio, true, 1.0, {}}}, 0),
              ElementsAre(AllOf(HasSubstr("is 1.000002 in a"), HasSubstr("at most 1"))));
}

TEST(Verdict, ListsWhatIsViolatedAndNothingElse) {
  const auto tables = two_sets();
  EXPECT_TRUE(violations(tables, {{Metric::kJointVelocityMaxRatio, true, 0.9, {}}}, 1).empty());
  EXPECT_THAT(
      violations(tables, {{Metric::kJointVelocityMaxRatio, true, 0.8, {}}}, 1),
      ElementsAre(AllOf(HasSubstr("joint_velocity/max_ratio is 0.88 in b"), HasSubstr("at most 0.8"))));
  EXPECT_TRUE(violations(tables, {{Metric::kJointVelocityMaxRatio, true, 0.8, {"a"}}}, 1).empty());
  // Without a value of its own the limit is the start's.
  EXPECT_THAT(violations(tables, {{Metric::kObstacleMinClearance, false, std::nullopt, {}}}, 1),
              ElementsAre(HasSubstr("at least 0.2")));
  EXPECT_TRUE(violations(tables, {{Metric::kObstacleMinClearance, false, std::nullopt, {}}}, 0).empty());
  ScenarioResult diverged =
      result_of("a", {{Metric::kJointVelocityMaxRatio, 3.0}}, "", RolloutStatus::kDiverged);
  EXPECT_THAT(failures(tables_of({errors_of({diverged})}), 0), ElementsAre("a: diverged"));
  diverged.result.reason = "diverged at 4.2 s, in followTrajectory";
  const auto failed = tables_of({errors_of({diverged})});
  EXPECT_THAT(failures(failed, 0), ElementsAre("a: diverged at 4.2 s, in followTrajectory"));
  EXPECT_TRUE(violations(failed, {{Metric::kJointVelocityMaxRatio, true, 1.0, {}}}, 0).empty())
      << "told once";
}

ReportData tuned_data() {
  ReportData data;
  data.kind = RunKind::kTune;
  data.sets = {"start", "tuned"};
  data.tables = two_sets();
  return data;
}

VerdictFacts tuned_facts(double limit) {
  VerdictFacts facts;
  facts.study.emplace();
  facts.study->terms = {{Metric::kOrientationMax, {"a", "b"}}, {Metric::kEffortRateRms, {"a"}}};
  facts.study->limits = {{Metric::kJointVelocityMaxRatio, true, limit, {"a", "b"}}};
  RunRecord& run = facts.record.emplace();
  run.search.emplace().reason = "budget used up";
  run.search->ended = SearchEnd::kEvaluations;
  run.tuned = {!(limit < 0.88), 0.31, ""};
  return facts;
}

TEST(Verdict, OfATunedRunSaysWhatGotBetterAndThatNothingIsViolated) {
  const Verdict verdict = verdict_of(tuned_data(), tuned_facts(0.9));
  EXPECT_THAT(
      verdict.sentence,
      AllOf(HasSubstr("falls by 69 %"), HasSubstr("the largest orientation error falls by 83 %"),
            HasSubstr("wrist comes closest"), HasSubstr("88 %"), HasSubstr("every constraint holds")));
  EXPECT_THAT(verdict.details,
              testing::Contains(
                  AllOf(HasSubstr("RMS torque rate (effort_rate/rms) rises by 50 %"), HasSubstr("in a"))));
  EXPECT_THAT(verdict.details,
              testing::Contains("The price: the smallest obstacle clearance falls by 50 %, from "
                                "0.2 to 0.1 m, in a"))
      << "though the study does not ask for it";
}

TEST(Verdict, NamesALimitOfTheArmThatTheStudyDoesNotAskFor) {
  ReportData data = tuned_data();
  data.tables = tables_of({errors_of({result_of("a", {{Metric::kJointEffortMaxRatio, 0.6}})}),
                           errors_of({result_of("a", {{Metric::kJointEffortMaxRatio, 1.07}})})});
  EXPECT_THAT(verdict_of(data, tuned_facts(0.9)).sentence,
              AllOf(HasSubstr("every constraint holds, but the arm's own limits do not"),
                    HasSubstr("joint_effort/max_ratio is 1.07 in a")));
}

TEST(Verdict, TellsABrokenLimitOnce) {
  ReportData data = tuned_data();
  data.tables = tables_of({errors_of({result_of("a", {{Metric::kJointVelocityMaxRatio, 0.6}})}),
                           errors_of({result_of("a", {{Metric::kJointVelocityMaxRatio, 1.2}})})});
  const Verdict verdict = verdict_of(data, tuned_facts(0.8));
  EXPECT_THAT(verdict.details, testing::Contains(HasSubstr("is 1.2 in a (must be at most 0.8)")));
  EXPECT_THAT(verdict.details, Not(testing::Contains(HasSubstr("at most 1)"))));
}

TEST(Verdict, OfFilesThatCannotBeReadIsNotThatAllIsWell) {
  for (const RunKind kind : {RunKind::kSimulate, RunKind::kCompare, RunKind::kPareto, RunKind::kRobustness}) {
    ReportData data;
    data.kind = kind;
    data.sets = {"one", "two"};
    EXPECT_THAT(verdict_of(data, {}).sentence, HasSubstr("could not be read")) << name(kind);
  }
}

TEST(Verdict, OfAStudyOnManyArmsIsOfWhatItWasJudgedBy) {
  ReportData data = tuned_data();
  data.judged = {
      "worst of 4 arms in each scenario",
      tables_of({errors_of({result_of("a", {{Metric::kOrientationMax, 0.8}})}),
                 errors_of({result_of(
                     "a", {{Metric::kOrientationMax, 0.4}, {Metric::kJointVelocityMaxRatio, 0.97}}, "")})})};
  VerdictFacts facts = tuned_facts(1.0);
  facts.study->terms = {{Metric::kOrientationMax, {"a"}}};
  const Verdict verdict = verdict_of(data, facts);
  EXPECT_THAT(verdict.sentence, AllOf(HasSubstr("orientation error falls by 50 %"),
                                      HasSubstr("a joint comes closest to its velocity limit, 97 %")));
  EXPECT_THAT(verdict.details, testing::Contains(HasSubstr("worst of 4 arms in each scenario")));
}

TEST(Verdict, OfARunWithoutItsLastFileSaysThatItIsNotFinished) {
  ReportData data;
  data.kind = RunKind::kTune;
  data.sets = {"start", "tuned"};
  data.evaluations.emplace();
  data.evaluations->objective = {1.0, 0.4};
  data.evaluations->feasible = {false, false};
  data.evaluations->violation = {0.2, 0.1};
  data.evaluations->chosen = 1;
  VerdictFacts facts;
  facts.ended = false;
  facts.resumable = true;
  const Verdict killed = verdict_of(data, facts);
  EXPECT_THAT(killed.sentence,
              AllOf(HasSubstr("not finished"), HasSubstr("none of 2 evaluations is feasible"),
                    Not(HasSubstr("every constraint holds"))));
  EXPECT_THAT(killed.details, testing::Contains(HasSubstr("armtune tune --resume")));
  data.evaluations->feasible = {true, true};
  EXPECT_THAT(verdict_of(data, facts).sentence, HasSubstr("objective of 0.4"));
}

TEST(Verdict, WithoutAFeasiblePointSaysSoFirstAndNamesTheConstraint) {
  const Verdict verdict = verdict_of(tuned_data(), tuned_facts(0.8));
  EXPECT_THAT(verdict.sentence, AllOf(testing::StartsWith("No feasible point was found"),
                                      HasSubstr("joint_velocity/max_ratio is 0.88 in b"),
                                      Not(HasSubstr("every constraint holds"))));
}

TEST(Verdict, OfAnInterruptedRunSaysSoFirst) {
  VerdictFacts facts = tuned_facts(0.9);
  facts.record->search->ended = SearchEnd::kInterrupted;
  facts.record->search->reason = "stopped by a signal";
  EXPECT_THAT(verdict_of(tuned_data(), facts).sentence, testing::StartsWith("Interrupted"));
  facts.record->search->ended = SearchEnd::kEvaluations;
  facts.record->search->reason = "the phase 'interrupted' used up its budget";
  EXPECT_THAT(verdict_of(tuned_data(), facts).sentence, Not(HasSubstr("Interrupted")));
}

TEST(Verdict, OfARunThatGotNoBetterDoesNotSayItDid) {
  ReportData data = tuned_data();
  data.tables = tables_of({errors_of({result_of("a", {{Metric::kOrientationMax, 0.1}})}),
                           errors_of({result_of("a", {{Metric::kOrientationMax, 0.2}})})});
  VerdictFacts facts = tuned_facts(0.9);
  facts.record->tuned->objective = 1.2;
  const Verdict verdict = verdict_of(data, facts);
  EXPECT_THAT(verdict.sentence, AllOf(HasSubstr("did not improve"), Not(HasSubstr("falls by"))));
}

TEST(Verdict, OfASimulationSaysWhatFailed) {
  ReportData data;
  data.kind = RunKind::kSimulate;
  data.sets = {"published"};
  data.tables = tables_of({errors_of(
      {result_of("good", {{Metric::kPositionMax, 0.002}, {Metric::kOrientationMax, 0.0349065850398866}}),
       result_of("bad", {}, "", RolloutStatus::kDiverged)})});
  const Verdict verdict = verdict_of(data, {});
  EXPECT_THAT(verdict.sentence, AllOf(HasSubstr("1 of 2 scenarios failed: bad: diverged"), HasSubstr("2 mm"),
                                      HasSubstr("2 deg")));
}

TEST(Verdict, OfAComparisonIsOfTheLastSetAgainstTheFirst) {
  ReportData data = tuned_data();
  data.kind = RunKind::kCompare;
  EXPECT_THAT(verdict_of(data, {}).sentence,
              AllOf(testing::StartsWith("Compared with start, tuned is better in"),
                    HasSubstr("the largest orientation error falls by 83 %"),
                    HasSubstr("the smallest obstacle clearance falls by 50 %")));
}

TEST(Verdict, OfManyArmsIsTheirYield) {
  ReportData data;
  data.kind = RunKind::kRobustness;
  data.sets = {"gains"};
  data.robustness.emplace();
  data.robustness->samples = 200;
  data.robustness->kept = 150;
  data.robustness->interval = {0.68, 0.81};
  data.robustness->broken = {{"limit x in a", 40}, {"limit y in a", 12}};
  EXPECT_THAT(
      verdict_of(data, {}).sentence,
      AllOf(HasSubstr("75.0 % of 200 arms"), HasSubstr("68.0 to 81.0 %"), HasSubstr("limit x in a, by 40")));
  data.robustness->samples = 0;
  EXPECT_THAT(verdict_of(data, {}).sentence, HasSubstr("Interrupted"));
}

TEST(Verdict, OfAFrontCountsThePointsThatBeatTheStart) {
  ReportData data;
  data.kind = RunKind::kPareto;
  data.sets = {"start"};
  data.front.emplace();
  data.front->criteria = {{"objective", "1"}, {"obstacle/min_clearance", "m"}};
  data.front->points = {{{0.5, 0.3}, "point 1", true, "chosen"},  // better in both: more clearance is better
                        {{0.4, 0.1}, "point 2", true, "point"},
                        {{1.0, 0.2}, "start", true, "start"}};
  data.front->hypervolume = 0.25;
  EXPECT_THAT(verdict_of(data, {}).sentence,
              AllOf(HasSubstr("2 points (dominating the start: 1)"),
                    HasSubstr("objective from 0.4 to 0.5 (start 1)"), HasSubstr("hypervolume 0.25")));
  data.front->points.erase(data.front->points.begin(), data.front->points.begin() + 2);
  EXPECT_THAT(verdict_of(data, {}).sentence, HasSubstr("No feasible point was found"));
}

}  // namespace report_verdict_test
}  // namespace armtune::internal::report

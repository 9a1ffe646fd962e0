#include "tuner/gains/gains_origin.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/support/files.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_record.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {
namespace gains_origin_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Key;
using testing::Not;
using testing::Pair;

RunRecord tuning() {
  RunRecord run;
  run.kind = RunKind::kTune;
  run.command = "armtune tune mine";
  run.date = "2026-11-25";
  run.seed = 7;
  run.workers = 2;
  SearchFacts& search = run.search.emplace();
  search.study = "mine.yaml";
  search.start = "published";
  search.engine = Engine::kNative;
  search.evaluations = 123;
  run.tuned = {true, 0.25, ""};
  run.versions = {{"eigen", "3.4.0"}, {"armtune", "0.1.0"}};
  run.arithmetic = {"baseline", "fnv1a-0"};
  run.inputs = {{"arm.urdf", "fnv1a-1", ""}, {"b/c.yaml", "fnv1a-2", "inputs/01_c.yaml"}};
  return run;
}

TEST(GainsOrigin, OfARunIsWhatItsFilesSay) {
  const test::TemporaryFolder run;
  run.write(kRunRecord, run_record_json(tuning()));
  run.write(
      "errors.csv",
      "scenario,status,joint_velocity/max_ratio,joint_velocity/max_ratio_joint,joint_position/min_margin\n"
      "a,completed,0.25,elbow,1.5\nb,completed,0.75,wrist,0.5\nc,diverged,,,\nd,completed,0.5,base,2\n");
  run.write("margins.csv",
            "margin,unit,scenario,nominal,stands,fails,reason\n"
            "torque_delay,periods,a,0,3,4,x\ntorque_delay,periods,all,0,2,3,b: saturated\n"
            "gain_factor,1,all,1,,1,a: did not complete\nvelocity_noise,rad/s,all,0.01,64,,\n"
            "control_rate,Hz,all,500,10,,\n");
  const auto origin = origin_of_run(run.path());
  EXPECT_THAT(origin, Contains(Pair("command", "armtune tune mine")));
  EXPECT_THAT(origin, Contains(Pair("study", "mine.yaml")));
  EXPECT_THAT(origin, Contains(Pair("seed", "7")));
  EXPECT_THAT(origin, Contains(Pair("version", "0.1.0")));
  EXPECT_THAT(origin, Contains(Pair("date", "2026-11-25")));
  EXPECT_THAT(origin, Contains(Pair("start gains", "published")));
  EXPECT_THAT(origin, Contains(Pair("engine of the search", "native")));
  EXPECT_THAT(origin, Contains(Pair("evaluations", "123")));
  EXPECT_THAT(origin, Contains(Pair("objective", "0.25")));
  EXPECT_THAT(origin, Contains(Pair("feasible", "true")));
  EXPECT_THAT(origin, Contains(Pair("arithmetic", "fnv1a-0")));
  EXPECT_THAT(origin, Contains(Pair("input arm.urdf", "fnv1a-1")));
  EXPECT_THAT(origin, Contains(Pair("input b/c.yaml", "fnv1a-2")));
  // The worst: the largest of what is used of a limit, the least of the way to one.
  EXPECT_THAT(origin, Contains(Pair("joint_velocity/max_ratio",
                                    testing::AllOf(HasSubstr("0.75"), HasSubstr("in b, wrist")))));
  EXPECT_THAT(origin, Contains(Pair("joint_position/min_margin",
                                    testing::AllOf(HasSubstr("0.5"), HasSubstr("in b")))));
  EXPECT_THAT(origin, Not(Contains(Key("joint_effort/max_ratio")))) << "the run does not say";
  EXPECT_THAT(origin, Contains(Pair("margin/torque_delay", "2 periods; limited by b: saturated")));
  EXPECT_THAT(origin, Contains(Pair("margin/gain_factor", "none; limited by a: did not complete")));
  EXPECT_THAT(origin, Contains(Pair("margin/velocity_noise", ">= 64 rad/s"))) << "nothing failed";
  EXPECT_THAT(origin, Contains(Pair("margin/control_rate", "<= 10 Hz")));
  EXPECT_EQ(std::count_if(origin.begin(), origin.end(),
                          [](const auto& row) { return row.first.starts_with("margin/"); }),
            4);
  run.write("gains.yaml", "a: 1\n");
  EXPECT_THAT(origin_of_run(run.path()), Contains(Pair("gains file", hash_of_file(run / "gains.yaml"))));
  EXPECT_THAT(origin, Not(Contains(Key("workers")))) << "says nothing of the gains";
}

TEST(GainsOrigin, SaysWhichSimulationChecksFailed) {
  const test::TemporaryFolder run;
  run.write(kRunRecord, run_record_json(tuning()));
  EXPECT_THAT(origin_of_run(run.path()), Contains(Pair("simulation checks", "not made")));
  SimulationVerdict verdict;
  for (const CheckKind kind : {CheckKind::kVelocityLimit, CheckKind::kYield, CheckKind::kEndurance})
    verdict.checks.push_back({.kind = kind, .passed = true});
  run.write("verdict.yaml", verdict_yaml(verdict));
  EXPECT_THAT(origin_of_run(run.path()), Contains(Pair("simulation checks", "passed")));
  EXPECT_EQ(failed_checks(run.path()), "");
  verdict.checks[1].passed = verdict.checks[2].passed = false;
  run.write("verdict.yaml", verdict_yaml(verdict));
  EXPECT_THAT(origin_of_run(run.path()), Contains(Pair("simulation checks", "failed: yield, endurance")));
  EXPECT_EQ(failed_checks(run.path()), "yield, endurance");
  EXPECT_THAT(origin_of_run(run.path(), false), Not(Contains(Key("simulation checks"))))
      << "the run's checks are of other gains";
}

TEST(GainsOrigin, TellsNoFiguresOfGainsThatWereChangedAfterTheRun) {
  const test::TemporaryFolder run;
  const std::string gains = run.write("gains.yaml", "a: 1\n");
  RunRecord record = tuning();
  record.tuned->gains_hash = hash_of_file(gains);
  run.write(kRunRecord, run_record_json(record));
  EXPECT_THAT(origin_of_run(run.path()), AllOf(Contains(Key("objective")), Not(Contains(Key("warning")))));
  run.write("gains.yaml", "a: 2\n");
  const auto changed = origin_of_run(run.path());
  EXPECT_THAT(changed, AllOf(Contains(Key("warning")), Contains(Pair("command", "armtune tune mine"))));
  for (const char* figure : {"objective", "feasible", "simulation checks", "limits"})
    EXPECT_THAT(changed, Not(Contains(Key(figure)))) << figure;
  // The same for gains that `simulate` wrote.
  record.search.reset();
  record.tuned.reset();
  record.simulation = {Stepper::kMidpoint, Engine::kSimbody, "fnv1a-of other gains"};
  run.write(kRunRecord, run_record_json(record));
  EXPECT_THAT(origin_of_run(run.path()),
              AllOf(Contains(Key("warning")), Contains(Pair("engine", "simbody"))));
}

TEST(GainsOrigin, AFolderOfARunIsOneWithARecordAndAStudy) {
  const test::TemporaryFolder run;
  run.write("study.yaml", "");
  run.write(kOldRunRecord, "");
  EXPECT_EQ(run_above(run / "start"), "") << "of an older armtune";
  run.write(kRunRecord, "");
  EXPECT_EQ(run_above(run / "start"), run.path());
}

TEST(GainsOrigin, OfAFolderWithGainsAloneIsEmpty) {
  const test::TemporaryFolder run;
  EXPECT_TRUE(origin_of_run(run.path()).empty());
}

TEST(GainsOrigin, OfFilesIsTheirHashes) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("gains.yaml", "a: 1\n");
  EXPECT_THAT(origin_of_files({file}), Contains(Pair(HasSubstr("gains.yaml"), hash_of_file(file))));
}

}  // namespace gains_origin_test
}  // namespace armtune::internal

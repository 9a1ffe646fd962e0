#include "tuner/gains/gains_origin.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/support/files.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {
namespace gains_origin_test {

using testing::Contains;
using testing::HasSubstr;
using testing::Key;
using testing::Not;
using testing::Pair;

TEST(GainsOrigin, OfARunIsWhatItsFilesSay) {
  const test::TemporaryFolder run;
  run.write(
      "run.yaml",
      "command: \"armtune tune mine\"\ndate: \"2026-11-25\"\nseed: 7\nworkers: 2\nstudy: \"mine.yaml\"\n"
      "versions:\n  armtune: \"0.1.0\"\ninputs:\n  \"arm.urdf\": fnv1a-1\n  \"b/c.yaml\": fnv1a-2\n");
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
  run.write("run.yaml", "command: \"armtune tune mine\"\n");
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

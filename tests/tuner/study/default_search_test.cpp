// How a study searches that does not say so.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace default_search_test {

using test::ShortStudy;

TEST(DefaultSearch, OfAStudyThatNamesNoAlgorithmHasTwoPhases) {
  const auto study = [](const std::string& search) {
    const ShortStudy files(test::kShortParameters, test::kShortObjective, "", search);
    return load_study(files.path());
  };
  for (const char* silent : {"", "search: {max_evaluations: 20, seed: 4}\n"}) {
    const Study s = study(silent);
    EXPECT_FALSE(algorithm_from_name(global_of(s)).local);
    EXPECT_TRUE(algorithm_from_name(s.solver.algorithm).local);
    EXPECT_EQ(s.solver.constraints, ConstraintHandling::kPenalty);
  }
  EXPECT_EQ(study("search: {constraints: lagrangian}\n").solver.constraints, ConstraintHandling::kLagrangian);
  EXPECT_EQ(global_of(study("search: {global: ESCH}\n")), "ESCH");

  const Study named = study("search: {algorithm: BOBYQA}\n");
  EXPECT_EQ(global_of(named), "");
  EXPECT_EQ(named.solver.algorithm, "BOBYQA");
  EXPECT_EQ(named.solver.constraints, ConstraintHandling::kAuto);
}

TEST(DefaultSearch, OfPositionsAloneLeavesGainsOfTheOrientationOut) {
  const ShortStudy files("", "objective: [{metric: error/position/rms}]\n", "");
  const auto names = [&files](const std::string& mask) {
    files.write("short.yaml", "base: moving_target\nduration: 8\ntask_mask: " + mask + "\n");
    files.write("short_realistic.yaml", "base: realistic_moving_target\nduration: 8\ntask_mask: position\n");
    std::vector<std::string> all;
    for (const Parameter& p : load_study(files.path()).space.free) all.push_back(p.entry.name);
    return all;
  };
  for (const char* rotation : {"task_space_gains_p/rx", "task_space_gains_i/rz", "slerpDurationErrorGain"}) {
    EXPECT_THAT(names("pose"), testing::Contains(rotation)) << "one scenario of two";
    EXPECT_THAT(names("position"), testing::Not(testing::Contains(rotation)));
  }
  for (const char* position :
       {"task_space_gains_p/x", "task_space_gains_d/wrist_3_joint", "trajectoryDurationErrorGain"})
    EXPECT_THAT(names("position"), testing::Contains(position));
}

TEST(DefaultSearch, AWarmStartGoesWithoutAGlobalSearchThatNobodyNamed) {
  const auto study = [](const std::string& search) {
    const ShortStudy files(test::kShortParameters, test::kShortObjective, "",
                           search + "warm_start: {from: gains.yaml}\n");
    const Study warm = load_study(files.path());
    files.write("kept.yaml", gains_yaml(warm.warm->gains, {}));
    const std::string text = study_yaml(warm, "gains.yaml", "kept.yaml");
    EXPECT_EQ(global_of(load_study(files.write("resolved.yaml", text))), global_of(warm)) << text;
    return warm;
  };
  EXPECT_EQ(global_of(study("")), "");
  EXPECT_EQ(global_of(study("search: {global: DIRECT_L}\n")), "DIRECT_L");
}

}  // namespace default_search_test
}  // namespace armtune::internal

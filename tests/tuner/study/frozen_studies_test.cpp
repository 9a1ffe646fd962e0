// The studies on which searches are compared stay as they are.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/core/support/source_dir.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace frozen_studies_test {

struct FrozenStudy {
  const char* name;
  std::size_t gains;
};

class FrozenStudies : public testing::TestWithParam<FrozenStudy> {};

TEST_P(FrozenStudies, TuneThePublishedLawOnNominalArmsInFourScenarios) {
  const auto [name, gains] = GetParam();
  const Study study = load_study(test::source_dir() + "/benchmarks/studies/" + name + ".yaml");
  EXPECT_EQ(study.space.free.size(), gains);
  EXPECT_TRUE(study.space.links.empty());
  EXPECT_EQ(study.gains.substr(study.gains.rfind('/') + 1), "published.yaml");
  EXPECT_EQ(study.space.start.controller, "adaptive");
  EXPECT_EQ(study.space.start.adaptation_filter, 0.0);
  EXPECT_EQ(study.space.start.adaptation_leakage, 0.0);
  EXPECT_EQ(study.space.start.roll_centering_gain, 0.0);
  EXPECT_FALSE(study.robust.has_value());
  EXPECT_FALSE(study.warm.has_value());
  EXPECT_TRUE(study.margins.empty());
  EXPECT_TRUE(study.sweep.empty());
  EXPECT_EQ(study.terms.size(), 6U);
  EXPECT_EQ(study.constraints.size(), 4U);
  EXPECT_EQ(study.engine, Engine::kSimbody);
  EXPECT_EQ(study.solver.algorithm, "COBYLA");
  EXPECT_EQ(global_of(study), "DIRECT_L");
  EXPECT_EQ(study.max_evaluations, 300);
  EXPECT_EQ(study.solver.seed, 1U);
  ASSERT_EQ(study.scenarios.size(), 4U);
  double seconds = 0.0;
  for (const Scenario& scenario : study.scenarios) {
    seconds += scenario.duration;
    EXPECT_EQ(scenario.control_period, 0.002);
    EXPECT_EQ(scenario.robot->n(), 6);
    EXPECT_EQ(scenario.robot->chain.link_radius.size(), 0) << "obstacles act on joint origins";
    EXPECT_EQ(scenario.clearance, nullptr) << "no distances in a cell";
    EXPECT_TRUE((scenario.robot->chain.rotor_inertia.array() == 0.1).all());
    const double noise = scenario.name == "moving_target" ? 0.0 : 0.01;
    EXPECT_EQ(scenario.plant.velocity_noise, noise);
    EXPECT_EQ(scenario.plant.payload.mass, noise > 0.0 ? 1.0 : 0.0);
    // Copies, so that changes of the bundled scenarios leave the problem as it is.
    for (const std::string& input : scenario.inputs) {
      const bool copied = input.find("/scenarios/ur10_nominal/") != std::string::npos;
      EXPECT_TRUE(copied || input.ends_with("/ur10.urdf")) << input;
    }
  }
  EXPECT_DOUBLE_EQ(seconds, 180.0);
}

TEST(FrozenStudiesBounds, AreThoseOfTheMeasuredStudy) {
  const Study study = load_study(test::source_dir() + "/benchmarks/studies/ur10_gaze_nominal.yaml");
  for (const Parameter& p : study.space.free) {
    const std::string field = p.entry.field->name;
    if (field == "task_space_gains_i") {
      const double Kp = study.space.start.task_space_gains_p[static_cast<Eigen::Index>(p.entry.component)];
      EXPECT_EQ(p.scale, Scale::kLinear);
      EXPECT_EQ(p.lower, 0.0);
      EXPECT_DOUBLE_EQ(p.upper, Kp * Kp / 4.0);
      continue;
    }
    EXPECT_EQ(p.scale, Scale::kLog) << p.entry.name;
    const bool of_duration = field.ends_with("DurationErrorGain");
    EXPECT_DOUBLE_EQ(p.upper / p.start, of_duration ? 3.0 : 6.0) << p.entry.name;
    EXPECT_DOUBLE_EQ(p.start / p.lower, field == "slerpDurationErrorGain" ? 10.0 : 6.0) << p.entry.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Both, FrozenStudies,
                         testing::Values(FrozenStudy{"ur10_gaze_nominal", 20},
                                         FrozenStudy{"ur10_all_nominal", 40}),
                         [](const auto& study) { return study.param.name; });

}  // namespace frozen_studies_test
}  // namespace armtune::internal

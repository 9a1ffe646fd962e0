#include "tuner/controller_study/tuned_parameters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/control/laws/first_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/joint_trajectory_example.hpp"
#include "tuner/controller_study/controller_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace tuned_parameters_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

using test::changed_example;
using test::example;

// As in files that were made for a simulator: without any damping a stiff joint shakes.
TEST(ControllerStudy, DampingThatIsZeroIsTunedWhereTheFileHasANumberForIt) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write(
      "p.yaml", changed_example("wrist_1_joint: {p: 300.0, d: 10.0", "wrist_1_joint: {p: 300.0, d: 0"));
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "a").value();
  EXPECT_THAT(files.notes, Contains(AllOf(HasSubstr("d of wrist_1_joint is 0"), HasSubstr("p.yaml"))));
  const Study study = load_study(files.study);
  EXPECT_EQ(study.space.free.size(), 18U);
  const auto damping = std::find_if(study.space.free.begin(), study.space.free.end(),
                                    [](const Parameter& p) { return p.entry.name == "jtc_d/wrist_1_joint"; });
  ASSERT_NE(damping, study.space.free.end());
  EXPECT_EQ(damping->start, 0.0);
  EXPECT_EQ(damping->lower, 0.0);
  // Five times what is critically damped at the rate of first gains.
  const Scenario& scenario = study.scenarios.front();
  const JointVector inertia = joint_inertia(*scenario.robot, scenario.planned->at(0.0).position);
  EXPECT_NEAR(damping->upper, 5.0 * kFirstRate * inertia[3], 1e-3 * damping->upper);
  // A file without the number could not be given one.
  inputs.controllers = folder.write(
      "none.yaml", changed_example("wrist_1_joint: {p: 300.0, d: 10.0,", "wrist_1_joint: {p: 300.0,"));
  EXPECT_EQ(load_study(write_controller_study(inputs, folder / "b").value().study).space.free.size(), 17U);
}

// Of a PD controller, and of one whose wrists have no integral: what is 0 stays 0.
TEST(ControllerStudy, GainsThatAreZeroAreNotTuned) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers =
      folder.write("pd.yaml", changed_example("p: 300.0, d: 10.0, i: 50.0", "p: 300.0, d: 10.0, i: 0.0"));
  const Study study = load_study(write_controller_study(inputs, folder / "a").value().study);
  EXPECT_EQ(study.space.free.size(), 17U);
  EXPECT_EQ(study.space.start.own[1][3], 0.0);
}

}  // namespace tuned_parameters_test
}  // namespace armtune::internal

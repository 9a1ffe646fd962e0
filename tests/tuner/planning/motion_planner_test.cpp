// Studies that a program makes from the files of a robot, with planned motions.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "armtune/error.hpp"
#include "armtune/plan.hpp"
#include "armtune/study.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/joint_trajectory_example.hpp"

namespace armtune {
namespace motion_planner_test {

TEST(StudyFromControllers, PlansMotionsWithThePlannerOnly) {
  const internal::test::TemporaryFolder folder;
  const std::string goals = folder.write(
      "goals.csv",
      "shoulder_pan_joint,shoulder_lift_joint,elbow_joint,wrist_1_joint,wrist_2_joint,wrist_3_joint\n"
      "0,-90,60,-60,-90,0\n30,-70,60,-60,-90,0\n");
  ControllerStudyOptions options;
  options.folder = folder / "made";
  options.degrees = true;
  const auto make = [&] {
    return Study::from_controllers("ur5e", internal::test::kExample + "ros2_controllers.yaml", {goals},
                                   options);
  };
  EXPECT_THAT(make, internal::test::refused_at({.file = goals}));
  options.planner = motion_planner();
  const std::atomic<bool> stop{true};
  options.watch.stop = &stop;
  EXPECT_THROW(make(), FailedError);
  EXPECT_FALSE(std::filesystem::exists(options.folder));
  options.watch.stop = nullptr;
  std::vector<long> moves;
  options.watch.progress = [&](const Progress& at) { moves.push_back(at.all); };
  EXPECT_EQ(make().scenarios().size(), 1U);
  EXPECT_THAT(moves, testing::ElementsAre(1));
}

}  // namespace motion_planner_test
}  // namespace armtune

// Studies for users without a ROS parameter file, and the motions of studies.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

#include "core/control/laws/controller_kind.hpp"
#include "core/robot/kinematics.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/joint_trajectory_example.hpp"
#include "tuner/controller_study/controller_in_file.hpp"
#include "tuner/controller_study/controller_study.hpp"
#include "tuner/session/study_files.hpp"
#include "tuner/session/tune_files.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace own_controller_study_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

using test::example;
using test::kExample;

// Without a parameter file the start gains are computed from the arm, and the rate must be given.
TEST(OwnControllerStudy, StartsWithGainsOfItsOwnWithoutAParameterFile) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers.clear();
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder / "none"); }),
              AllOf(HasSubstr("--controllers"), HasSubstr("--controller")));
  inputs.kind = "position_streaming";
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder / "none"); }), HasSubstr("--rate"));
  inputs.rate = 500.0;
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.written, UnorderedElementsAre("study.yaml", "gains.yaml", "moves.yaml"));
  const Study servo = load_study(files.study);
  EXPECT_EQ(servo.scenarios.front().control_period, 0.002);
  EXPECT_EQ(servo.space.start.controller, "position_streaming");
  EXPECT_EQ(servo.space.start.velocity_margin, 0.0) << "such a robot has no velocity governor of armtune's";
  ASSERT_EQ(servo.space.free.size(), 2U);
  EXPECT_EQ(servo.space.free[0].lower, 100.0);
  EXPECT_EQ(servo.space.free[0].upper, 2000.0);
  EXPECT_EQ(servo.space.free[1].lower, 0.03);
  EXPECT_EQ(servo.space.free[1].upper, 0.2);

  // At any rate of the commands, the drives run at 1 kHz or faster. Far larger gains than the assumed ones
  // are too fast for that.
  inputs.rate = 130.0;
  EXPECT_THAT(write_controller_study(inputs, folder / "slow").value().notes,
              testing::Not(Contains(HasSubstr("too fast"))));
  inputs.robot =
      folder.write("arm.yaml", "urdf: " + test::source_dir() +
                                   "/examples/ur5e/ur5e.urdf\nrotor_inertia: [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]\n"
                                   "drive_velocity_gain: [400, 400, 400, 400, 400, 400]\n");
  EXPECT_THAT(write_controller_study(inputs, folder / "stiff").value().notes,
              Contains(AllOf(HasSubstr("too fast for its rate of 1040 Hz"), HasSubstr("velocity_gain"))));
  inputs.robot = folder.write("fast.yaml",
                              "urdf: " + test::source_dir() +
                                  "/examples/ur5e/ur5e.urdf\nrotor_inertia: [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]\n"
                                  "drives: {velocity_gain: 400, rate: 26000}\n");
  EXPECT_THAT(write_controller_study(inputs, folder / "fast").value().notes,
              testing::Not(Contains(HasSubstr("too fast"))))
      << "at the rate of its drives";
  inputs = example();
  inputs.controllers.clear();
  inputs.rate = 500.0;

  for (const std::string& kind : joint_motion_controllers()) {
    inputs.kind = kind;
    const Study study = load_study(write_controller_study(inputs, folder / kind).value().study);
    EXPECT_EQ(study.space.start.controller, kind);
    EXPECT_GE(study.space.free.size(), 2U) << kind;
  }
  inputs.kind = "adaptive";
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder / "other"); }),
              AllOf(HasSubstr("adaptive"), HasSubstr("position_streaming")));
  inputs.kind = "position_streming";
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder / "other"); }),
              HasSubstr("position_streaming"));
  EXPECT_FALSE(std::filesystem::exists(folder / "other"));
}

// Of a file that armtune does not know, the numbers that a map names are tuned, and no others.
TEST(OwnControllerStudy, TunesWhatAMapBindsToGains) {
  const test::TemporaryFolder folder;
  folder.write("own.yaml",
               "stiff: [300.0, 300.0, 300.0, 100.0, 100.0, 100.0]\nelbow: 25.0\nupdate_rate: 500\n");
  ControllerStudyInputs inputs = example();
  inputs.controllers =
      folder.write("map.yaml",
                   "controller: joint_impedance\nfile: own.yaml\nmap: {stiff: joint_impedance_k, "
                   "elbow: joint_impedance_d/elbow_joint}\njoint_impedance_d: 12\n");
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder / "none"); }), HasSubstr("--rate"));
  inputs.rate = 500.0;
  inputs.max_stiffness = {1500.0};
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.notes,
              Contains(AllOf(HasSubstr("own.yaml"), HasSubstr("shoulder_pan_joint, shoulder_lift"))));
  const Study study = load_study(files.study);
  EXPECT_THAT(files_of(study), Contains(folder / "own.yaml"));
  ASSERT_EQ(study.space.free.size(), 7U);
  EXPECT_EQ(study.space.free.back().entry.name, "joint_impedance_d/elbow_joint");
  EXPECT_EQ(study.space.free.back().upper, 125.0);
  Gains gains = study.space.start;
  EXPECT_EQ(own(gains, "joint_impedance_d")[0], 12.0);
  own(gains, "joint_impedance_k")[1] = 432.1;
  own(gains, "joint_impedance_d")[2] = 31.0;
  std::filesystem::create_directory(folder / "run");
  EXPECT_EQ(write_controllers(study, gains, folder / "run"), "own.yaml");
  EXPECT_EQ(test::read_text(folder / "run/own.yaml"),
            "stiff: [300.0, 432.1, 300.0, 100.0, 100.0, 100.0]\nelbow: 31.0\nupdate_rate: 500\n");
  own(gains, "joint_impedance_d")[0] = 13.0;
  EXPECT_THAT(test::refusal([&] { write_controllers(study, gains, folder / "run"); }),
              AllOf(HasSubstr("joint_impedance_d"), HasSubstr("in the map")));
}

// A gain that most controllers of the kind do not have is tuned where the map binds it.
TEST(OwnControllerStudy, TunesDampingRatiosThatAMapBinds) {
  const test::TemporaryFolder folder;
  folder.write("own.yaml",
               "stiff: [300.0, 300.0, 300.0, 100.0, 100.0, 100.0]\n"
               "ratios: [0.7, 0.7, 0.7, 0.5, 0.5, 0.0]\n");
  ControllerStudyInputs inputs = example();
  inputs.controllers =
      folder.write("map.yaml",
                   "controller: joint_impedance\nfile: own.yaml\nmap: {stiff: joint_impedance_k, "
                   "ratios: joint_impedance_damping_ratio}\njoint_impedance_d: 0\n");
  inputs.rate = 500.0;
  const Study study = load_study(write_controller_study(inputs, folder / "made").value().study);
  ASSERT_EQ(study.space.free.size(), 5U) << "not the one that is 0, and no stiffness";
  EXPECT_EQ(study.space.free[0].entry.name, "joint_impedance_damping_ratio/shoulder_pan_joint");
  EXPECT_DOUBLE_EQ(study.space.free[0].lower, 0.14);
  EXPECT_DOUBLE_EQ(study.space.free[4].upper, 2.5);
}

/// Six numbers of a Cartesian impedance controller, and a map that binds them.
std::string write_cartesian_map(const test::TemporaryFolder& folder) {
  folder.write("own.yaml",
               "stiffness: {translation: [900.0, 900.0, 900.0], rotation: {x: 30.0, y: 30.0, z: 30.0}}\n"
               "damping: [0.7, 0.7, 0.7, 0.7, 0.7, 0.7]\n");
  std::string map = "controller: cartesian_impedance\nfile: own.yaml\nrate: 1000\nmap:\n";
  const std::vector<std::string> axes = {"x", "y", "z"};
  for (std::size_t k = 0; k < axes.size(); ++k) {
    map += fmt::format("  stiffness/translation/{}: cartesian_impedance_k/{}\n", k, axes[k]);
    map +=
        fmt::format("  stiffness/rotation/{0}: {{gain: cartesian_impedance_k/r{0}, factor: 2}}\n", axes[k]);
  }
  return folder.write("map.yaml", map + "  damping: cartesian_impedance_damping_ratio\n");
}

// Such a controller follows the tool's path itself. The arm rests at the start before the tool moves.
TEST(OwnControllerStudy, OfCartesianImpedanceFollowsWaypointsOfTheTool) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs{"fr3", write_cartesian_map(folder), "", {}};
  inputs.trajectories = {folder.write("path.csv",
                                      "time,x,y,z,qw,qx,qy,qz\n0,0.5,0,0.4,0,1,0,0\n2,0.5,0.2,0.4,0,1,0,0\n"
                                      "4,0.5,0,0.4,0,1,0,0\n")};
  inputs.max_stiffness = {3000.0, 200.0};
  inputs.speed = 0.5;
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.written,
              UnorderedElementsAre("study.yaml", "path.yaml", "path_path.csv", "path_start.csv"));
  const Study study = load_study(files.study);
  const Scenario& scenario = study.scenarios.front();
  EXPECT_EQ(scenario.control_period, 0.001);
  EXPECT_TRUE(scenario.has_task());
  EXPECT_EQ(scenario.mask, TaskMask::kPose);
  Poses poses;
  forward_kinematics(scenario.robot->chain, scenario.start_position, poses);
  EXPECT_LT((poses.p_0T - Vec3(0.5, 0.0, 0.4)).norm(), 1e-3);
  EXPECT_LT((scenario.path.at(1.2 + 4.0).position - Vec3(0.5, 0.2, 0.4)).norm(), 1e-9) << "at half the speed";
  EXPECT_EQ(study.space.start.controller, "cartesian_impedance");
  EXPECT_EQ(own(study.space.start, "cartesian_impedance_k")[3], 60.0);
  ASSERT_EQ(study.space.free.size(), 12U) << "six of the stiffness, six of the damping";
  EXPECT_EQ(study.space.free[0].entry.name, "cartesian_impedance_k/x");
  EXPECT_EQ(study.space.free[0].upper, 3000.0);
  EXPECT_EQ(study.space.free[5].upper, 200.0);

  const RolloutResult result = Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(study.space.start);
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  EXPECT_LT(result.metrics[Metric::kPositionMax], 0.05) << "v D / K, and sagging by no more than that";
  EXPECT_GT(result.metrics[Metric::kPositionMax], 0.0);

  Gains tuned = study.space.start;
  own(tuned, "cartesian_impedance_k")[4] = 90.0;
  std::filesystem::create_directory(folder / "run");
  EXPECT_EQ(write_controllers(study, tuned, folder / "run"), "own.yaml");
  EXPECT_THAT(test::read_text(folder / "run/own.yaml"), HasSubstr("rotation: {x: 30.0, y: 45.0, z: 30.0}"));

  inputs.max_stiffness = {3000.0};
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "none"); },
              test::refused_at({.value = "1", .limit = "2 or 6"}));
  inputs.max_stiffness = {800.0, 200.0};
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "none"); },
              test::refused_at({.file = folder / "own.yaml", .value = "900", .limit = "at most 800"}));
}

// As in Franka's example: one number for all translations, and one for all rotations.
TEST(OwnControllerStudy, LinksTheGainsThatAMapBindsToOneNumber) {
  const test::TemporaryFolder folder;
  folder.write("own.yaml", "translational_stiffness: 200.0\nrotational_stiffness: 10.0\n");
  ControllerStudyInputs inputs{"fr3", "", "", {}};
  inputs.controllers = folder.write(
      "map.yaml",
      "controller: cartesian_impedance\nfile: own.yaml\nrate: 1000\ncartesian_impedance_damping_ratio: 1\nmap:\n"
      "  translational_stiffness: [cartesian_impedance_k/x, cartesian_impedance_k/y, cartesian_impedance_k/z]\n"
      "  rotational_stiffness: {gain: [cartesian_impedance_k/rx, cartesian_impedance_k/ry, "
      "cartesian_impedance_k/rz], factor: 2}\n");
  inputs.trajectories = {folder.write("path.csv", "time,x,y,z\n0,0.5,0,0.4\n2,0.5,0.2,0.4\n")};
  inputs.max_stiffness = {900.0, 400.0, 900.0, 60.0, 60.0, 60.0};
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.notes, Contains(AllOf(HasSubstr("own.yaml"), HasSubstr("in the map"),
                                          HasSubstr("cartesian_impedance_k of x, y, z"))));
  const Study study = load_study(files.study);
  ASSERT_EQ(study.space.free.size(), 1U) << "no motion turns the tool";
  EXPECT_EQ(study.space.free[0].entry.name, "cartesian_impedance_k/x");
  EXPECT_EQ(study.space.free[0].upper, 400.0) << "the least of the bounds";
  ASSERT_EQ(study.space.links.size(), 2U);
  EXPECT_EQ(study.space.links[1].entry.name, "cartesian_impedance_k/z");
  std::filesystem::create_directory(folder / "run");
  const Gains tuned = study.space.gains_at({1.0});
  EXPECT_EQ(write_controllers(study, tuned, folder / "run"), "own.yaml");
  EXPECT_EQ(test::read_text(folder / "run/own.yaml"),
            "translational_stiffness: 400.0\nrotational_stiffness: 10.0\n");
}

TEST(OwnControllerStudy, OfAPathWithoutOrientationsLeavesTheGainsOfRotations) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs{"fr3", write_cartesian_map(folder), "", {}};
  inputs.trajectories = {folder.write("path.csv", "time,x,y,z\n0,0.5,0,0.4\n2,0.5,0.2,0.4\n4,0.5,0,0.4\n")};
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  const Study study = load_study(files.study);
  EXPECT_EQ(study.scenarios.front().mask, TaskMask::kPosition);
  ASSERT_EQ(study.space.free.size(), 3U) << "the damping of translations";
  EXPECT_EQ(study.space.free[2].entry.name, "cartesian_impedance_damping_ratio/z");
  EXPECT_THAT(files.notes, Contains(HasSubstr("--max-stiffness")));
  // A motion of the joints says nothing about the gains of such a controller.
  inputs.trajectories = example().trajectories;
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "none"); },
              test::refused_at({.file = example().trajectories.front()}));
  // Without a file, the start gains follow from the arm.
  inputs.controllers.clear();
  inputs.kind = "cartesian_impedance";
  inputs.rate = 1000.0;
  inputs.trajectories = {folder / "path.csv"};
  const Study own_start = load_study(write_controller_study(inputs, folder / "own").value().study);
  EXPECT_EQ(own_start.space.start.controller, "cartesian_impedance");
  EXPECT_EQ(own_start.space.free.size(), 3U);
}

TEST(StudyMotions, MotionsInDegreesAreReadAsTheyAreSaidToBe) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  std::string header = "time";
  for (const std::string& joint : joint_names(*load_robot("ur5e"))) header += "," + joint;
  inputs.trajectories = {folder.write("deg.csv", header + "\n1,0,-90,90,0,0,0\n3,90,-90,90,0,0,0\n")};
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder / "a"); }),
              AllOf(HasSubstr("deg.csv:2"), HasSubstr("--degrees")));
  inputs.degrees = true;
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "a").value();
  EXPECT_DOUBLE_EQ(load_study(files.study).scenarios[0].planned->at(3.0).position[0], std::numbers::pi / 2);
  EXPECT_THAT(files.notes, Contains(HasSubstr("begins at 1 s")));
}

// Half the speed is the same way in twice the time, whether the motion has times or is planned.
TEST(StudyMotions, MotionsCanBeSlowedDown) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  const auto motion = [&](double speed) {
    inputs.speed = speed;
    const ControllerStudyFiles files =
        write_controller_study(inputs, folder / fmt::format("at_{}", speed)).value();
    return load_study(files.study).scenarios[0];
  };
  const Scenario fast = motion(1.0), slow = motion(0.5);
  EXPECT_NEAR(slow.planned->end(), 2.0 * fast.planned->end(), 1e-12);
  EXPECT_EQ(slow.planned->at(2.2).position, fast.planned->at(1.1).position);
  EXPECT_NEAR(slow.duration - 0.5, 2.0 * (fast.duration - 0.5), 1e-9);
  EXPECT_TRUE(slow.holds_goal());

  const JointSpline planned = *fast.planned;
  double asked = 0.0;
  inputs.timing = [&](const JointGoals& goals) {
    asked = goals.speed;
    return TimedGoals{planned, "of the robot, and slow already"};
  };
  std::string header;
  for (const std::string& joint : joint_names(*load_robot("ur5e")))
    header += (header.empty() ? "" : ",") + joint;
  inputs.trajectories = {folder.write("goals.csv", header + "\n0,-1,1,0,0,0\n1,-1,1,0,0,0\n")};
  inputs.speed = 0.5;
  write_controller_study(inputs, folder / "goals").value();
  EXPECT_EQ(asked, 0.5);
  EXPECT_EQ(test::read_text(folder / "goals/goals.yaml").find("speed:"), std::string::npos)
      << "the file with the motion is slow, so the scenario must not slow it down again";
  EXPECT_NE(test::read_text(folder / "at_0.5/moves.yaml").find("speed: 0.5"), std::string::npos);
}

}  // namespace own_controller_study_test
}  // namespace armtune::internal

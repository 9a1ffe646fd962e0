#include "sim/scenario/cell_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/common/input_file.hpp"
#include "core/control/obstacle_distance.hpp"
#include "sim/cell/clearance_model.hpp"
#include "sim/scenario/path_walk.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/scenario.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/core/support/states.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace cell_file_test {

using test::refused_at;
using testing::HasSubstr;

Cell cell(const std::string& text) {
  std::vector<std::string> inputs;
  return read_cell(yaml::parse_text(text, "cell.yaml"), inputs);
}

/// The error in cell.yaml with which this text is refused.
InputError error_of(const std::string& text) {
  const InputError error = test::input_error([&text] { cell(text); });
  EXPECT_EQ(error.place().file, "cell.yaml");
  return error;
}

TEST(CellFile, NoPartIsCalledAsTheFloorIs) {
  EXPECT_THAT(error_of("parts: [{name: the floor, sphere: {radius: 0.1}, center: [1, 0, 0]}]"),
              refused_at({.line = 1, .key = "parts/0/name", .value = "the floor", .limit = "another name"}));
}

TEST(CellFile, ANameThatNoTerminalCanShowIsRefused) {
  for (const char* name : {"\\e[33mpart", "a\\u2028b", "\\r"}) {
    const std::string part =
        fmt::format("parts: [{{name: \"{}\", sphere: {{radius: 0.1}}, center: [1, 0, 0]}}]", name);
    EXPECT_THAT(error_of(part), refused_at({.line = 1, .key = "parts/0/name", .limit = "a printable name"}));
  }
}

TEST(CellFile, HasAFloorAndPartsThatRestOrMove) {
  const Cell read = cell(
      "floor: -0.4\n"
      "parts:\n"
      "  - {name: table, box: [1.2, 0.8, 0.04], rpy_deg: [0, 0, 90], hold: [0.5, 0, -0.2]}\n"
      "  - {name: post, cylinder: {radius: 0.05, length: 1}, center: [0.4, 0.4, 0.5]}\n"
      "  - {name: rail, capsule: {radius: 0.02, length: 2}, center: [0, -0.5, 0]}\n"
      "  - {name: ball, sphere: {radius: 0.1}, circle: {center: [0, 0, 1], radius: 0.3, period: 4}}\n");
  EXPECT_EQ(read.floor, -0.4);
  ASSERT_EQ(read.parts.size(), 4U);
  const CellPart& table = read.parts[0];
  EXPECT_EQ(table.solid.kind, SolidKind::kBox);
  EXPECT_LT((table.R_0S * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_EQ(table.path.at(7.0).position, Vec3(0.5, 0.0, -0.2));
  EXPECT_EQ(read.parts[1].solid.kind, SolidKind::kCylinder);
  EXPECT_EQ(read.parts[1].solid.size.x(), 0.05);
  EXPECT_EQ(read.parts[2].solid.radius, 0.02);
  EXPECT_LT((read.parts[3].path.at(1.0).position - Vec3(0.0, 0.3, 1.0)).norm(), 1e-12);
}

TEST(CellFile, WhatIsNoCellIsNamed) {
  const auto refused = [](const std::string& part) {
    return error_of("parts:\n  - {name: a, " + part + "}\n");
  };
  const std::string shapes = "one of the keys: box, cylinder, capsule, sphere";
  EXPECT_THAT(refused("center: [0, 0, 0]"), refused_at({.line = 2, .key = "parts/0", .limit = shapes}));
  const InputError misspelt = refused("capsul: {radius: 1, length: 1}, center: [0, 0, 0]");
  EXPECT_THAT(misspelt, refused_at({.line = 2, .key = "parts/0", .limit = shapes}));
  EXPECT_THAT(misspelt.what(), HasSubstr("is 'capsul' a misspelling of 'capsule'?"));
  EXPECT_THAT(refused("box: [1, 1, 1], sphere: {radius: 1}, center: [0, 0, 0]"),
              refused_at({.line = 2, .key = "parts/0/sphere"}));
  const std::string length = "above 0 and at most 1000";
  EXPECT_THAT(refused("box: [1, 0, 1], center: [0, 0, 0]"),
              refused_at({.line = 2, .key = "parts/0/box", .value = "0", .limit = length}));
  EXPECT_THAT(refused("capsule: {radius: -1, length: 1}, center: [0, 0, 0]"),
              refused_at({.line = 2, .key = "parts/0/capsule/radius", .value = "-1", .limit = length}));
  EXPECT_THAT(refused("sphere: {radius: 1}"),
              refused_at({.line = 2, .key = "parts/0", .limit = "the key 'center'"}));
  EXPECT_THAT(
      refused(
          "sphere: {radius: 1}, center: [0, 0, 0]}\n  - {name: a, sphere: {radius: 1}, center: [0, 0, 0]"),
      refused_at({.line = 3, .key = "parts/1/name", .value = "a", .limit = "another name"}));
  EXPECT_THAT(error_of("flor: 0\n"),
              refused_at({.line = 1, .key = "flor", .value = "flor", .limit = "the keys: floor, parts"}));
  EXPECT_THAT(error_of("floor: 1e9\n"),
              refused_at({.line = 1, .key = "floor", .value = "1e9", .limit = "-1000 to 1000"}));
}

const std::string kRobot =
    "urdf: " + test::source_dir() + "/sim/robots/ur5e.urdf\nrotor_inertia: estimated\n";

TEST(RobotFile, AToolHasMassInertiaAndShapes) {
  const test::TemporaryFolder folder;
  const auto bare =
      load_robot(folder.write("bare.yaml", kRobot + "tool: {xyz: [0, 0, 0.1], rpy: [0, 1, 0]}\n"));
  const auto mounted = load_robot(folder.write(
      "tool.yaml", kRobot + "tool: {xyz: [0, 0, 0.1], rpy: [0, 1, 0], mass: 0.8, center: [0, 0.01, -0.05],\n"
                            "  moments: [0.002, 0, 0, 0.003, 0, 0.001],\n"
                            "  shapes: [{box: [0.1, 0.1, 0.2], center: [0, 0, -0.1]}]}\n"));
  EXPECT_EQ(mounted->chain.p_BT, bare->chain.p_BT);
  // Gravity of the tool's mass at its centre, wherever the arm is.
  std::mt19937 generator(1);
  for (int k = 0; k < 20; ++k) {
    const JointVector q = test::random_configuration(generator, *bare);
    const Poses poses = test::poses_at(bare->chain, q);
    const Vec3 center = poses.p_0T + poses.R_0T * Vec3(0.0, 0.01, -0.05);
    Jacobian J;
    point_jacobian(bare->chain, poses, 5, center, J);
    const JointVector expected = -J.topRows<3>().transpose() * (0.8 * bare->chain.gravity);
    const JointVector found =
        test::gravity_torque_at(mounted->chain, q) - test::gravity_torque_at(bare->chain, q);
    EXPECT_LT((found - expected).norm(), 1e-12);
  }
  // Its kinetic energy when the last joint turns alone: the moment about that joint's axis.
  const JointMatrix more = test::mass_matrix_at(mounted->chain, JointVector::Zero(6)) -
                           test::mass_matrix_at(bare->chain, JointVector::Zero(6));
  const Poses poses = test::poses_at(bare->chain, JointVector::Zero(6));
  const Vec3 axis = poses.R_0T.transpose() * poses.R_0B[5].col(2);
  const Vec3 arm = poses.p_0T + poses.R_0T * Vec3(0.0, 0.01, -0.05) - poses.p_0B[5];
  const Vec3 moments(0.002, 0.003, 0.001);
  const double expected =
      axis.dot(moments.cwiseProduct(axis)) + 0.8 * poses.R_0B[5].col(2).cross(arm).squaredNorm();
  EXPECT_NEAR(more(5, 5), expected, 1e-12);
  EXPECT_EQ(mounted->shapes.size(), bare->shapes.size() + 1);
  const Shape& shape = mounted->shapes.back();
  EXPECT_EQ(shape.body, 5);
  const Vec3 in_base = poses.p_0B[5] + poses.R_0B[5] * shape.p_BS;
  EXPECT_LT((in_base - poses.p_0T - poses.R_0T * Vec3(0.0, 0.0, -0.1)).norm(), 1e-12);
}

TEST(RobotFile, APayloadIsAPointMassThatTheControllerKnows) {
  const test::TemporaryFolder folder;
  const auto bare = load_robot(folder.write("bare.yaml", kRobot));
  const auto loaded =
      load_robot(folder.write("loaded.yaml", kRobot + "payload: {mass: 2, center: [0, 0, 0.1]}\n"));
  const RobotModel expected = with_payload(*bare, {2.0, Vec3(0.0, 0.0, 0.1)});
  EXPECT_EQ(loaded->chain.link[5].mass, expected.chain.link[5].mass);
  EXPECT_EQ(loaded->chain.link[5].inertia, expected.chain.link[5].inertia);
}

TEST(RobotFile, ShapesStandForTheCollisionGeometryOfALink) {
  const test::TemporaryFolder folder;
  const auto arm = load_robot(folder.write(
      "arm.yaml", kRobot + "shapes:\n  forearm_link:\n"
                           "    - {capsule: {radius: 0.05, from: [0, 0, 0.01], to: [-0.39, 0, 0.01]}}\n"));
  const ArmSolids solids = arm_solids(*arm);
  int found = 0;
  for (const ArmSolid& solid : solids.solids) {
    if (solid.link != "forearm_link") continue;
    ++found;
    EXPECT_EQ(solid.placed.solid.kind, SolidKind::kCapsule);
    EXPECT_NEAR(solid.placed.solid.size.x(), 0.39, 1e-12);
  }
  EXPECT_EQ(found, 1);
  const std::string wrong = folder.write("wrong.yaml", kRobot + "shapes: {elbow: [{sphere: {radius: 1}}]}\n");
  EXPECT_THAT([&] { load_robot(wrong); },
              refused_at({.key = "shapes/elbow", .value = "elbow", .limit = "a link of the arm"}));
  const std::string tool =
      folder.write("tool.yaml", kRobot + "tool: {mass: 1, moments: [1, 0, 0, 1, 0, 3]}\n");
  EXPECT_THAT(
      [&] { load_robot(tool); },
      refused_at({.file = tool, .line = 3, .key = "tool/moments", .limit = "moments of a rigid body"}));
}

TEST(ScenarioCell, TakesTheCellOfTheRobotUnlessItHasItsOwn) {
  const test::TemporaryFolder folder;
  folder.write("arm.yaml",
               kRobot + "cell: {floor: -0.5, parts: [{name: wall, box: [0.1, 2, 2], center: [-1, 0, 0]}]}\n");
  const std::string text =
      "robot: arm.yaml\ncontrol_period: 0.002\nduration: 1\nstart_position_deg: [0, -90, 90, -90, -90, 0]\n"
      "path: {hold: [0.4, 0.1, 0.4]}\ntargets: [{name: a, hold: [0.4, 0.1, 0]}]\ntheta_start: {model_scale: 1}\n";
  const Scenario of_robot = load_scenario(folder.write("a.yaml", text));
  ASSERT_TRUE(of_robot.clearance);
  EXPECT_EQ(of_robot.clearance->cell().floor, -0.5);
  EXPECT_EQ(of_robot.clearance->cell().parts.size(), 1U);
  const Scenario own = load_scenario(folder.write("b.yaml", text + "cell: {floor: 0}\n"));
  EXPECT_EQ(own.clearance->cell().floor, 0.0);
  EXPECT_TRUE(own.clearance->cell().parts.empty());
  folder.write("arm.yaml", kRobot);
  EXPECT_FALSE(load_scenario(folder.write("c.yaml", text)).clearance);
}

/// A binary STL file of a tetrahedron with edges along the axes [m].
std::string tetrahedron(float edge) {
  const std::array<std::array<float, 3>, 4> corners{{{0, 0, 0}, {edge, 0, 0}, {0, edge, 0}, {0, 0, edge}}};
  std::string bytes(80, '\0');
  const auto add = [&bytes](auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);  // STL and x86-64 are little-endian
  };
  add(std::uint32_t{4});
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    for (int i = 0; i < 3; ++i) add(0.0F);  // the normal
    for (std::size_t corner = 0; corner < 4; ++corner) {
      if (corner == left_out) continue;
      for (const float coordinate : corners[corner]) add(coordinate);
    }
    add(std::uint16_t{0});
  }
  return bytes;
}

TEST(ScenarioCell, MeshesThatDistancesComeFromAreInputs) {
  const test::TemporaryFolder folder;
  std::string urdf = test::read_text(test::source_dir() + "/sim/robots/ur5e.urdf");
  const std::string link = "<link name=\"forearm_link\">";
  ASSERT_NE(urdf.find(link), std::string::npos);
  const std::string shape = "<geometry><mesh filename=\"link.stl\"/></geometry>";
  urdf.insert(urdf.find(link) + link.size(), "<collision>" + shape + "</collision><visual>" + shape +
                                                 "</visual>" + "<collision>" + shape + "</collision>");
  folder.write("arm.urdf", urdf);
  folder.write("arm.yaml", "urdf: arm.urdf\nrotor_inertia: estimated\n");
  const std::string mesh = folder.write("link.stl", tetrahedron(0.1F));
  const std::string text =
      "robot: arm.yaml\ncontrol_period: 0.002\nduration: 1\nstart_position_deg: [0, -90, 90, -90, -90, 0]\n"
      "path: {hold: [0.4, 0.1, 0.4]}\ntargets: [{name: a, hold: [0.4, 0.1, 0]}]\ntheta_start: {model_scale: 1}\n";
  const auto meshes_of = [&](const std::string& name, const std::string& scenario) {
    const Scenario read = load_scenario(folder.write(name, scenario));
    return std::count(read.inputs.begin(), read.inputs.end(), mesh);
  };
  const InputRecord record;
  EXPECT_EQ(meshes_of("bare.yaml", text), 0) << "no distance comes from it";
  EXPECT_EQ(recorded_input(mesh), nullptr);
  EXPECT_EQ(meshes_of("cell.yaml", text + "cell: {floor: -1}\n"), 1);
  ASSERT_NE(recorded_input(mesh), nullptr);
  EXPECT_EQ(*recorded_input(mesh), tetrahedron(0.1F));
}

TEST(ScenarioCell, ObstaclesWithABodyAreParts) {
  const test::TemporaryFolder folder;
  const std::string text =
      "robot: ur5e\ncontrol_period: 0.002\nduration: 1\nstart_position_deg: [0, -90, 90, -90, -90, 0]\n"
      "path: {hold: [0.4, 0.1, 0.4]}\ntargets: [{name: a, hold: [0.4, 0.1, 0]}]\ntheta_start: {model_scale: 1}\n"
      "obstacles: [{name: ball, hold: [0, 0, 0.4], radius: 0.1}, {name: point, hold: [1, 1, 1]}]\n";
  EXPECT_FALSE(load_scenario(folder.write("a.yaml", text)).clearance);
  const Scenario s = load_scenario(folder.write("b.yaml", text + "cell: {}\n"));
  ASSERT_TRUE(s.clearance->has(Clearance::kCell));
  ASSERT_EQ(s.clearance->cell().parts.size(), 1U);
  EXPECT_EQ(s.clearance->cell().parts[0].name, "ball");
  EXPECT_TRUE(s.clearance->cell().parts[0].is_obstacle);
  // It stands in the upper arm, between two joints' origins that are clear of it.
  Poses poses;
  forward_kinematics(s.robot->chain, s.start_position, poses);
  EXPECT_GT(clearance(s.robot->chain, poses, std::vector<Obstacle>{s.obstacles[0].at(0.0)}), 0.0);
  double least = 1.0;
  for (const ContactPair& pair : s.clearance->pairs()) {
    if (pair.of == Clearance::kCell)
      least = std::min(least, s.clearance->distance(pair, poses, Vec3(0.0, 0.0, 0.4)).distance);
  }
  EXPECT_LT(least, 0.0);
}

TEST(ScenarioCell, FindsAStartThatTouchesNothingOfTheCell) {
  const test::TemporaryFolder folder;
  const std::string text =
      "robot: ur5e\ncontrol_period: 0.002\nduration: 4\npath: {circle: {center: [0.45, 0.1, 0.35], radius: 0.05, "
      "period: 4}}\ntargets: [{name: a, hold: [0.45, 0.1, 0]}]\ntheta_start: {model_scale: 1}\n";
  const Scenario free = load_scenario(folder.write("free.yaml", text + "cell: {}\n"));
  const PathWalk before = walk_path(free, free.goal_position, 0.2);
  // A post where the arm's elbow would be.
  Poses poses;
  forward_kinematics(free.robot->chain, free.goal_position, poses);
  const Vec3 elbow = poses.p_0B[2];
  const Scenario post = load_scenario(
      folder.write("post.yaml", text + fmt::format("cell: {{parts: [{{name: post, sphere: {{radius: 0.05}}, "
                                                   "center: [{}, {}, {}]}}]}}\n",
                                                   elbow.x(), elbow.y(), elbow.z())));
  ASSERT_LT(before.error.value, 1e-3);
  EXPECT_GT(least_of(Clearance::kCell, walk_path(post, post.goal_position, 0.2).nearest).distance, 0.0);
  EXPECT_NE(post.goal_position, free.goal_position);
}

}  // namespace cell_file_test
}  // namespace armtune::internal

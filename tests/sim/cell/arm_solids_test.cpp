#include "sim/cell/arm_solids.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/cell/clearance_model.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/sim/cell/rods.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace arm_solids_test {

using testing::ElementsAre;

/// A link that is fixed to another and has nothing but what is to be seen of it counts as that; what cannot
/// be read is named, the base too.
TEST(ArmSolids, EveryLinkCountsWithItsOwnShapes) {
  RobotModel arm = test::with_rods(test::seven_joint_arm());
  for (Shape& shape : arm.shapes) shape.link_name = "link " + std::to_string(shape.link);
  Shape gripper = arm.shapes.back();
  gripper.collision = false;
  gripper.link = arm.shapes.back().link + 1;
  gripper.link_name = "gripper";
  arm.shapes.push_back(gripper);
  Shape mesh = gripper;
  mesh.kind = ShapeKind::kMesh;
  mesh.file = "nowhere.stl";
  mesh.collision = true;
  mesh.link += 1;
  mesh.link_name = "camera";
  arm.shapes.push_back(mesh);
  Shape beside = mesh;
  beside.kind = ShapeKind::kSphere;
  beside.size = {0.1, 0.0, 0.0};
  arm.shapes.push_back(beside);
  const ArmSolids all = arm_solids(arm);
  EXPECT_THAT(drawn_links(all), ElementsAre("gripper")) << "the only link without collision shapes";
  EXPECT_THAT(all.unknown, ElementsAre("camera"));
  EXPECT_THAT(all.unread,
              ElementsAre(testing::AllOf(testing::StartsWith("nowhere.stl: there is no such file"),
                                         testing::HasSubstr("ARMTUNE_MESHES"))));
  EXPECT_EQ(all.solids.size(), arm.shapes.size() - 1) << "the readable shape of the camera is kept";
  std::erase_if(arm.shapes, [](const Shape& shape) { return shape.body == -1 || shape.body == 3; });
  EXPECT_THAT(arm_solids(arm).unknown, testing::Contains(arm.base_link));
  EXPECT_THAT(arm_solids(arm).unknown, testing::Contains(arm.joints[3].link));
}

/// A cube of edge 2 about the origin as OBJ, with squares as faces.
constexpr const char* kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST(ArmSolids, AMeshCountsAsItsHullAndColladaIsNamedWithWhatToDo) {
  const test::TemporaryFolder folder;
  folder.write("cube.obj", kCube);
  folder.write("cube.dae", "<COLLADA/>");
  RobotModel arm = test::with_rods(test::ur10());
  arm.source = folder / "arm.urdf";
  Shape mesh = arm.shapes.back();
  mesh.kind = ShapeKind::kMesh;
  mesh.size = {0.04, 0.05, 0.025};  // half the edges of the box that it replaces
  mesh.file = "cube.obj";
  const Shape replaced = arm.shapes.back();
  arm.shapes.back() = mesh;
  mesh.file = "cube.dae";
  arm.shapes.push_back(mesh);
  const ArmSolids all = arm_solids(arm);
  EXPECT_THAT(all.unread, ElementsAre(testing::AllOf(testing::StartsWith("cube.dae: COLLADA"),
                                                     testing::HasSubstr("STL or OBJ"))));
  EXPECT_THAT(all.meshes, ElementsAre(testing::EndsWith("cube.obj")));
  const auto hull = std::find_if(all.solids.begin(), all.solids.end(), [](const ArmSolid& solid) {
    return solid.placed.solid.kind == SolidKind::kHull;
  });
  ASSERT_NE(hull, all.solids.end());
  std::mt19937 generator(77);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 100; ++k) {
    const Vec3 d = Vec3(normal(generator), normal(generator), normal(generator)).normalized();
    EXPECT_NEAR(support(hull->placed.solid, d), support(box(replaced.size), d), 1e-8)
        << "the file's coordinates are single precision";
  }
}

TEST(ArmSolids, ALinkWithACollisionShapeWithoutSizeIsUnknown) {
  RobotModel arm = test::with_rods(test::ur10());
  Shape nothing = arm.shapes.front();
  nothing.kind = ShapeKind::kNoSize;
  nothing.size = Vec3::Zero();
  arm.shapes.push_back(nothing);
  const ArmSolids all = arm_solids(arm);
  EXPECT_THAT(all.unknown, ElementsAre(arm.base_link));
  EXPECT_THAT(all.unread, ElementsAre(arm.base_link + ": the size of a collision shape is not above zero"));
  EXPECT_EQ(all.solids.size(), arm.shapes.size() - 1) << "its other shapes count";
}

/// The least height of any solid of a body, at joint positions q [m].
double lowest(const RobotModel& arm, int body, const JointVector& q) {
  Cell cell;
  cell.floor = 0.0;
  const ClearanceModel model(std::make_shared<const RobotModel>(arm), cell);
  const Poses poses = test::poses_at(arm.chain, q);
  double least = std::numeric_limits<double>::infinity();
  for (const ContactPair& pair : model.pairs()) {
    if (pair.of == Clearance::kFloor && model.arm().solids[pair.solid].body == body)
      least = std::min(least, model.distance(pair, poses, Vec3::Zero()).distance);
  }
  return least;
}

// What works is the tool's point, wherever a robot file puts it: no floor is clear that it is below.
TEST(ArmSolids, NoFloorIsClearThatTheToolFrameIsBelow) {
  std::mt19937 generator(951);
  for (const RobotModel& bare : test::all_arms()) {
    RobotModel arm = test::with_rods(bare);
    arm.chain.p_BT += Vec3(0.1, -0.05, 0.3);
    for (int sample = 0; sample < 50; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      EXPECT_LE(lowest(arm, arm.n() - 1, q), test::poses_at(arm.chain, q).p_0T.z() + 1e-12) << arm.name;
    }
  }
}

TEST(ArmSolids, ARodLeadsFromTheLastShapesToAToolFrameThatLiesOffThem) {
  RobotModel arm = test::with_rods(test::ur10());
  const std::size_t shapes = arm.shapes.size();
  EXPECT_EQ(arm_solids(arm).solids.size(), shapes) << "the frame lies in the box";
  arm.chain.p_BT += Vec3(0.0, 0.0, 0.5);
  const ArmSolids longer = arm_solids(arm);
  ASSERT_EQ(longer.solids.size(), shapes + 1);
  const ArmSolid& rod = longer.solids.back();
  EXPECT_EQ(rod.link, "tool");
  EXPECT_EQ(rod.body, 5);
  EXPECT_NEAR(farthest(rod.placed, arm.chain.p_BT), rod.placed.solid.size[0] + rod.placed.solid.radius, 1e-12)
      << "it ends at the frame";
  // Of an arm without shapes nothing is known, and a rod would be no arm.
  arm.shapes.clear();
  EXPECT_TRUE(arm_solids(arm).solids.empty());
}

TEST(ArmSolids, TheToolsOfBundledArmsCount) {
  for (const char* name : {"ur10", "panda"}) {
    const auto arm = load_robot(name);
    const ArmSolids all = arm_solids(*arm);
    double nearest = 1.0;
    for (const ArmSolid& solid : all.solids) {
      if (solid.body != arm->n() - 1) continue;
      nearest = std::min(nearest, closest(solid.placed.solid, solid.placed.R_BS, solid.placed.p_BS,
                                          sphere(1e-6), Mat3::Identity(), arm->chain.p_BT)
                                      .distance);
    }
    EXPECT_LE(nearest, 1e-3) << name;
  }
}

}  // namespace arm_solids_test
}  // namespace armtune::internal

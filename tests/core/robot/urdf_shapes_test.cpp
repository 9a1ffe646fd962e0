// Shapes that come out of a URDF: where they stand in the world, against transforms multiplied from its
// numbers.

#include <Eigen/Geometry>

#include "core/robot/kinematics.hpp"
#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal {
namespace urdf_shapes_test {

using test::joint;
using test::kInertial;
using test::kLimit;
using test::link;
using test::one_joint;
using test::robot;

class UrdfShapes : public test::UrdfFiles {};

std::string visual(const std::string& geometry, const std::string& origin = "") {
  return "<visual>" + origin + "<geometry>" + geometry + "</geometry></visual>";
}
std::string collision(const std::string& geometry) {
  return "<collision><geometry>" + geometry + "</geometry></collision>";
}

Eigen::Isometry3d placed(const Vec3& xyz, const Vec3& rpy) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translate(xyz);
  X.rotate(Eigen::AngleAxisd(rpy.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vec3::UnitY()) *
           Eigen::AngleAxisd(rpy.x(), Vec3::UnitX()));
  return X;
}

TEST_F(UrdfShapes, StandWhereTheUrdfsTransformsPutThemAlsoOnFixedLinks) {
  const double q = 0.7;
  const std::string origin_j = "<origin xyz='0.1 0.2 0.3' rpy='0.3 -0.2 0.5'/>";
  const std::string origin_f = "<origin xyz='0 0.1 0.4' rpy='-0.6 0.1 0.2'/>";
  const std::string origin_s = "<origin xyz='0.01 0.02 0.03' rpy='0.9 0.4 -1.1'/>";
  const RobotModel model =
      read(robot(link("a", visual("<sphere radius='0.2'/>", origin_s)) + link("b") +
                 link("c", kInertial + visual("<cylinder radius='0.05' length='0.3'/>", origin_s)) +
                 joint("j", "revolute", "a", "b", origin_j + "<axis xyz='0 1 0'/>" + kLimit) +
                 joint("f", "fixed", "b", "c", origin_f)));
  ASSERT_EQ(model.shapes.size(), 2U);
  const Shape& base = model.shapes[0].body < 0 ? model.shapes[0] : model.shapes[1];
  const Shape& moved = model.shapes[0].body < 0 ? model.shapes[1] : model.shapes[0];
  ASSERT_EQ(base.body, -1);
  ASSERT_EQ(moved.body, 0);

  const Eigen::Isometry3d shape = placed({0.01, 0.02, 0.03}, {0.9, 0.4, -1.1});
  EXPECT_EQ(base.kind, ShapeKind::kSphere);
  EXPECT_EQ(base.size, Vec3(0.2, 0, 0));
  // Products of a few rotations: some ten roundings.
  EXPECT_LT((base.p_BS - shape.translation()).norm(), 1e-14);
  EXPECT_LT((base.R_BS - shape.linear()).norm(), 1e-14);

  Eigen::Isometry3d expected = placed({0.1, 0.2, 0.3}, {0.3, -0.2, 0.5});
  expected.rotate(Eigen::AngleAxisd(q, Vec3::UnitY()));
  expected = expected * placed({0, 0.1, 0.4}, {-0.6, 0.1, 0.2}) * shape;
  Poses poses;
  const JointVector configuration = JointVector::Constant(1, q);
  forward_kinematics(model.chain, configuration, poses);
  EXPECT_EQ(moved.kind, ShapeKind::kCylinder);
  EXPECT_EQ(moved.size, Vec3(0.05, 0.3, 0));
  EXPECT_LT((poses.p_0B[0] + poses.R_0B[0] * moved.p_BS - expected.translation()).norm(), 1e-14);
  EXPECT_LT((poses.R_0B[0] * moved.R_BS - expected.linear()).norm(), 1e-14);
}

TEST_F(UrdfShapes, AreOfEveryKindWithTheirSizes) {
  const RobotModel model =
      read(robot(one_joint(kInertial + visual("<box size='1 2 3'/>") +
                           visual("<cylinder radius='4' length='5'/>") + visual("<sphere radius='6'/>") +
                           visual("<mesh filename='package://arm/link.stl' scale='0.001 0.002 -0.003'/>"))));
  ASSERT_EQ(model.shapes.size(), 4U);
  const ShapeKind kinds[] = {ShapeKind::kBox, ShapeKind::kCylinder, ShapeKind::kSphere, ShapeKind::kMesh};
  const Vec3 sizes[] = {{1, 2, 3}, {4, 5, 0}, {6, 0, 0}, {0.001, 0.002, -0.003}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(model.shapes[i].kind, kinds[i]) << i;
    EXPECT_EQ(model.shapes[i].size, sizes[i]) << i;
    EXPECT_EQ(model.shapes[i].body, 0) << i;
  }
  EXPECT_EQ(model.shapes[3].file, "package://arm/link.stl");
}

TEST_F(UrdfShapes, SayOfWhichLinkTheyAreAndWhatTheyAreFor) {
  const std::string ball = "<sphere radius='1'/>";
  const std::string box = "<box size='1 1 1'/>";
  const auto shapes = [&](const std::string& inside) {
    return read(robot(one_joint(kInertial + inside))).shapes;
  };
  const auto both = shapes(collision(box) + visual(ball));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].kind, ShapeKind::kSphere) << "what is to be seen comes first";
  EXPECT_FALSE(both[0].collision);
  EXPECT_EQ(both[1].kind, ShapeKind::kBox);
  EXPECT_TRUE(both[1].collision);
  EXPECT_EQ(both[0].link, both[1].link);
  EXPECT_THAT(shapes(""), testing::IsEmpty());
}

// A link is not clear of anything because one of its shapes has a size of zero.
TEST_F(UrdfShapes, OfCollisionsWithoutSizeAreKeptAsSuch) {
  for (const char* what :
       {"<sphere radius='0'/>", "<box size='1 -1 1'/>", "<cylinder radius='0.1' length='0'/>"}) {
    const RobotModel model =
        read(robot(one_joint(kInertial + visual("<sphere radius='1'/>") + collision(what))));
    ASSERT_EQ(model.shapes.size(), 2U) << what;
    EXPECT_EQ(model.shapes[1].kind, ShapeKind::kNoSize) << what;
    EXPECT_TRUE(model.shapes[1].collision) << what;
  }
}

TEST_F(UrdfShapes, ThatHaveNoExtentAreLeftOutAndTheArmIsReadAllTheSame) {
  const RobotModel model =
      read(robot(one_joint(kInertial + visual("<sphere radius='0'/>") + visual("<box size='1 -1 1'/>"))));
  EXPECT_EQ(model.n(), 1);
  EXPECT_THAT(model.shapes, testing::IsEmpty());
}

}  // namespace urdf_shapes_test
}  // namespace armtune::internal

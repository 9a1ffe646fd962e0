#include "core/robot/link_radius.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/refused_at.hpp"

namespace armtune::internal {
namespace link_radius_test {

Shape shape(int body, bool collision, ShapeKind kind, const Vec3& size) {
  Shape made;
  made.body = body;
  made.collision = collision;
  made.kind = kind;
  made.size = size;
  return made;
}

TEST(LinkRadius, IsTheLargestOfWhatALinkCollidesWithOrElseShows) {
  RobotModel arm = test::ur10();
  arm.shapes = {shape(0, false, ShapeKind::kCylinder, {0.3, 0.5, 0.0}),
                shape(0, true, ShapeKind::kCylinder, {0.1, 0.5, 0.0}),
                shape(0, true, ShapeKind::kSphere, {0.2, 0.0, 0.0}),
                shape(1, false, ShapeKind::kCapsule, {0.05, 0.5, 0.0}),
                shape(1, true, ShapeKind::kMesh, {1.0, 1.0, 1.0}),
                shape(2, false, ShapeKind::kBox, {0.06, 0.5, 0.08}),
                shape(-1, true, ShapeKind::kSphere, {9.0, 0.0, 0.0}),
                shape(3, true, ShapeKind::kMesh, {1.0, 1.0, 1.0})};
  const JointVector radii = shape_radii(arm);
  EXPECT_EQ(radii[0], 0.2);
  EXPECT_EQ(radii[1], 0.05);
  EXPECT_NEAR(radii[2], 0.05, 1e-16);
  for (int i = 3; i < 6; ++i) EXPECT_TRUE(std::isnan(radii[i])) << i;
}

TEST(LinkRadius, OfAnArmWithoutItIsAskedForByName) {
  RobotModel arm = test::ur10();
  const auto surfaces = [&] { return with_link_surfaces(arm); };
  arm.link_radii.resize(0);
  EXPECT_THAT(surfaces,
              test::refused_at({.file = arm.source,
                                .key = "link_radius/" + arm.joints[0].link,
                                .limit = "a radius in m for: shoulder_link, upper_arm_link, "
                                         "forearm_link, wrist_1_link, wrist_2_link, wrist_3_link"}));
  arm.link_radii = JointVector::Constant(6, 0.05);
  EXPECT_EQ(with_link_surfaces(arm).chain.link_radius, arm.link_radii);
  EXPECT_EQ(arm.chain.link_radius.size(), 0) << "of joints, as it was";
  arm.link_radii[4] = NAN;
  EXPECT_THAT(surfaces, test::refused_at({.key = "link_radius/" + arm.joints[4].link,
                                          .limit = "a radius in m for: " + arm.joints[4].link}));
}

}  // namespace link_radius_test
}  // namespace armtune::internal

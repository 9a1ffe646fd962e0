// The distances of one moment.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/cell/busy_cell.hpp"

namespace armtune::internal {
namespace clearance_model_test {

using testing::ElementsAre;

TEST(ClearanceModel, NoDistanceChangesByMoreThanItsLeversAllow) {
  std::mt19937 generator(11);
  int moved = 0;
  for (const auto& arm : test::shaped_arms()) {
    const ClearanceModel model(arm, test::busy_cell());
    ASSERT_FALSE(model.pairs().empty());
    for (int sample = 0; sample < 100; ++sample) {
      const JointVector q = test::random_configuration(generator, *arm);
      const double step = sample % 2 == 0 ? 0.01 : 1.0;
      JointVector other = test::random_configuration(generator, *arm);
      other = q + step * (other - q);
      for (const ContactPair& pair : model.pairs()) {
        const double change =
            std::abs(test::distance_at(model, pair, q, 0.0) - test::distance_at(model, pair, other, 0.0));
        const double allowed = pair.lever.dot((other - q).cwiseAbs());
        EXPECT_LE(change, allowed + 1e-9) << arm->name << ", " << model.name(pair);
        moved += change > 0.1 * allowed ? 1 : 0;
      }
    }
  }
  EXPECT_GT(moved, 1000) << "or the levers say nothing";
}

// Joints that go back and forth between two times, as fast as they may.
TEST(ClearanceModel, BetweenTwoTimesNoDistanceIsSmallerByMoreThanTheUnseenPart) {
  std::mt19937 generator(12);
  constexpr double kPeriod = 0.02;
  double largest = 0.0;
  for (const auto& arm : test::shaped_arms()) {
    const ClearanceModel model(arm, test::busy_cell());
    const double unseen = model.most_unseen(kPeriod);
    EXPECT_NEAR(model.most_unseen(0.5 * kPeriod), 0.5 * unseen, 1e-12);
    for (int sample = 0; sample < 100; ++sample) {
      const JointVector begin = 0.9 * test::random_configuration(generator, *arm);
      const JointVector way =
          test::random_vector(generator, arm->n(), 1.0).cwiseSign().cwiseProduct(arm->velocity_limits());
      const JointVector turn = begin + 0.5 * kPeriod * way;
      for (const ContactPair& pair : model.pairs()) {
        const double fall =
            test::distance_at(model, pair, begin, 0.0) - test::distance_at(model, pair, turn, 0.0);
        EXPECT_LE(fall, unseen + 1e-9) << arm->name << ", " << model.name(pair);
        largest = std::max(largest, fall / unseen);
      }
    }
  }
  EXPECT_GT(largest, 0.1) << "or the bound says nothing";
}

/// Closest points are points of the bodies, of the floor too, and the distance changes along `away`.
TEST(ClearanceModel, TheClosestPointOfTheArmIsOnItsSurface) {
  std::mt19937 generator(16);
  int of_floor = 0;
  for (const auto& arm : test::shaped_arms()) {
    const ClearanceModel model(arm, test::busy_cell());
    for (int sample = 0; sample < 20; ++sample) {
      const JointVector q = test::random_configuration(generator, *arm);
      const Poses poses = test::poses_at(arm->chain, q);
      for (const ContactPair& pair : model.pairs()) {
        const Closest found = model.distance(pair, poses, test::place_of(model, pair, 0.0));
        const ArmSolid& solid = model.arm().solids[pair.solid];
        const auto k = static_cast<std::size_t>(solid.body);
        const Mat3 R = poses.R_0B[k] * solid.placed.R_BS;
        const Vec3 p = poses.p_0B[k] + poses.R_0B[k] * solid.placed.p_BS;
        if (found.distance <= 0.0 && pair.of != Clearance::kFloor) continue;
        // It is the farthest point of the body on the way to the other.
        const double reach = support(solid.placed.solid, -(R.transpose() * found.away));
        EXPECT_NEAR(-found.away.dot(found.on_a - p), reach, 1e-8) << arm->name << ", " << model.name(pair);
        if (pair.of != Clearance::kFloor) continue;
        ++of_floor;
        // By the first joint, the distance changes as that point does.
        JointVector moved = q;
        const auto at = [&](double step) {
          moved[0] = q[0] + step;
          return test::distance_at(model, pair, moved, 0.0);
        };
        const Vec3 axis = poses.R_0B[0].col(2);
        const Vec3 rate = arm->chain.motion[0] == JointMotion::kRevolute
                              ? Vec3(axis.cross(found.on_a - poses.p_0B[0]))
                              : axis;
        const double slope = (at(1e-6) - at(-1e-6)) / 2e-6;
        if (solid.placed.solid.kind == SolidKind::kCapsule && std::abs(R.col(2).dot(found.away)) > 1e-3) {
          EXPECT_NEAR(slope, found.away.dot(rate), 1e-4) << arm->name << ", " << model.name(pair);
        }
      }
    }
  }
  EXPECT_GT(of_floor, 500);
}

TEST(ClearanceModel, NoGapIsLargerThanTheDistanceAndThatAlongItIsTheDistance) {
  std::mt19937 generator(19);
  int tight = 0;
  for (const auto& arm : test::shaped_arms()) {
    const ClearanceModel model(arm, test::busy_cell());
    for (int sample = 0; sample < 20; ++sample) {
      const Poses poses = test::poses_at(arm->chain, test::random_configuration(generator, *arm));
      for (const ContactPair& pair : model.pairs()) {
        const Vec3 at = test::place_of(model, pair, 0.0);
        const Closest found = model.distance(pair, poses, at);
        const auto gap = [&](const Vec3& away) { return model.gap(pair, poses, at, away); };
        if (pair.of != Clearance::kFloor) {
          EXPECT_LE(gap(test::random_vec3(generator, 1.0).normalized()), found.distance + 2e-9)
              << arm->name << ", " << model.name(pair);
        }
        EXPECT_LE(gap(found.away), found.distance + 2e-9) << arm->name << ", " << model.name(pair);
        if (found.distance <= 0.0 && pair.of != Clearance::kFloor) continue;
        EXPECT_NEAR(gap(found.away), found.distance, 2e-9) << arm->name << ", " << model.name(pair);
        ++tight;
      }
    }
  }
  EXPECT_GT(tight, 1000);
}

TEST(ClearanceModel, ATurnAboutAVerticalAxisChangesNoHeight) {
  const auto upright = load_robot("ur5e");
  RobotModel tilted = *upright;
  tilted.chain.gravity = 9.81 * Vec3(0.6, 0.0, -0.8);
  const auto largest_lever = [](const std::shared_ptr<const RobotModel>& arm, int joint) {
    Cell cell;
    cell.floor = 0.0;
    const ClearanceModel model(arm, cell);
    double lever = 0.0;
    for (const ContactPair& pair : model.pairs()) {
      if (pair.of == Clearance::kFloor) lever = std::max(lever, pair.lever[joint]);
    }
    return lever;
  };
  EXPECT_NEAR(largest_lever(upright, 0), 0.0, 1e-12);
  const auto leaning = std::make_shared<const RobotModel>(tilted);
  EXPECT_GT(largest_lever(leaning, 0), 0.3);
  EXPECT_GT(largest_lever(upright, 1), 0.3);
}

TEST(ClearanceModel, LeavesNeighboursOutAndLinksWhoseShapesMeetByTheirMake) {
  RobotModel arm = test::with_rods(test::seven_joint_arm());
  Shape& big = arm.shapes[5];
  big.kind = ShapeKind::kSphere;
  big.size = {1.0, 0.0, 0.0};  // about everything near it
  const ClearanceModel model(std::make_shared<const RobotModel>(arm), Cell{});
  EXPECT_THAT(model.left_out_by_their_make(),
              testing::Contains(arm.joints[2].link + " and " + arm.joints[4].link));
  EXPECT_THAT(ClearanceModel(std::make_shared<const RobotModel>(test::with_rods(test::ur10())), Cell{})
                  .left_out_by_their_make(),
              testing::IsEmpty());
  for (const ContactPair& pair : model.pairs()) {
    EXPECT_EQ(pair.of, Clearance::kSelf);
    EXPECT_GT(model.arm().solids[pair.solid].body - model.arm().solids[pair.other].body, 1);
  }
}

/// A first joint that swings about a horizontal axis can run into the floor, and is looked at.
TEST(ClearanceModel, TheFirstLinkIsNoPairWithTheFloorOnlyWhereItStandsOnIt) {
  RobotModel arm = test::with_rods(test::seven_joint_arm());
  arm.chain.R_PB0[0] = Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitX()).toRotationMatrix();
  arm.chain.p_PB0[0] = Vec3(0.0, 0.0, 0.05);
  const auto has_first = [](const ClearanceModel& model) {
    return std::any_of(model.pairs().begin(), model.pairs().end(), [&](const ContactPair& pair) {
      return pair.of == Clearance::kFloor && model.arm().solids[pair.solid].body == 0;
    });
  };
  Cell cell;
  cell.floor = 0.0;
  EXPECT_TRUE(has_first(ClearanceModel(std::make_shared<const RobotModel>(arm), cell)));
  cell.floor = 2.0;
  EXPECT_FALSE(has_first(ClearanceModel(std::make_shared<const RobotModel>(arm), cell)));
}

TEST(ClearanceModel, OfABundledArmSaysWhichLinksAreLeftOut) {
  const ClearanceModel model(load_robot("ur5e"), Cell{});
  EXPECT_THAT(
      model.left_out(),
      ElementsAre(ElementsAre("base_link", "shoulder_link"), ElementsAre("shoulder_link", "upper_arm_link"),
                  ElementsAre("upper_arm_link", "forearm_link"), ElementsAre("forearm_link", "wrist_1_link"),
                  ElementsAre("wrist_1_link", "wrist_2_link"), ElementsAre("wrist_2_link", "wrist_3_link")));
}

TEST(ClearanceModel, TheFloorIsAcrossGravityWhereverTheBaseIs) {
  RobotModel arm = test::with_rods(test::ur10());
  arm.chain.gravity = Vec3(0.0, 0.0, 9.81);  // from the ceiling
  Cell cell;
  cell.floor = -2.0;
  const ClearanceModel model(std::make_shared<const RobotModel>(arm), cell);
  const Poses poses = test::poses_at(arm.chain, JointVector::Zero(6));
  for (const ContactPair& pair : model.pairs()) {
    if (pair.of != Clearance::kFloor) continue;
    const ArmSolid& solid = model.arm().solids[pair.solid];
    const auto k = static_cast<std::size_t>(solid.body);
    const Mat3 R = poses.R_0B[k] * solid.placed.R_BS;
    const Vec3 p = poses.p_0B[k] + poses.R_0B[k] * solid.placed.p_BS;
    // Down is +z: the lowest point is the one with the largest z.
    const double lowest = p.z() + support(solid.placed.solid, R.transpose() * Vec3::UnitZ());
    EXPECT_NEAR(model.distance(pair, poses, Vec3::Zero()).distance, 2.0 - lowest, 1e-12);
  }
}

}  // namespace clearance_model_test
}  // namespace armtune::internal

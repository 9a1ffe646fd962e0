#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/cell/clearance_watch.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/sim/cell/rods.hpp"

namespace armtune::internal {
namespace {

using test::part;
using test::random_number;
using test::random_vec3;
using test::random_vector;
using testing::ElementsAre;

std::vector<std::shared_ptr<const RobotModel>> shaped_arms() {
  std::vector<std::shared_ptr<const RobotModel>> arms;
  for (const RobotModel& arm : test::all_arms())
    arms.push_back(std::make_shared<const RobotModel>(test::with_rods(arm)));
  for (const char* name : {"ur5e", "fr3", "iiwa14"}) arms.push_back(load_robot(name));
  return arms;
}

/// A table beside the arm, a post, and a ball that goes round.
Cell busy_cell() {
  Cell cell;
  cell.floor = -0.3;
  cell.parts.push_back(part("table", box({0.6, 0.8, 0.05}), {0.7, 0.0, -0.1}));
  cell.parts.push_back(part("post", capsule(0.05, 1.0), {-0.5, 0.4, 0.3}));
  cell.parts.push_back(
      {"ball", sphere(0.1), Mat3::Identity(),
       Path{Vec3(0.0, 0.0, 0.8), 1.3, 0.0, {{1, Vec3(0.6, 0.0, 0.0), Vec3(0.0, 0.6, 0.0)}}}});
  return cell;
}

/// Joint positions that swing between the limits, at different speeds.
class Swing {
 public:
  Swing(std::mt19937& generator, const RobotModel& arm)
      : center_(test::random_configuration(generator, arm)),
        reach_(random_vector(generator, arm.n(), 0.5)),
        pace_(random_vector(generator, arm.n(), 4.0)) {}
  JointVector at(double t) const { return center_ + reach_.cwiseProduct((pace_ * t).array().sin().matrix()); }

 private:
  JointVector center_, reach_, pace_;
};

Vec3 place_of(const ClearanceModel& model, const ContactPair& pair, double time) {
  return pair.of == Clearance::kCell ? model.cell().parts[pair.other].path.at(time).position
                                     : Vec3(Vec3::Zero());
}

double distance_at(const ClearanceModel& model, const ContactPair& pair, const JointVector& q, double time) {
  return model.distance(pair, test::poses_at(model.robot().chain, q), place_of(model, pair, time)).distance;
}

TEST(ClearanceModel, NoDistanceChangesByMoreThanItsLeversAllow) {
  std::mt19937 generator(11);
  int moved = 0;
  for (const auto& arm : shaped_arms()) {
    const ClearanceModel model(arm, busy_cell());
    ASSERT_FALSE(model.pairs().empty());
    for (int sample = 0; sample < 100; ++sample) {
      const JointVector q = test::random_configuration(generator, *arm);
      const double step = sample % 2 == 0 ? 0.01 : 1.0;
      JointVector other = test::random_configuration(generator, *arm);
      other = q + step * (other - q);
      for (const ContactPair& pair : model.pairs()) {
        const double change =
            std::abs(distance_at(model, pair, q, 0.0) - distance_at(model, pair, other, 0.0));
        const double allowed = pair.lever.dot((other - q).cwiseAbs());
        EXPECT_LE(change, allowed + 1e-9) << arm->name << ", " << model.name(pair);
        moved += change > 0.1 * allowed ? 1 : 0;
      }
    }
  }
  EXPECT_GT(moved, 1000) << "or the levers say nothing";
}

/// The least of |a0 + s da - b0 - t db|^2 over s, t in [0, 1]: the quadratic program of two segments, solved
/// by going through every set of active bounds.
double least_between(const Vec3& a0, const Vec3& da, const Vec3& b0, const Vec3& db) {
  const auto at = [&](double s, double t) { return (a0 + s * da - b0 - t * db).norm(); };
  double least = std::numeric_limits<double>::infinity();
  const auto clamped = [](double x) { return std::clamp(std::isfinite(x) ? x : 0.0, 0.0, 1.0); };
  for (const double end : {0.0, 1.0}) {
    least = std::min(least, at(end, clamped((a0 + end * da - b0).dot(db) / db.squaredNorm())));
    least = std::min(least, at(clamped((b0 + end * db - a0).dot(da) / da.squaredNorm()), end));
  }
  Eigen::Matrix2d H;
  H << da.dot(da), -da.dot(db), -da.dot(db), db.dot(db);
  const Eigen::Vector2d free = H.fullPivLu().solve(Eigen::Vector2d(-da.dot(a0 - b0), db.dot(a0 - b0)));
  if (free.minCoeff() >= 0.0 && free.maxCoeff() <= 1.0) least = std::min(least, at(free[0], free[1]));
  return least;
}

/// A capsule of an arm in frame 0 at joint positions whose poses are given: its axis.
struct Axis {
  Vec3 from, along;
  double radius;
};
Axis axis_of(const Shape& shape, const Poses& poses) {
  const auto k = static_cast<std::size_t>(std::max(shape.body, 0));
  const Mat3 R = shape.body < 0 ? Mat3(Mat3::Identity()) : poses.R_0B[k];
  const Vec3 p = shape.body < 0 ? Vec3(Vec3::Zero()) : poses.p_0B[k];
  const Vec3 z = R * shape.R_BS.col(2);
  return {p + R * shape.p_BS - 0.5 * shape.size[1] * z, shape.size[1] * z, shape.size[0]};
}

// Against a computation that shares nothing with the model but the arm's file and its kinematics. Where
// bodies meet, by how much they do.
TEST(ClearanceModel, DistancesOfArmsOfCapsulesAreThoseOfASmallQuadraticProgram) {
  std::mt19937 generator(18);
  int met = 0;
  for (const char* name : {"ur5e", "fr3", "iiwa14"}) {
    const auto arm = load_robot(name);
    const ClearanceModel model(arm, Cell{});
    for (int sample = 0; sample < 1000; ++sample) {
      const JointVector q = test::random_configuration(generator, *arm);
      const Poses poses = test::poses_at(arm->chain, q);
      double least = std::numeric_limits<double>::infinity(), found = least;
      for (const ContactPair& pair : model.pairs())
        found = std::min(found, model.distance(pair, poses, Vec3::Zero()).distance);
      for (const Shape& a : arm->shapes) {
        for (const Shape& b : arm->shapes) {
          if (!a.collision || !b.collision || b.body - a.body < 2) continue;
          const bool looked_at =
              std::any_of(model.pairs().begin(), model.pairs().end(), [&](const ContactPair& pair) {
                return model.arm().solids[pair.other].link == a.link_name &&
                       model.arm().solids[pair.solid].link == b.link_name;
              });
          ASSERT_TRUE(looked_at) << a.link_name << ", " << b.link_name;
          const Axis one = axis_of(a, poses), other = axis_of(b, poses);
          least = std::min(
              least, least_between(one.from, one.along, other.from, other.along) - one.radius - other.radius);
        }
      }
      EXPECT_NEAR(found, least, 1e-6) << name << ", sample " << sample;
      met += least < 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(met, 100);
}

/// Every distance at every moment, and the smallest of them.
LeastClearances by_force(const ClearanceModel& model, const Swing& swing, int periods) {
  LeastClearances least;
  for (int k = 0; k < periods; ++k) {
    const double time = 0.002 * k;
    for (const ContactPair& pair : model.pairs()) {
      const double distance = distance_at(model, pair, swing.at(time), time);
      LeastClearance& of_kind = least[static_cast<std::size_t>(pair.of)];
      if (distance < of_kind.distance) of_kind = {distance, time, &pair};
    }
  }
  return least;
}

TEST(ClearanceWatch, FindsTheSmallestDistanceOfAllMomentsWithoutLookingAtMost) {
  std::mt19937 generator(12);
  constexpr int kPeriods = 500;
  long computed = 0;
  long all = 0;
  int touched = 0;
  for (const auto& arm : shaped_arms()) {
    const auto model = std::make_shared<const ClearanceModel>(arm, busy_cell());
    for (int sample = 0; sample < 3; ++sample) {
      const Swing swing(generator, *arm);
      ClearanceWatch watch(model);
      for (int k = 0; k < kPeriods; ++k) watch.see(0.002 * k, swing.at(0.002 * k));
      const LeastClearances expected = by_force(*model, swing, kPeriods);
      for (std::size_t kind = 0; kind < kClearances; ++kind) {
        EXPECT_EQ(watch.least()[kind].distance, expected[kind].distance) << arm->name << ", kind " << kind;
        EXPECT_EQ(watch.least()[kind].time, expected[kind].time) << arm->name << ", kind " << kind;
        EXPECT_EQ(watch.least()[kind].pair, expected[kind].pair) << arm->name << ", kind " << kind;
        touched += expected[kind].distance < 0.0 ? 1 : 0;
      }
      computed += watch.computed();
      all += static_cast<long>(kPeriods * model->pairs().size());
    }
  }
  EXPECT_GT(touched, 10);
  EXPECT_LT(computed, all / 3) << "although all joints swing fast";
  RecordProperty("distances computed of all", std::to_string(100.0 * double(computed) / double(all)) + " %");
}

/// A pin that the arm touches at one moment, and is clear of soon before and after it.
TEST(ClearanceWatch, MissesNoContactThatLastsAMoment) {
  std::mt19937 generator(13);
  const auto arm = load_robot("ur5e");
  int planted = 0;
  for (int sample = 0; sample < 60; ++sample) {
    const Swing swing(generator, *arm);
    const int when = static_cast<int>(random_number(generator, 50.0, 450.0));
    const Poses poses = test::poses_at(arm->chain, swing.at(0.002 * when));
    Cell cell;
    // Just within the last link's surface, on the side that it moves to.
    const Vec3 before = test::poses_at(arm->chain, swing.at(0.002 * (when - 1))).p_0T;
    const Vec3 way = (poses.p_0T - before).normalized();
    cell.parts.push_back(part("pin", sphere(1e-4), poses.p_0T + 0.01 * way));
    const auto model = std::make_shared<const ClearanceModel>(arm, cell);
    ClearanceWatch watch(model);
    for (int k = 0; k < 500; ++k) watch.see(0.002 * k, swing.at(0.002 * k));
    const LeastClearances expected = by_force(*model, swing, 500);
    const LeastClearance& found = least_of(Clearance::kCell, watch.least());
    EXPECT_EQ(found.distance, least_of(Clearance::kCell, expected).distance);
    planted += found.distance < 0.0 ? 1 : 0;
  }
  EXPECT_GT(planted, 40);
}

/// The same with a pin on a link of the arm itself.
TEST(ClearanceWatch, MissesNoContactOfTheArmWithItselfThatLastsAMoment) {
  std::mt19937 generator(17);
  const auto arm = load_robot("ur5e");
  int planted = 0;
  const ClearanceModel bare(arm, Cell{});
  for (int sample = 0; sample < 400 && planted < 30; ++sample) {
    const Swing swing(generator, *arm);
    // Swings in which the arm meets itself anyway say nothing of a pin.
    if (least_of(Clearance::kSelf, by_force(bare, swing, 500)).distance < 0.0) continue;
    const int when = static_cast<int>(random_number(generator, 50.0, 450.0));
    const Poses poses = test::poses_at(arm->chain, swing.at(0.002 * when));
    const Vec3 before = test::poses_at(arm->chain, swing.at(0.002 * (when - 1))).p_0T;
    const Vec3 place = poses.p_0T + 0.01 * (poses.p_0T - before).normalized();
    RobotModel with_pin = *arm;
    Shape pin;
    const bool on_base = sample % 2 == 0;
    pin.body = on_base ? -1 : 1;
    pin.link = pin.body + 1;
    pin.link_name = on_base ? arm->base_link : arm->joints[1].link;
    pin.collision = true;
    pin.kind = ShapeKind::kSphere;
    pin.size = {1e-4, 0.0, 0.0};
    pin.p_BS = on_base ? place : Vec3(poses.R_0B[1].transpose() * (place - poses.p_0B[1]));
    with_pin.shapes.push_back(pin);
    const auto model = std::make_shared<const ClearanceModel>(
        std::make_shared<const RobotModel>(std::move(with_pin)), Cell{});
    ClearanceWatch watch(model);
    for (int k = 0; k < 500; ++k) watch.see(0.002 * k, swing.at(0.002 * k));
    const LeastClearance expected = least_of(Clearance::kSelf, by_force(*model, swing, 500));
    const LeastClearance& found = least_of(Clearance::kSelf, watch.least());
    EXPECT_EQ(found.distance, expected.distance) << sample;
    EXPECT_EQ(found.time, expected.time) << sample;
    planted += found.distance < 0.0 ? 1 : 0;
  }
  EXPECT_EQ(planted, 30);
}

TEST(ClearanceNow, FindsTheSmallestDistancesOfEveryMoment) {
  std::mt19937 generator(15);
  long computed = 0;
  for (const auto& arm : shaped_arms()) {
    const auto model = std::make_shared<const ClearanceModel>(arm, busy_cell());
    const Swing swing(generator, *arm);
    ClearanceNow now(model);
    for (int k = 0; k < 200; ++k) {
      const double time = 0.002 * k;
      const JointVector q = swing.at(time);
      now.see(time, q);
      now.see(time, q);
      LeastClearances expected;
      double closest = std::numeric_limits<double>::infinity();
      for (const ContactPair& pair : model->pairs()) {
        const double distance = distance_at(*model, pair, q, time);
        LeastClearance& of_kind = expected[static_cast<std::size_t>(pair.of)];
        if (distance < of_kind.distance) of_kind = {distance, time, &pair};
        closest = std::min(closest, distance);
      }
      for (std::size_t kind = 0; kind < kClearances; ++kind)
        EXPECT_EQ(now.least()[kind].distance, expected[kind].distance) << arm->name << ", kind " << kind;
      if (closest > 0.0) {
        EXPECT_NEAR((now.closest().on_a - now.closest().on_b).norm(), closest, 1e-9) << arm->name;
      }
    }
    computed += 1;
  }
  EXPECT_GT(computed, 0);
}

/// Closest points are points of the bodies, of the floor too, and the distance changes along `away`.
TEST(ClearanceModel, TheClosestPointOfTheArmIsOnItsSurface) {
  std::mt19937 generator(16);
  int of_floor = 0;
  for (const auto& arm : shaped_arms()) {
    const ClearanceModel model(arm, busy_cell());
    for (int sample = 0; sample < 20; ++sample) {
      const JointVector q = test::random_configuration(generator, *arm);
      const Poses poses = test::poses_at(arm->chain, q);
      for (const ContactPair& pair : model.pairs()) {
        const Closest found = model.distance(pair, poses, place_of(model, pair, 0.0));
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
          return distance_at(model, pair, moved, 0.0);
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

TEST(ClearanceWatch, ASlideBeyondItsLimitsIsLookedAtEveryTime) {
  std::mt19937 generator(14);
  const auto arm = std::make_shared<const RobotModel>(test::with_rods(test::random_arm(6, 3, true)));
  const auto model = std::make_shared<const ClearanceModel>(arm, busy_cell());
  JointVector q = test::random_configuration(generator, *arm);
  ClearanceWatch watch(model);
  q[1] = 5.0 + arm->joints[1].limits.upper;
  watch.see(0.0, q);
  watch.see(0.002, q);
  EXPECT_EQ(watch.computed(), 2 * static_cast<long>(model->pairs().size()));
  q[1] = arm->joints[1].limits.upper;
  watch.see(0.004, q);
  EXPECT_EQ(watch.computed(), 3 * static_cast<long>(model->pairs().size())) << "when it comes back, too";
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

}  // namespace
}  // namespace armtune::internal

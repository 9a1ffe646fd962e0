// The smallest distances over a motion are found although few distances are computed.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/cell/clearance_watch.hpp"
#include "tests/sim/cell/busy_cell.hpp"

namespace armtune::internal {
namespace clearance_watch_test {

using test::part;
using test::random_number;

constexpr double kProven = 2e-9;  // m: twice the accuracy of a distance

/// Every distance at every moment, and the smallest of them.
LeastClearances by_force(const ClearanceModel& model, const test::Swing& swing, int periods) {
  LeastClearances least;
  for (int k = 0; k < periods; ++k) {
    const double time = 0.002 * k;
    for (const ContactPair& pair : model.pairs()) {
      const double distance = test::distance_at(model, pair, swing.at(time), time);
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
  for (const auto& arm : test::shaped_arms()) {
    const auto model = std::make_shared<const ClearanceModel>(arm, test::busy_cell());
    for (int sample = 0; sample < 3; ++sample) {
      const test::Swing swing(generator, *arm);
      ClearanceWatch watch(model);
      for (int k = 0; k < kPeriods; ++k) watch.see(0.002 * k, swing.at(0.002 * k));
      const LeastClearances expected = by_force(*model, swing, kPeriods);
      for (std::size_t kind = 0; kind < kClearances; ++kind) {
        const LeastClearance& found = watch.least()[kind];
        EXPECT_NEAR(found.distance, expected[kind].distance, kProven) << arm->name << ", kind " << kind;
        ASSERT_NE(found.pair, nullptr);
        EXPECT_EQ(test::distance_at(*model, *found.pair, swing.at(found.time), found.time), found.distance)
            << arm->name << ", kind " << kind;
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

TEST(ClearanceWatch, ListsEveryPairThatWasTooNear) {
  std::mt19937 generator(16);
  std::size_t listed = 0;
  std::size_t all = 0;
  for (const auto& arm : test::shaped_arms()) {
    const auto model = std::make_shared<const ClearanceModel>(arm, test::busy_cell());
    const auto& pairs = model->pairs();
    std::vector<double> required(pairs.size());
    for (std::size_t k = 0; k < pairs.size(); ++k) required[k] = k % 3 == 0 ? -1.0 : 0.05 * double(k % 5);
    const test::Swing swing(generator, *arm);
    ClearanceWatch watch(model, required);
    ClearanceWatch without(model);
    std::vector<double> least(pairs.size(), std::numeric_limits<double>::infinity());
    for (int step = 0; step < 200; ++step) {
      const double time = 0.005 * step;
      const JointVector q = swing.at(time);
      watch.see(time, q);
      without.see(time, q);
      for (std::size_t k = 0; k < pairs.size(); ++k)
        least[k] = std::min(least[k], test::distance_at(*model, pairs[k], q, time));
    }
    std::vector<const ContactPair*> expected, found;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (least[k] < required[k]) expected.push_back(&pairs[k]);
    }
    for (const LeastClearance& one : watch.too_near()) {
      found.push_back(one.pair);
      EXPECT_NEAR(one.distance, least[static_cast<std::size_t>(one.pair - pairs.data())], kProven)
          << arm->name;
    }
    EXPECT_EQ(found, expected) << arm->name;
    EXPECT_TRUE(without.too_near().empty());
    for (std::size_t kind = 0; kind < kClearances; ++kind)
      EXPECT_NEAR(watch.least()[kind].distance, without.least()[kind].distance, kProven)
          << "the least do not change";
    listed += expected.size();
    all += pairs.size();
  }
  EXPECT_GT(listed, 20U);
  EXPECT_LT(listed, all);
}

/// A pin that the arm touches at one moment, and is clear of soon before and after it.
TEST(ClearanceWatch, MissesNoContactThatLastsAMoment) {
  std::mt19937 generator(13);
  const auto arm = load_robot("ur5e");
  int planted = 0;
  for (int sample = 0; sample < 60; ++sample) {
    const test::Swing swing(generator, *arm);
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
    EXPECT_NEAR(found.distance, least_of(Clearance::kCell, expected).distance, kProven);
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
    const test::Swing swing(generator, *arm);
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
    EXPECT_NEAR(found.distance, expected.distance, kProven) << sample;
    EXPECT_NEAR(found.time, expected.time, 0.002) << sample;
    planted += found.distance < 0.0 ? 1 : 0;
  }
  EXPECT_EQ(planted, 30);
}

TEST(ClearanceNow, FindsTheSmallestDistancesOfEveryMoment) {
  std::mt19937 generator(15);
  int apart = 0;
  int meeting = 0;
  for (const auto& arm : test::shaped_arms()) {
    const auto model = std::make_shared<const ClearanceModel>(arm, test::busy_cell());
    const test::Swing swing(generator, *arm);
    ClearanceNow now(model);
    for (int k = 0; k < 200; ++k) {
      const double time = 0.002 * k;
      const JointVector q = swing.at(time);
      now.see(time, q);
      now.see(time, q);
      LeastClearances expected;
      double closest = std::numeric_limits<double>::infinity();
      for (const ContactPair& pair : model->pairs()) {
        const double distance = test::distance_at(*model, pair, q, time);
        LeastClearance& of_kind = expected[static_cast<std::size_t>(pair.of)];
        if (distance < of_kind.distance) of_kind = {distance, time, &pair};
        closest = std::min(closest, distance);
      }
      for (std::size_t kind = 0; kind < kClearances; ++kind)
        EXPECT_NEAR(now.least()[kind].distance, expected[kind].distance, kProven)
            << arm->name << ", kind " << kind;
      (closest > 0.0 ? apart : meeting) += 1;
      if (closest > 0.0) {
        EXPECT_NEAR((now.closest().on_a - now.closest().on_b).norm(), closest, 1e-9) << arm->name;
      }
    }
  }
  EXPECT_GT(apart, 100) << "or no closest points were compared";
  EXPECT_GT(meeting, 100);
}

TEST(ClearanceWatch, ASlideBeyondItsLimitsIsLookedAtEveryTime) {
  std::mt19937 generator(14);
  const auto arm = std::make_shared<const RobotModel>(test::with_rods(test::random_arm(6, 3, true)));
  const auto model = std::make_shared<const ClearanceModel>(arm, test::busy_cell());
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

}  // namespace clearance_watch_test
}  // namespace armtune::internal

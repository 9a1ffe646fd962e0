#include "tuner/planning/solver/violation_price.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace armtune::internal {
namespace violation_price_test {

using Eigen::VectorXd;

constexpr double kTolerance = 1e-8;

/// A row between -1 and 1 with penalty 10, and a hard one at 0.
RowBounds bounds() {
  RowBounds made;
  made.lower = Eigen::Vector2d(-1.0, 0.0);
  made.upper = Eigen::Vector2d(1.0, 0.0);
  made.penalty = Eigen::Vector2d(10.0, INFINITY);
  return made;
}

TEST(ViolationPrice, AViolationIsTheWayBackToTheBounds) {
  const RowBounds b = bounds();
  EXPECT_EQ(violation(b, 0, 0.5), 0.0);
  EXPECT_EQ(violation(b, 0, 1.25), 0.25);
  EXPECT_EQ(violation(b, 0, -1.5), 0.5);
  EXPECT_EQ(violation(b, 0, NAN), INFINITY);
}

TEST(ViolationPrice, NoViolationIsWorthTheMultipliersItStartsFrom) {
  const RowBounds b = bounds();
  EXPECT_EQ(ViolationPrice(b, kTolerance, VectorXd::Zero(2)).dearest(), 10.0);
  const ViolationPrice price(b, kTolerance, Eigen::Vector2d(-40.0, 1e9));
  EXPECT_GT(price.penalties()[0], 40.0);
  EXPECT_EQ(price.penalties()[1], INFINITY) << "a hard row stays hard, and its multiplier says nothing";
  EXPECT_EQ(price.dearest(), price.penalties()[0]);
}

TEST(ViolationPrice, IsPaidByAViolatedRowAtItsPenaltyAlone) {
  const RowBounds b = bounds();
  ViolationPrice price(b, kTolerance, VectorXd::Zero(2));
  const Eigen::Vector2d violated(1.5, 0.0);
  EXPECT_TRUE(price.paid(violated, Eigen::Vector2d(10.0, 0.0)));
  EXPECT_FALSE(price.paid(violated, Eigen::Vector2d(5.0, 0.0)));
  EXPECT_FALSE(price.paid(Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(10.0, 0.0))) << "active, not violated";
  EXPECT_FALSE(price.highest());
  price.raise();
  EXPECT_TRUE(price.highest());
  EXPECT_FALSE(price.paid(violated, Eigen::Vector2d(10.0, 0.0)));
}

TEST(ViolationPrice, IsTooLowWhereTheViolationStaysAndNotWhereItShrinks) {
  const RowBounds b = bounds();
  ViolationPrice staying(b, kTolerance, VectorXd::Zero(2));
  ViolationPrice shrinking(b, kTolerance, VectorXd::Zero(2));
  int until = 0;
  while (until < 100 && !staying.no_less_violated(until, Eigen::Vector2d(2.0, 0.0))) ++until;
  EXPECT_GT(until, 5);
  EXPECT_LT(until, 100);
  for (int i = 0; i <= until; ++i)
    EXPECT_FALSE(shrinking.no_less_violated(i, Eigen::Vector2d(1.0 + std::pow(0.8, i), 0.0))) << i;
  staying.raise();
  EXPECT_FALSE(staying.no_less_violated(until + 1, Eigen::Vector2d(2.0, 0.0))) << "a new price, a new count";
}

}  // namespace violation_price_test
}  // namespace armtune::internal

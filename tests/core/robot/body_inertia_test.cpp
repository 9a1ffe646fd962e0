#include "core/robot/body_inertia.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {
namespace body_inertia_test {

const Vec3 kCenter(0.1, -0.2, 0.3);

LinkInertia body_with(const Mat3& about_center, double mass = 2.0) {
  return in_frame({mass, Vec3::Zero(), about_center}, Mat3::Identity(), kCenter);
}
Mat3 about_center(const LinkInertia& body) {
  return in_frame(body, Mat3::Identity(), -body.first_moment / body.mass).inertia;
}
Mat3 second_moments(const Mat3& inertia) {
  return 0.5 * inertia.trace() * Mat3::Identity() - inertia;
}

/// Of points with random places and masses: what a body can have.
Mat3 possible_inertia(std::mt19937& generator) {
  std::normal_distribution<double> normal;
  Mat3 second = Mat3::Zero();
  for (int point = 0; point < 6; ++point) {
    const Vec3 r(normal(generator), normal(generator), normal(generator));
    second += r * r.transpose();
  }
  return second.trace() * Mat3::Identity() - second;
}

TEST(BodyInertia, EveryBodyOfPointsIsPossibleAndItsOwnNearest) {
  std::mt19937 generator(3);
  for (int sample = 0; sample < 100; ++sample) {
    const Mat3 inertia = possible_inertia(generator);
    const LinkInertia body = body_with(inertia);
    EXPECT_TRUE(is_physical(body));
    EXPECT_LT((about_center(nearest_physical(body)) - inertia).norm(), 1e-2 * inertia.norm());
  }
}

TEST(BodyInertia, MomentsAreThoseAboutTheCentreOfMassInAnyAxes) {
  const Mat3 R = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  const Vec3 expected(0.2, 0.3, 0.4);
  const Vec3 moments = principal_moments(body_with(R * expected.asDiagonal() * R.transpose()));
  EXPECT_LT((moments - expected).norm(), 1e-12);
}

TEST(BodyInertia, NegativeOrTooUnequalMomentsAreImpossible) {
  EXPECT_FALSE(is_physical(body_with(Vec3(1.0, 1.0, 2.001).asDiagonal())));
  EXPECT_TRUE(is_physical(body_with(Vec3(1.0, 1.0, 2.0001).asDiagonal())));
  EXPECT_FALSE(is_physical(body_with(Vec3(-0.01, 1.0, 1.0).asDiagonal())));
}

// S = diag(1.5, 1.5, -0.5): the negative one goes, to a thousandth of the largest.
TEST(BodyInertia, TheNearestOfATriangleThatDoesNotCloseIsAPlate) {
  const LinkInertia nearest = nearest_physical(body_with(Vec3(1.0, 1.0, 3.0).asDiagonal()));
  EXPECT_LT((about_center(nearest) - Mat3(Vec3(1.5015, 1.5015, 3.0).asDiagonal())).norm(), 1e-12);
  EXPECT_EQ(nearest.mass, 2.0);
  EXPECT_LT((nearest.first_moment - 2.0 * kCenter).norm(), 1e-12);
}

TEST(BodyInertia, NoOtherPossibleOneIsNearer) {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  int impossible = 0;
  for (int sample = 0; sample < 50; ++sample) {
    Mat3 given = possible_inertia(generator);
    const Vec3 axis = Vec3(normal(generator), normal(generator), normal(generator)).normalized();
    given += 2.0 * given.norm() * axis * axis.transpose();
    const LinkInertia body = body_with(given);
    if (is_physical(body)) continue;
    ++impossible;
    const Mat3 nearest = about_center(nearest_physical(body));
    EXPECT_TRUE(is_physical(body_with(nearest)));
    const double distance = (second_moments(nearest) - second_moments(given)).norm();
    // Between the nearest and any other possible one all are possible, so that a small step suffices.
    for (int other = 0; other < 100; ++other) {
      const Mat3 step = 0.99 * nearest + 0.01 * possible_inertia(generator);
      EXPECT_GT((second_moments(step) - second_moments(given)).norm(), distance * (1.0 - 2e-3));
    }
  }
  EXPECT_GT(impossible, 20);
}

}  // namespace body_inertia_test
}  // namespace armtune::internal

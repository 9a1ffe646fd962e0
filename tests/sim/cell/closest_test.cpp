#include "sim/cell/closest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/cell/hull.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"
#include "tests/sim/cell/extreme_point.hpp"

namespace armtune::internal {
namespace closest_test {

using test::random_number;
using test::random_vec3;

/// A hull of forty points.
Solid random_hull(std::mt19937& generator) {
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) points.push_back(random_vec3(generator, 0.1));
  return convex_hull(points).value();
}

Solid random_solid(std::mt19937& generator) {
  const auto length = [&generator] { return random_number(generator, 0.02, 0.4); };
  switch (static_cast<int>(random_number(generator, 0.0, 5.0))) {
    case 0:
      return sphere(length());
    case 1:
      return capsule(0.3 * length(), length());
    case 2:
      return box({length(), length(), length()});
    case 3:
      return cylinder(length(), length());
    default:
      return random_hull(generator);
  }
}

struct Placed {
  Solid solid;
  Mat3 R;
  Vec3 p;
};

Placed placed_anywhere(std::mt19937& generator) {
  return {random_solid(generator), test::random_orientation(generator).toRotationMatrix(),
          random_vec3(generator, 0.4)};
}

Closest closest_of(const Placed& a, const Placed& b) {
  return closest(a.solid, a.R, a.p, b.solid, b.R, b.p);
}

/// A quarter turn about some axis, or none: edges and faces are parallel, as in most cells.
Placed placed_squarely(std::mt19937& generator) {
  Placed placed = placed_anywhere(generator);
  const auto turn = [&generator](const Vec3& axis) {
    const int quarters = static_cast<int>(random_number(generator, 0.0, 4.0));
    return Eigen::AngleAxisd(0.5 * M_PI * quarters, axis);
  };
  placed.R = (turn(Vec3::UnitX()) * turn(Vec3::UnitZ())).toRotationMatrix();
  for (double& x : placed.p) {
    if (random_number(generator, 0.0, 1.0) < 0.4) x = 0.0;
  }
  return placed;
}

/// How far p is from the solid, at most by this; of a hull, from the planes of its triangles [m].
double outside(const Placed& a, const Vec3& p) {
  const Vec3 local = a.R.transpose() * (p - a.p);
  const Vec3& s = a.solid.size;
  switch (a.solid.kind) {
    case SolidKind::kSphere:
      return local.norm() - a.solid.radius;
    case SolidKind::kCapsule:
      return (local - std::clamp(local.z(), -0.5 * s[0], 0.5 * s[0]) * Vec3::UnitZ()).norm() - a.solid.radius;
    case SolidKind::kBox:
      return (local.cwiseAbs() - 0.5 * s).maxCoeff();
    case SolidKind::kCylinder:
      return std::max(std::hypot(local.x(), local.y()) - s[0], std::abs(local.z()) - 0.5 * s[1]);
    case SolidKind::kHull:
      break;
  }
  double most = -1.0;
  for (const auto& triangle : a.solid.triangles) {
    const auto corner = [&](std::size_t k) { return a.solid.corners[static_cast<std::size_t>(triangle[k])]; };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    most = std::max(most, normal.dot(local - corner(0)));
  }
  return most;
}

/// The optimality conditions of the quadratic program "two points, one of each body, as close as can be",
/// computed without the algorithm: both points are in their bodies, and the plane across the line between
/// them separates the bodies by their distance.
void expect_closest(const Placed& a, const Placed& b, const Closest& found, test::WorstError& law) {
  const std::string kinds = fmt::format("kinds {} and {}", int(a.solid.kind), int(b.solid.kind));
  law.add(std::abs((found.on_a - found.on_b).norm() - found.distance), kinds);
  law.add(std::max(outside(a, found.on_a), outside(b, found.on_b)), kinds);
  const Vec3 line = (found.on_b - found.on_a).normalized();
  const Vec3 of_a = test::extreme_point(a.solid, a.R, a.p, line);
  const Vec3 of_b = test::extreme_point(b.solid, b.R, b.p, -line);
  law.add(found.distance - line.dot(of_b - of_a), kinds);
}

TEST(Closest, FindsThePointsThatNoOthersAreCloserThan) {
  std::mt19937 generator(3);
  test::WorstError law("optimality", 3e-9);
  int apart = 0;
  int meeting = 0;
  for (int k = 0; k < 20000; ++k) {
    const bool squarely = k % 2 == 0;
    const Placed a = squarely ? placed_squarely(generator) : placed_anywhere(generator);
    const Placed b = squarely ? placed_squarely(generator) : placed_anywhere(generator);
    const Closest found = closest_of(a, b);
    if (found.distance > 1e-6) {
      ++apart;
      expect_closest(a, b, found, law);
    } else {
      ++meeting;
    }
  }
  EXPECT_GT(apart, 5000);
  EXPECT_GT(meeting, 2000);
}

/// The point of a body, other than a hull, that is closest to x.
Vec3 projected(const Placed& a, const Vec3& x) {
  Vec3 local = a.R.transpose() * (x - a.p);
  const Vec3& s = a.solid.size;
  const auto into_ball = [](const Vec3& center, double radius, const Vec3& point) {
    const Vec3 line = point - center;
    return line.norm() > radius ? Vec3(center + radius * line.normalized()) : point;
  };
  switch (a.solid.kind) {
    case SolidKind::kSphere:
      local = into_ball(Vec3::Zero(), a.solid.radius, local);
      break;
    case SolidKind::kCapsule:
      local =
          into_ball(std::clamp(local.z(), -0.5 * s[0], 0.5 * s[0]) * Vec3::UnitZ(), a.solid.radius, local);
      break;
    case SolidKind::kBox:
      local = local.cwiseMax(-0.5 * s).cwiseMin(0.5 * s);
      break;
    default: {
      const double across = std::hypot(local.x(), local.y());
      if (across > s[0]) local.head<2>() *= s[0] / across;
      local.z() = std::clamp(local.z(), -0.5 * s[1], 0.5 * s[1]);
    }
  }
  return a.p + a.R * local;
}

/// Projections onto one body and the other in turn end at the closest points (Cheney and Goldstein, 1959),
/// or, of bodies that meet, in both.
TEST(Closest, MeetsWhereProjectionsInTurnMeet) {
  std::mt19937 generator(5);
  test::WorstError law("distance", 1e-6);
  int meeting = 0;
  for (int k = 0; k < 1500; ++k) {
    const Placed a = placed_anywhere(generator);
    const Placed b = placed_anywhere(generator);
    if (a.solid.kind == SolidKind::kHull || b.solid.kind == SolidKind::kHull) continue;
    Vec3 on_b = b.p;
    double apart = 1.0;
    for (int step = 0; step < 20000; ++step) {
      const Vec3 on_a = projected(a, on_b);
      on_b = projected(b, on_a);
      const double now = (on_a - on_b).norm();
      if (step > 50 && apart - now < 1e-14) break;
      apart = now;
    }
    const double found = closest_of(a, b).distance;
    if (apart > 1e-5) {
      law.add(std::abs(found - apart), fmt::format("kinds {} and {}", int(a.solid.kind), int(b.solid.kind)));
    } else if (apart < 1e-9) {
      ++meeting;
      EXPECT_LT(found, 1e-6);
    }
  }
  EXPECT_GT(meeting, 100);
}

TEST(Closest, RoundBodiesKnowHowDeepTheyMeetAndOthersThatTheyDo) {
  const Mat3 I = Mat3::Identity();
  const auto at = [](double x) { return Vec3(x, 0.0, 0.0); };
  const Placed ball{sphere(0.1), I, at(0.0)};
  const Placed line{capsule(0.05, 0.4), I, at(0.12)};
  EXPECT_NEAR(closest_of(ball, line).distance, -0.03, 1e-12);
  EXPECT_NEAR(closest_of(line, ball).distance, -0.03, 1e-12);
  const Placed same{capsule(0.05, 0.4), I, at(0.0)};
  EXPECT_NEAR(closest_of(ball, same).distance, -0.15, 1e-12) << "the cores meet";
  const Placed block{box({0.2, 0.2, 0.2}), I, at(0.1)};
  EXPECT_NEAR(closest_of(Placed{sphere(0.1), I, at(-0.05)}, block).distance, -0.05, 1e-12);
  const Closest deep = closest_of(Placed{box({0.2, 0.2, 0.2}), I, at(0.0)}, block);
  EXPECT_LT(deep.distance, 0.0);
}

TEST(Support, IsThatOfTheExtremePoint) {
  std::mt19937 generator(5);
  for (int k = 0; k < 300; ++k) {
    const Solid solid = random_solid(generator);
    const Vec3 d = random_vec3(generator, 1.0).normalized();
    const Vec3 point = test::extreme_point(solid, Mat3::Identity(), Vec3::Zero(), d);
    EXPECT_NEAR(support(solid, d), d.dot(point), 1e-12);
  }
}

TEST(Farthest, NoPointOfTheSolidLiesFarther) {
  std::mt19937 generator(6);
  for (int k = 0; k < 300; ++k) {
    const Placed a = placed_anywhere(generator);
    const PlacedSolid placed{a.solid, a.R, a.p};
    const Vec3 from = random_vec3(generator, 0.5);
    for (int i = 0; i < 20; ++i) {
      const Vec3 d = random_vec3(generator, 1.0).normalized();
      const Vec3 point = test::extreme_point(a.solid, a.R, a.p, d);
      EXPECT_LE((point - from).norm(), farthest(placed, from) + 1e-12);
      EXPECT_LE(std::hypot(point.x(), point.y()), farthest_from_z(placed) + 1e-12);
    }
  }
}

TEST(ConvexHull, HoldsEveryPointAndIsClosed) {
  std::mt19937 generator(7);
  for (int k = 0; k < 20; ++k) {
    std::vector<Vec3> points;
    for (int i = 0; i < 400; ++i) points.push_back(random_vec3(generator, 0.3));
    const Solid hull = convex_hull(points).value();
    EXPECT_EQ(hull.triangles.size(), 2 * hull.corners.size() - 4) << "Euler";
    for (const auto& triangle : hull.triangles) {
      const Vec3& a = hull.corners[static_cast<std::size_t>(triangle[0])];
      const Vec3& b = hull.corners[static_cast<std::size_t>(triangle[1])];
      const Vec3& c = hull.corners[static_cast<std::size_t>(triangle[2])];
      const Vec3 outside = (b - a).cross(c - a).normalized();
      for (const Vec3& point : points) EXPECT_LE(outside.dot(point - a), 1e-9);
    }
  }
}

/// Bodies of a hundred metres that meet deeply are not taken for bodies a hair apart.
TEST(Closest, LargeBodiesThatMeetMeet) {
  std::mt19937 generator(9);
  for (int k = 0; k < 20000; ++k) {
    Placed disc{cylinder(random_number(generator, 10.0, 100.0), 0.5),
                test::random_orientation(generator).toRotationMatrix(), Vec3::Zero()};
    Placed link{k % 2 == 0 ? cylinder(0.1, 1.0) : box({0.3, 0.3, 1.0}),
                test::random_orientation(generator).toRotationMatrix(), Vec3::Zero()};
    // The link's centre within the disc.
    link.p = disc.R * Vec3(random_number(generator, -5.0, 5.0), random_number(generator, -5.0, 5.0),
                           random_number(generator, -0.2, 0.2));
    EXPECT_LT(closest_of(link, disc).distance, 0.0);
  }
}

TEST(ConvexHull, OfPointsInATiltedPlaneThereIsNoneEither) {
  std::vector<Vec3> points;
  for (const auto& [x, y] : {std::pair(1.0, 0.0), std::pair(0.0, 1.0), std::pair(0.2, 0.3),
                             std::pair(0.1, 0.1), std::pair(0.6, 0.1)})
    points.emplace_back(x, y, 1.0 - x - y);
  EXPECT_FALSE(convex_hull(points));
}

TEST(ConvexHull, OfPointsInAPlaneThereIsNone) {
  std::vector<Vec3> points;
  for (int i = 0; i < 50; ++i) points.emplace_back(std::cos(i), std::sin(i), 0.5 * std::cos(i));
  EXPECT_FALSE(convex_hull(points));
  EXPECT_FALSE(convex_hull(std::vector<Vec3>(10, Vec3(1.0, 2.0, 3.0))));
  EXPECT_FALSE(convex_hull({}));
  points[3].x() = NAN;
  EXPECT_FALSE(convex_hull(points));
}

}  // namespace closest_test
}  // namespace armtune::internal

#include "core/trajectory/tool_orientation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "core/trajectory/cubic_spline.hpp"
#include "core/trajectory/polyline.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace tool_orientation_test {

using test::derivative;
using test::random_vec3;
using test::WorstError;

/// A curve that never stops: a circle with a smaller one twice as fast on it.
Path curve() {
  return {
      Vec3(0.5, 0.1, 0.4),
      0.8,
      0.3,
      {{1, Vec3(0.2, 0.0, 0.02), Vec3(0.0, 0.25, 0.03)}, {2, Vec3(0.0, 0.03, 0.0), Vec3(0.02, 0.0, 0.0)}}};
}

Path through_corners(bool closed) {
  Path path;
  const std::vector<Vec3> corners = {Vec3(0.0, 0.0, 0.0), Vec3(0.5, 0.0, 0.0), Vec3(0.5, 0.4, 0.1),
                                     Vec3(0.0, 0.4, 0.0)};
  path.spline = std::make_shared<const PositionSpline>(polyline(corners, 0.2, 0.08, closed));
  return path;
}

/// Velocity and acceleration of the orientation are how it turns: R' = [w] R, by differences.
void expect_rates(const ToolOrientation& orientation, const Path& path, double t, double tolerance,
                  const std::string& where) {
  const OrientationPoint now = orientation.at(t, path);
  const auto turn = [&](double s) {
    return rotation_log(orientation.at(t + s, path).orientation * now.orientation.conjugate());
  };
  const auto velocity = [&](double s) { return Vec3(orientation.at(t + s, path).angular_velocity); };
  EXPECT_LT((now.angular_velocity - derivative(turn)).norm(), tolerance) << where;
  EXPECT_LT((now.angular_acceleration - derivative(velocity)).norm(), tolerance) << where;
}

TEST(ToolOrientation, AFixedOneStands) {
  std::mt19937 generator(721);
  const ToolOrientation fixed{test::random_orientation(generator)};
  const OrientationPoint at = fixed.at(3.0, curve());
  EXPECT_EQ(at.orientation.coeffs(), fixed.start.coeffs());
  EXPECT_TRUE(at.angular_velocity.isZero(0.0) && at.angular_acceleration.isZero(0.0));
  EXPECT_TRUE(fixed.rests(curve()));
}

TEST(ToolOrientation, AlongThePathXIsAheadAndZAsNearAsItCanBe) {
  std::mt19937 generator(722);
  for (const Path& path : {curve(), through_corners(true), through_corners(false)}) {
    for (int sample = 0; sample < 20; ++sample) {
      ToolOrientation along;
      along.approach = Vec3(0.1, -0.2, -2.0);
      EXPECT_FALSE(along.rests(path));
      const double t = test::random_number(generator, 0.2, 5.0);
      const Mat3 R = along.at(t, path).orientation.toRotationMatrix();
      const Vec3 ahead = path.at(t).velocity.normalized();
      EXPECT_LT((R.col(0) - ahead).norm(), 1e-12) << t;
      // Of all directions across the path none is nearer: the rest of the approach is along it.
      EXPECT_GT(R.col(2).dot(*along.approach), 0.0);
      EXPECT_LT(std::abs(R.col(1).dot(*along.approach)), 1e-12) << t;
      EXPECT_NEAR(R.determinant(), 1.0, 1e-12);
    }
  }
}

TEST(ToolOrientation, AlongThePathItTurnsAsItsRatesSay) {
  ToolOrientation along;
  along.approach = Vec3(0.1, -0.2, -1.0);
  // Differences: harmonics are smooth, of a blend's quintics the fifth derivative is some 1e4 times h^4 / 30.
  for (double t = 0.05; t < 7.0; t += 0.37) expect_rates(along, curve(), t, 1e-9, fmt::format("curve {}", t));
  const Path path = through_corners(true);
  int turning = 0;
  for (double t = 0.05; t < 7.0; t += 0.11) {
    // Not across a knot, where the jerk jumps and with it w'.
    bool near_knot = false;
    for (const double knot : path.spline->time()) near_knot = near_knot || std::abs(knot - t) < 0.01;
    if (near_knot) continue;
    turning += along.at(t, path).angular_velocity.norm() > 0.1 ? 1 : 0;
    expect_rates(along, path, t, 1e-5, fmt::format("corners {}", t));
  }
  EXPECT_GT(turning, 3) << "corners are turned round";
}

TEST(ToolOrientation, AtTheEndsOfAPathItStandsAsItBeginsAndEnds) {
  const Path path = through_corners(false);
  ToolOrientation along;
  along.approach = Vec3(0.0, 0.0, -1.0);
  const auto at = [&](double t) { return along.at(t, path); };
  EXPECT_LT((at(-1.0).orientation * Vec3::UnitX() - Vec3::UnitX()).norm(), 1e-9);
  EXPECT_TRUE(at(-1.0).angular_velocity.isZero(0.0));
  EXPECT_LT((at(path.spline->end() + 9.0).orientation * Vec3::UnitX() -
             (Vec3(0.0, 0.4, 0.0) - Vec3(0.5, 0.4, 0.1)).normalized())
                .norm(),
            1e-9);
  EXPECT_LT((at(0.0).orientation.coeffs() - at(0.3).orientation.coeffs()).norm(), 1e-9) << "straight ahead";
}

TEST(ToolOrientation, AtTheEndsOfACurveThatIsShiftedInTimeItStandsToo) {
  Path path;
  const std::vector<double> time = {0.0, 1.0, 3.0};
  const std::vector<Vec3> points = {Vec3(0.0, 0.0, 0.0), Vec3(0.3, 0.2, 0.0), Vec3(0.4, 0.6, 0.1)};
  path.spline = std::make_shared<const PositionSpline>(time, cubic_spline(time, points), false);
  path.spline_rate = 2.0;
  path.spline_lead = 0.4;  // from -0.2 s to 1.3 s
  ToolOrientation along;
  along.approach = Vec3(0.2, 0.1, -1.0);
  for (const double t : {-5.0, -0.2, 1.3, 5.0})
    EXPECT_TRUE(along.at(t, path).angular_velocity.isZero(0.0)) << t;
  for (const double t : {-0.19, -0.1, 0.5, 1.2})
    EXPECT_GT(along.at(t, path).angular_velocity.norm(), 0.01) << t;
  EXPECT_LT(
      rotation_log(along.at(-5.0, path).orientation * along.at(-0.199, path).orientation.conjugate()).norm(),
      0.01);
}

TEST(ToolOrientation, ThroughWaypointsItIsWhatTheySayWhenTheySayIt) {
  std::mt19937 generator(723);
  const std::vector<double> time = {0.5, 1.5, 2.0, 4.0};
  std::vector<Eigen::Quaterniond> wanted;
  wanted.push_back(test::random_orientation(generator));
  for (int i = 1; i < 4; ++i) wanted.push_back(rotation_exp(random_vec3(generator, 0.8)) * wanted.back());
  wanted[2].coeffs() *= -1.0;  // the same orientation
  const ToolOrientation turning = turning_through(time, wanted);
  const Path path;
  EXPECT_FALSE(turning.rests(path));
  for (std::size_t i = 0; i < time.size(); ++i) {
    const Eigen::Quaterniond at = turning.at(time[i], path).orientation;
    EXPECT_LT(rotation_log(at * wanted[i].conjugate()).norm(), 1e-12) << i;
  }
  for (const double t : {0.51, 0.9, 1.3, 1.7, 2.6, 3.9})
    expect_rates(turning, path, t, 1e-8, fmt::format("{}", t));
  for (const double t : {0.0, 0.5, 4.0, 9.0})
    EXPECT_LT(turning.at(t, path).angular_velocity.norm(), 1e-12) << "it rests at both ends";
}

TEST(ToolOrientation, GoesOnTheShorterWayFromWaypointToWaypoint) {
  const auto about_z = [](double degrees) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * M_PI / 180.0, Vec3::UnitZ()));
  };
  const std::vector<double> time = {0.0, 1.0, 2.0, 3.0};
  const ToolOrientation turning =
      turning_through(time, {about_z(0), about_z(100), about_z(200), about_z(300)});
  for (double t = 0.2; t < 3.0; t += 0.2) EXPECT_GT(turning.at(t, {}).angular_velocity.z(), 0.0) << t;
  // On past a whole turn, too: how far is for the caller to refuse.
  for (const double degrees : {360.0, 400.0}) {
    const ToolOrientation on = turning_through(
        {0.0, 1.0, 2.0, 3.0, 4.0}, {about_z(0), about_z(100), about_z(200), about_z(300), about_z(degrees)});
    EXPECT_NEAR(on.turn->knots().back().position.z(), degrees * M_PI / 180.0, 1e-12);
  }
}

}  // namespace tool_orientation_test
}  // namespace armtune::internal

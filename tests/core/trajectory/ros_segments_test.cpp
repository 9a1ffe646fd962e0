#include "core/trajectory/ros_segments.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>

#include "core/trajectory/joint_spline.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace ros_segments_test {

using test::derivative;
using test::random_number;
using test::random_vector;
using test::WorstError;

const std::map<std::string, PointsGive> kGiven = {{"positions", PointsGive::kPositions},
                                                  {"velocities", PointsGive::kVelocities},
                                                  {"accelerations", PointsGive::kAccelerations}};
constexpr PointsGive kAll[] = {PointsGive::kPositions, PointsGive::kVelocities, PointsGive::kAccelerations};

/// A trajectory of one joint out of the file of vectors.
struct Vector {
  std::string name;
  PointsGive given = PointsGive::kPositions;
  std::vector<double> time;
  std::vector<MotionPoint<JointVector>> points;
};

MotionPoint<JointVector> one_joint(std::istringstream& words) {
  double p = 0.0, v = 0.0, a = 0.0;
  words >> p >> v >> a;
  const auto single = [](double value) { return JointVector(JointVector::Constant(1, value)); };
  return {single(p), single(v), single(a)};
}

TEST(RosSegments, GoWhereTheSourceOfRosTakesThem) {
  std::ifstream file(test::source_dir() + "/tests/core/trajectory/data/ros_segments.txt");
  ASSERT_TRUE(file);
  WorstError worst("vectors", 1e-12);
  Vector vector;
  std::string line, word;
  int samples = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    words >> word;
    if (word == "case") {
      vector = Vector();
      words >> vector.name >> word;
      vector.given = kGiven.at(word);
      continue;
    }
    double time = 0.0;
    words >> time;
    const MotionPoint<JointVector> at = one_joint(words);
    ASSERT_TRUE(words) << line;
    if (word == "point") {
      vector.time.push_back(time);
      vector.points.push_back(at);
      continue;
    }
    ASSERT_EQ(word, "sample");
    const auto found = JointSpline(vector.time, vector.points, vector.given).at(time);
    worst.compare(found.position, at.position, vector.name + " position", 1.0);
    worst.compare(found.velocity, at.velocity, vector.name + " velocity", 1.0);
    worst.compare(found.acceleration, at.acceleration, vector.name + " acceleration", 1.0);
    ++samples;
  }
  EXPECT_GE(samples, 40);
}

/// Seven joints through points at uneven times.
Vector random_points(unsigned seed, PointsGive given) {
  std::mt19937 generator(seed);
  Vector vector;
  vector.given = given;
  for (int k = 0; k < 12; ++k) {
    vector.time.push_back(k == 0 ? 3.0 : vector.time.back() + random_number(generator, 0.5, 2.0));
    vector.points.push_back({random_vector(generator, 7, 2.0), random_vector(generator, 7, 1.0),
                             random_vector(generator, 7, 3.0)});
  }
  return vector;
}

TEST(RosSegments, BeginAndEndWithAllThatBothPointsGive) {
  WorstError worst("ends", 1e-11);
  for (const PointsGive given : kAll) {
    const Vector v = random_points(931, given);
    const auto segments = ros_segments(v.time, v.points, given);
    ASSERT_EQ(segments.size(), v.points.size() - 1);
    for (std::size_t k = 0; k < segments.size(); ++k) {
      const double T = v.time[k + 1] - v.time[k];
      EXPECT_EQ(segments[k].duration(), T);
      for (const auto& [s, point] : {std::pair{0.0, v.points[k]}, std::pair{T, v.points[k + 1]}}) {
        worst.compare(segments[k].at(s).position, point.position, "position", 1.0);
        if (given != PointsGive::kPositions)
          worst.compare(segments[k].at(s).velocity, point.velocity, "velocity", 1.0);
        if (given == PointsGive::kAccelerations)
          worst.compare(segments[k].at(s).acceleration, point.acceleration, "acceleration", 1.0);
      }
    }
  }
}

TEST(RosSegments, HaveTheLowestDegreeThatDoesSo) {
  WorstError worst("degree", 1e-12);  // rounding
  const Vector line = random_points(932, PointsGive::kPositions);
  for (const auto& segment : ros_segments(line.time, line.points, PointsGive::kPositions)) {
    for (const double share : {0.1, 0.6})
      worst.compare(segment.at(share * segment.duration()).acceleration, JointVector(JointVector::Zero(7)),
                    "a line", 1.0);
  }
  // Of a cubic the jerk is the same everywhere.
  const Vector cubic = random_points(933, PointsGive::kVelocities);
  for (const auto& segment : ros_segments(cubic.time, cubic.points, PointsGive::kVelocities)) {
    const JointVector jerk = segment.jerk(0.0);
    for (const double share : {0.3, 1.0})
      worst.compare(JointVector((segment.jerk(share * segment.duration()) - jerk) / (1.0 + jerk.norm())),
                    JointVector(JointVector::Zero(7)), "a cubic", 1.0);
  }
}

TEST(JointSpline, AlongRosSegmentsVelocityAndAccelerationAreTheDerivatives) {
  WorstError worst("derivative", 1e-8);  // fifth derivatives up to 2e5 / s^5, over steps of 1 ms
  for (const PointsGive given : kAll) {
    const Vector v = random_points(934, given);
    const JointSpline motion(v.time, v.points, given);
    for (std::size_t k = 1; k < v.time.size(); ++k) {
      const double t = 0.7 * v.time[k - 1] + 0.3 * v.time[k];
      worst.compare(derivative([&](double d) { return motion.at(t + d).position; }), motion.at(t).velocity,
                    "velocity", 1.0);
      worst.compare(derivative([&](double d) { return motion.at(t + d).velocity; }),
                    motion.at(t).acceleration, "acceleration", 1.0);
    }
  }
}

TEST(JointSpline, AlongRosSegmentsItEndsAsItsLastPointSays) {
  const Vector v = random_points(935, PointsGive::kVelocities);
  const MotionPoint<JointVector>& last = v.points.back();
  const JointVector zero = JointVector::Zero(7);
  for (const double after : {0.0, 1.0}) {
    const double t = v.time.back() + after;
    const auto line = JointSpline(v.time, v.points, PointsGive::kPositions).at(t);
    EXPECT_EQ(line.position, last.position);
    EXPECT_EQ(line.velocity, zero);
    const auto cubic = JointSpline(v.time, v.points, PointsGive::kVelocities).at(t);
    EXPECT_EQ(cubic.velocity, last.velocity);
    EXPECT_EQ(cubic.acceleration, zero);
    const auto quintic = JointSpline(v.time, v.points, PointsGive::kAccelerations).at(t);
    EXPECT_EQ(quintic.acceleration, last.acceleration);
  }
}

}  // namespace ros_segments_test
}  // namespace armtune::internal

#include "tuner/solver/differences.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace differences_test {

using Point = std::vector<double>;

SolverValue quadratic(const Point& x) {
  return {x[0] * x[0] + 3.0 * x[0] * x[1], {2.0 * x[0] - x[1], x[1] * x[1]}};
}

class Difference : public testing::Test {
 protected:
  Difference() {
    problem_.start = {0.5, 0.5};
    problem_.constraint_count = 2;
    options_.difference_step = 1e-3;
  }
  std::vector<Point> points(const Point& x) const { return difference_points(problem_, options_, x); }
  SolverAnswer at(const Point& x) const {
    SolverAnswer answer;
    answer.value = quadratic(x);
    std::vector<SolverValue> values;
    for (const Point& point : points(x)) values.push_back(quadratic(point));
    set_gradients(problem_, options_, x, values, answer);
    return answer;
  }
  static void expect_derivatives(const SolverAnswer& answer, const Point& x, double tolerance) {
    EXPECT_NEAR(answer.gradient[0], 2.0 * x[0] + 3.0 * x[1], tolerance);
    EXPECT_NEAR(answer.gradient[1], 3.0 * x[0], tolerance);
    EXPECT_NEAR(answer.constraint_gradients[0], 2.0, tolerance);
    EXPECT_NEAR(answer.constraint_gradients[1], -1.0, tolerance);
    EXPECT_NEAR(answer.constraint_gradients[2], 0.0, tolerance);
    EXPECT_NEAR(answer.constraint_gradients[3], 2.0 * x[1], tolerance);
  }

  SolverProblem problem_;
  SolverOptions options_;
};

TEST_F(Difference, ForwardTakesOnePointPerCoordinateAndIsExactToTheStep) {
  EXPECT_EQ(points({0.4, 0.7}).size(), 2U);
  // The second derivatives are 2 at most: half of that, times the step.
  expect_derivatives(at({0.4, 0.7}), {0.4, 0.7}, 1.001 * options_.difference_step);
}

TEST_F(Difference, CentralTakesTwoAndIsExactForQuadratics) {
  options_.differences = Differences::kCentral;
  EXPECT_EQ(points({0.4, 0.7}).size(), 4U);
  expect_derivatives(at({0.4, 0.7}), {0.4, 0.7}, 1e-12);  // rounding, over the step
}

TEST_F(Difference, AtBoundsItStepsTowardsTheInside) {
  problem_.lower = {0.2, 0.0};
  problem_.upper = {0.6, 0.5};
  for (const Differences kind : {Differences::kForward, Differences::kCentral}) {
    options_.differences = kind;
    for (const Point& x : {Point{0.2, 0.5}, Point{0.6, 0.0}, Point{0.5999, 0.0001}}) {
      for (const Point& p : points(x)) {
        for (std::size_t i = 0; i < 2; ++i) {
          EXPECT_GE(p[i], problem_.lower[i]);
          EXPECT_LE(p[i], problem_.upper[i]);
        }
        EXPECT_NE(p, x);
      }
      expect_derivatives(at(x), x, 1.001 * options_.difference_step);
    }
  }
}

TEST_F(Difference, InABoxNarrowerThanTheStepItGoesToTheFartherSide) {
  problem_.lower = {0.5, 0.0};
  problem_.upper = {0.5004, 1.0};
  const auto around = points({0.5001, 0.3});
  ASSERT_EQ(around.size(), 2U);
  EXPECT_EQ(around[0][0], 0.5004);
  expect_derivatives(at({0.5001, 0.3}), {0.5001, 0.3}, 1.001 * options_.difference_step);
}

TEST(Gradients, AreFormedFromOneBatchOfMarkedPoints) {
  for (const char* algorithm : {"SLSQP"}) {
    SolverProblem problem;
    problem.start = {0.9, 0.8, 0.7};
    SolverOptions options;
    options.algorithm = algorithm;
    std::vector<std::vector<SolverPoint>> batches;
    problem.evaluate = [&](const std::vector<SolverPoint>& points, std::vector<SolverValue>& values) {
      batches.push_back(points);
      for (const SolverPoint& p : points) {
        values.push_back({std::pow(p.x[0] - 0.3, 2) + p.x[1] * p.x[1] + p.x[2], {}});
      }
      return batches.size() < 40;
    };
    minimize(problem, options);
    ASSERT_EQ(batches.front().size(), 4U) << algorithm;
    EXPECT_EQ(batches.front()[0].x, problem.start);
    EXPECT_FALSE(batches.front()[0].difference);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_TRUE(batches.front()[i].difference) << algorithm;
  }
}

}  // namespace differences_test
}  // namespace armtune::internal

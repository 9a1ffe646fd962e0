// What minimize adds to the bare algorithm: a point is evaluated once, however often it is asked for.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tuner/solver/solver.hpp"

namespace armtune::internal {
namespace minimize_test {

using Point = std::vector<double>;

constexpr std::size_t kAsked = 330;

/// A bowl with ripples, under a plane that cuts its bottom off.
SolverValue bowl(const Point& x) {
  SolverValue value;
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double centre = 0.2 + 0.6 * static_cast<double>(i) / static_cast<double>(x.size());
    value.objective += std::pow(x[i] - centre, 2) + 0.01 * std::sin(30.0 * x[i]);
    sum += x[i];
  }
  value.constraints = {sum / static_cast<double>(x.size()) - 0.4};
  return value;
}

SolverProblem problem_of(std::size_t n) {
  SolverProblem problem;
  problem.start.assign(n, 0.3);
  problem.constraint_count = 1;
  return problem;
}

/// The points that the bare algorithm asks for, each at its first time.
std::vector<Point> asked_by_the_algorithm(const SolverOptions& options, std::size_t n) {
  std::vector<Point> points;
  std::size_t asked = 0;
  run_algorithm(problem_of(n), options, [&](const Point& x, bool, SolverAnswer& answer) {
    if (asked++ == kAsked) return false;
    answer.value = bowl(x);
    if (std::find(points.begin(), points.end(), x) == points.end()) points.push_back(x);
    return true;
  });
  return points;
}

std::vector<Point> evaluated(const SolverOptions& options, std::size_t n, std::size_t budget) {
  std::vector<Point> points;
  SolverProblem problem = problem_of(n);
  problem.evaluate = [&](const std::vector<SolverPoint>& wanted, std::vector<SolverValue>& values) {
    EXPECT_EQ(wanted.size(), 1U);
    if (points.size() == budget) return false;
    points.push_back(wanted.front().x);
    values.push_back(bowl(wanted.front().x));
    return true;
  };
  minimize(problem, options);
  return points;
}

class EveryMinimize : public testing::TestWithParam<std::string> {};

TEST_P(EveryMinimize, EvaluatesThePointsOfTheAlgorithmInItsOrderEachOnce) {
  for (const ConstraintHandling handling : {ConstraintHandling::kAuto, ConstraintHandling::kPenalty}) {
    SolverOptions options;
    options.algorithm = GetParam();
    options.constraints = handling;
    const std::vector<Point> expected = asked_by_the_algorithm(options, 4);
    EXPECT_EQ(evaluated(options, 4, expected.size()), expected);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const AlgorithmInfo& a : algorithms()) {
    if (!a.uses_differences) all.emplace_back(a.name);  // those have batches: differences_test.cpp
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Algorithms, EveryMinimize, testing::ValuesIn(names()),
                         [](const auto& algorithm) { return algorithm.param; });

TEST(Minimize, EndsWithAPopulationThatHasBecomeOnePoint) {
  SolverOptions options;
  options.algorithm = "CRS2";
  options.x_tolerance = 0.0;
  for (const double sign : {1.0, -1.0}) {  // best at the lower bound, at the upper one
    SolverProblem problem;
    problem.start = {0.3};
    std::size_t evaluated = 0;
    problem.evaluate = [&](const std::vector<SolverPoint>& points, std::vector<SolverValue>& values) {
      evaluated += points.size();
      for (const SolverPoint& point : points) values.push_back({sign * point.x[0], {}});
      return evaluated < 5000;
    };
    const SolverOutcome outcome = minimize(problem, options);
    EXPECT_LT(evaluated, 5000U);
    EXPECT_FALSE(outcome.stopped) << "by nothing but itself";
    EXPECT_THAT(outcome.reason, testing::HasSubstr("only repeats known points"));
  }
}

}  // namespace minimize_test
}  // namespace armtune::internal

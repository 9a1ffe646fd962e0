#include "tuner/search/bar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "tuner/search/solver.hpp"

namespace armtune {
namespace {

using Point = std::vector<double>;

/// A valley with ripples, tilted at random, under a plane that cuts its bottom off; constraints as penalties.
class Valley {
 public:
  Valley(std::size_t n, unsigned seed) {
    std::seed_seq sequence{seed};
    std::mt19937 draw(sequence);
    std::uniform_real_distribution<double> uniform(0.1, 0.9);
    for (std::size_t i = 0; i < n; ++i) centre_.push_back(uniform(draw));
  }
  SolverValue at(const Point& x) const {
    SolverValue value;
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double off = x[i] - centre_[i] + (i > 0 ? 0.5 * (x[i - 1] - centre_[i - 1]) : 0.0);
      value.objective += 1.0 + off * off + 0.05 * std::sin(25.0 * x[i]);
      sum += x[i];
    }
    value.constraints = {sum / static_cast<double>(x.size()) - 0.4};
    return value;
  }

 private:
  Point centre_;
};

constexpr double kPenalty = 2.0;

double penalised(const SolverValue& value) {
  return value.objective + kPenalty * std::max(0.0, value.constraints[0]);
}

struct Asked {
  std::vector<Point> points;  ///< every one asked for, repeats of the last one aside
  std::size_t above = 0;      ///< values above the bar
};

/// What is told of a value above the bar.
using Instead = SolverValue (*)(const SolverValue& value, double bar);

Asked bare(const std::string& algorithm, const Valley& valley, std::size_t n, std::size_t most,
           Instead instead) {
  Asked asked;
  SolverProblem problem;
  problem.start.assign(n, 0.3);
  problem.constraint_count = 1;
  SolverOptions options;
  options.algorithm = algorithm;
  options.constraints = ConstraintHandling::kPenalty;
  options.penalty = kPenalty;
  options.x_tolerance = 1e-9;
  run_algorithm(problem, options, [&](const Point& x, bool, const Bar& bar, SolverAnswer& answer) {
    if (asked.points.size() == most) return false;
    asked.points.push_back(x);
    answer.value = valley.at(x);
    if (penalised(answer.value) > bar.now()) {
      ++asked.above;
      answer.value = instead(answer.value, bar.now());
    }
    return true;
  });
  return asked;
}

SolverValue itself(const SolverValue& value, double) {
  return value;
}
SolverValue just_above(const SolverValue&, double bar) {
  return {std::nextafter(bar, HUGE_VAL), {-1.0}};
}
SolverValue far_above(const SolverValue&, double) {
  return {1e6, {3.0}};
}

class EveryBar : public testing::TestWithParam<std::string> {};

TEST_P(EveryBar, MakesNoDifferenceToTheSearchWhateverIsToldAboveIt) {
  std::size_t above = 0;
  for (const std::size_t n : {1U, 2U, 5U}) {
    for (unsigned seed = 0; seed < 8; ++seed) {
      const Valley valley(n, seed);
      const Asked whole = bare(GetParam(), valley, n, 700, itself);
      EXPECT_EQ(bare(GetParam(), valley, n, 700, just_above).points, whole.points) << n << ' ' << seed;
      EXPECT_EQ(bare(GetParam(), valley, n, 700, far_above).points, whole.points) << n << ' ' << seed;
      above += whole.above;
    }
  }
  EXPECT_GT(above, 1000U) << "there is something to save";
}

INSTANTIATE_TEST_SUITE_P(Algorithms, EveryBar, testing::Values(std::string("CRS2"), std::string("ESCH")),
                         [](const auto& algorithm) { return algorithm.param; });

/// The lowest value that a search can be told above `bar` without going another way is that bar: anything
/// below counts.
TEST(Bar, IsAsLowAsItCanBe) {
  const auto just_below = [](const SolverValue&, double bar) -> SolverValue {
    return {std::nextafter(bar, 0.0), {-1.0}};
  };
  for (const char* algorithm : {"CRS2", "ESCH"}) {
    const Valley valley(3, 1);
    EXPECT_NE(bare(algorithm, valley, 3, 700, just_below).points,
              bare(algorithm, valley, 3, 700, itself).points)
        << algorithm;
  }
}

TEST(Bar, OthersHaveNone) {
  for (const AlgorithmInfo& a : algorithms()) {
    const std::string name = a.name;
    if (name == "CRS2" || name == "ESCH") continue;
    Bar bar(name, 2);
    for (int i = 0; i < 100; ++i) bar.told(1.0 / (1.0 + i));
    EXPECT_EQ(bar.now(), HUGE_VAL) << name;
  }
}

TEST(Bar, HoldsForTheValuesThatTheSearchComparesOnly) {
  // With an augmented Lagrangian around it an algorithm compares other values than the objective's.
  SolverProblem problem;
  problem.start = {0.3, 0.3};
  problem.constraint_count = 1;
  SolverOptions options;
  options.algorithm = "CRS2";
  options.constraints = ConstraintHandling::kLagrangian;
  const Valley valley(2, 1);
  std::size_t asked = 0;
  run_algorithm(problem, options, [&](const Point& x, bool, const Bar& bar, SolverAnswer& answer) {
    EXPECT_EQ(bar.now(), HUGE_VAL);
    answer.value = valley.at(x);
    return ++asked < 50;
  });
  EXPECT_EQ(asked, 50U);
}

/// A whole search, with its batches: what lies above the bar is given up.
std::vector<Point> minimised(const std::string& algorithm, std::size_t look_ahead, bool give_up,
                             std::size_t& given_up) {
  const Valley valley(4, 3);
  std::vector<Point> points;
  SolverProblem problem;
  problem.start.assign(4, 0.3);
  problem.constraint_count = 1;
  problem.evaluate = [&](const std::vector<SolverPoint>& asked, std::vector<SolverValue>& values) {
    for (const SolverPoint& point : asked) {
      if (points.size() == 400) return !values.empty();
      points.push_back(point.x);
      values.push_back(valley.at(point.x));
      if (!give_up || penalised(values.back()) <= point.bar) continue;
      values.back() = {1e6, {1.0}, point.bar};
      ++given_up;
    }
    return true;
  };
  SolverOptions options;
  options.algorithm = algorithm;
  options.constraints = ConstraintHandling::kPenalty;
  options.penalty = kPenalty;
  options.look_ahead = look_ahead;
  minimize(problem, options);
  return points;
}

TEST(Bar, GoesWithThePointsOfABatch) {
  for (const char* algorithm : {"CRS2", "ESCH"}) {
    for (const std::size_t look_ahead : {1U, 64U}) {
      std::size_t given_up = 0;
      const auto whole = minimised(algorithm, look_ahead, false, given_up);
      EXPECT_EQ(given_up, 0U);
      EXPECT_EQ(minimised(algorithm, look_ahead, true, given_up), whole) << algorithm;
      EXPECT_GT(given_up, 10U) << algorithm;
    }
  }
}

}  // namespace
}  // namespace armtune

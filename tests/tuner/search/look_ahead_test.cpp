#include "tuner/search/look_ahead.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace armtune {
namespace {

using Point = std::vector<double>;

/// What the caller of a search sees.
struct Seen {
  std::vector<Point> points;
  std::vector<std::size_t> batches;
  SolverOutcome outcome;
};

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

Seen search(const SolverOptions& options, std::size_t n, std::size_t budget) {
  Seen seen;
  SolverProblem problem;
  problem.start.assign(n, 0.3);
  problem.constraint_count = 1;
  problem.evaluate = [&](const std::vector<SolverPoint>& points, std::vector<SolverValue>& values) {
    seen.batches.push_back(points.size());
    for (const SolverPoint& point : points) {
      if (seen.points.size() == budget) return !values.empty();
      seen.points.push_back(point.x);
      values.push_back(bowl(point.x));
    }
    return true;
  };
  seen.outcome = minimize(problem, options);
  return seen;
}

/// The points an algorithm asks for one by one, known ones again included, with what it was told.
std::vector<std::pair<Point, double>> asked(const SolverOptions& options, std::size_t n, std::size_t most) {
  std::vector<std::pair<Point, double>> all;
  SolverProblem problem;
  problem.start.assign(n, 0.3);
  problem.constraint_count = 1;
  run_algorithm(problem, options, [&](const Point& x, bool, const Bar&, SolverAnswer& answer) {
    if (all.size() == most) return false;
    answer.value = bowl(x);
    all.emplace_back(x, answer.value.objective);
    return true;
  });
  return all;
}

class EveryLookAhead : public testing::TestWithParam<std::string> {
 protected:
  static constexpr std::size_t kBudget = 330;
  SolverOptions options(std::size_t look_ahead) const {
    SolverOptions options;
    options.algorithm = GetParam();
    options.look_ahead = look_ahead;
    return options;
  }
};

TEST_P(EveryLookAhead, AsksForTheSamePointsInTheSameOrderAsWithoutOne) {
  for (const ConstraintHandling handling : {ConstraintHandling::kAuto, ConstraintHandling::kPenalty}) {
    SolverOptions one = options(1);
    SolverOptions many = options(64);
    one.constraints = many.constraints = handling;
    const Seen alone = search(one, 5, kBudget);
    const Seen ahead = search(many, 5, kBudget);
    EXPECT_EQ(ahead.points, alone.points);
    EXPECT_EQ(ahead.outcome.reason, alone.outcome.reason);
    EXPECT_LE(ahead.batches.size(), alone.batches.size());
    EXPECT_LE(*std::max_element(ahead.batches.begin(), ahead.batches.end()), 64U);
  }
}

TEST_P(EveryLookAhead, TellsTheAlgorithmWhatItWouldHaveBeenToldOneByOne) {
  const auto bare = asked(options(1), 4, kBudget);
  std::vector<Point> fresh;  // of the bare algorithm's points, those asked for the first time
  for (const auto& [x, value] : bare) {
    EXPECT_EQ(value, bowl(x).objective);
    if (std::find(fresh.begin(), fresh.end(), x) == fresh.end()) fresh.push_back(x);
  }
  EXPECT_EQ(search(options(64), 4, fresh.size()).points, fresh);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const AlgorithmInfo& a : algorithms()) {
    if (!a.uses_differences) all.emplace_back(a.name);  // those have batches of their own
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Algorithms, EveryLookAhead, testing::ValuesIn(names()),
                         [](const auto& algorithm) { return algorithm.param; });

std::vector<std::size_t> batches(const std::string& algorithm, std::size_t n, std::size_t budget) {
  SolverOptions options;
  options.algorithm = algorithm;
  options.constraints = ConstraintHandling::kPenalty;
  return search(options, n, budget).batches;
}

TEST(LookAhead, EvaluatesGenerationsAtOnce) {
  for (const char* algorithm : {"ISRES", "ESCH", "CRS2"}) {
    const auto sizes = batches(algorithm, 5, 200);
    EXPECT_GE(*std::max_element(sizes.begin(), sizes.end()), 30U) << algorithm;
  }
}

TEST(LookAhead, EvaluatesTheFirstModelOfBobyqaAtOnce) {
  const std::size_t n = 7;
  EXPECT_EQ(batches("BOBYQA", n, 100).front(), 2 * n + 1);
}

TEST(LookAhead, KeepsToItsCap) {
  SolverOptions options;
  options.algorithm = "ISRES";
  options.look_ahead = 10;
  const Seen seen = search(options, 5, 100);
  EXPECT_EQ(*std::max_element(seen.batches.begin(), seen.batches.end()), 10U);
}

TEST(LookAhead, EndsWithAPopulationThatHasBecomeOnePoint) {
  SolverOptions options;
  options.algorithm = "CRS2";
  options.x_tolerance = 0.0;
  for (const std::size_t look_ahead : {1U, 64U}) {
    for (const double sign : {1.0, -1.0}) {  // best at the lower bound, at the upper one
      options.look_ahead = look_ahead;
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
      EXPECT_THAT(outcome.reason, testing::HasSubstr("asks for nothing new"));
    }
  }
}

TEST(LookAhead, APointThatIsNotAskedForAfterAllIsOnlyWasted) {
  // It is told of a search that was given other answers than the one it is to foresee.
  SolverProblem problem;
  problem.start = {0.3, 0.3};
  SolverOptions options;
  options.algorithm = "NELDERMEAD";
  LookAhead ahead(problem, options);
  LookAhead::Known known;
  const auto& told = *known.insert({{0.9, 0.9}, {1.0, {}}}).first;
  ahead.note(told);
  EXPECT_THAT(ahead.next({0.5, 0.5}, known), testing::ElementsAre(Point{0.5, 0.5}));
}

}  // namespace
}  // namespace armtune

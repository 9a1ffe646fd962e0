#include "tuner/solver/solver.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace solver_test {

using Point = std::vector<double>;

// Least squared distance to (0.9, 0.7, 0.2), where x + y <= 1: the optimum (0.6, 0.4, 0.2) lies on the
// constraint, inside the box, at 0.18.
constexpr double kOptimum = 0.18;

double distance_squared(const Point& x) {
  return std::pow(x[0] - 0.9, 2) + std::pow(x[1] - 0.7, 2) + std::pow(x[2] - 0.2, 2);
}
double excess(const Point& x) {
  return x[0] + x[1] - 1.0;
}

struct Searched {
  double best = HUGE_VAL;  ///< smallest objective of a feasible point
  SolverOutcome outcome;
  std::vector<Point> points;
  std::vector<std::size_t> batches;
};

Searched search(const SolverOptions& options, bool constrained, std::size_t budget) {
  Searched s;
  SolverProblem problem;
  problem.start = {0.1, 0.2, 0.9};
  problem.constraint_count = constrained ? 1 : 0;
  problem.evaluate = [&](const std::vector<SolverPoint>& points, std::vector<SolverValue>& values) {
    s.batches.push_back(points.size());
    for (const SolverPoint& point : points) {
      if (s.points.size() == budget) return false;
      const Point& x = point.x;
      s.points.push_back(x);
      values.push_back({distance_squared(x), {}});
      if (constrained) values.back().constraints.push_back(excess(x));
      if (!constrained || excess(x) <= 0.0) s.best = std::min(s.best, values.back().objective);
    }
    return true;
  };
  s.outcome = minimize(problem, options);
  return s;
}

bool is_global(const std::string& algorithm) {
  for (const char* name : {"CRS2", "ESCH", "ISRES", "DIRECT_L", "ORIG_DIRECT", "MLSL"}) {
    if (algorithm == name) return true;
  }
  return false;
}

class EverySolver : public testing::TestWithParam<std::string> {
 protected:
  SolverOptions options() const {
    SolverOptions options;
    options.algorithm = GetParam();
    return options;
  }
};

TEST_P(EverySolver, FindsAnOptimumOnTheConstraint) {
  // Local ones converge; global ones come near in a budget that a tuning run could afford.
  const Searched s = search(options(), true, 4000);
  RecordProperty("points", static_cast<int>(s.points.size()));
  RecordProperty("best", std::to_string(s.best));
  EXPECT_LT(s.best, kOptimum + (is_global(GetParam()) ? 0.02 : 0.005));
  EXPECT_GE(s.best, kOptimum - 1e-12) << "nothing feasible is better";
}

TEST_P(EverySolver, FindsAnOptimumInsideTheBoxWithoutConstraints) {
  const Searched s = search(options(), false, 4000);
  // A Nelder-Mead simplex that meets a bound can collapse onto it and stay there, at 1 instead of 0.9.
  const double tolerance = GetParam() == "NELDERMEAD" ? 0.011 : is_global(GetParam()) ? 5e-3 : 1e-4;
  EXPECT_LT(s.best, tolerance);
}

TEST_P(EverySolver, StaysInTheBox) {
  const Searched s = search(options(), true, 500);
  for (const Point& x : s.points) {
    ASSERT_EQ(x.size(), 3U);
    for (const double coordinate : x) {
      ASSERT_GE(coordinate, 0.0);
      ASSERT_LE(coordinate, 1.0);
    }
  }
}

TEST_P(EverySolver, EndsAtOnceWhenTold) {
  SolverProblem problem;
  problem.start = {0.5, 0.5, 0.5};
  problem.constraint_count = 1;
  int calls = 0;
  problem.evaluate = [&](const std::vector<SolverPoint>& points, std::vector<SolverValue>& values) {
    for (const SolverPoint& p : points) values.push_back({distance_squared(p.x), {excess(p.x)}});
    return ++calls < 3;
  };
  const SolverOutcome outcome = minimize(problem, options());
  EXPECT_TRUE(outcome.stopped);
  EXPECT_FALSE(outcome.converged);
  EXPECT_EQ(calls, 3) << "it is not asked again after it said no";
}

TEST_P(EverySolver, LetsAnExceptionOutWithItsMessage) {
  SolverProblem problem;
  problem.start = {0.5, 0.5, 0.5};
  problem.constraint_count = 1;
  int calls = 0;
  problem.evaluate = [&](const std::vector<SolverPoint>& points, std::vector<SolverValue>& values) {
    if (++calls == 3) throw InputError("the disk is full");
    for (const SolverPoint& p : points) values.push_back({distance_squared(p.x), {excess(p.x)}});
    return true;
  };
  EXPECT_EQ(test::refusal([&] { minimize(problem, options()); }), "the disk is full");
  EXPECT_EQ(calls, 3);
}

TEST_P(EverySolver, RepeatsItselfForTheSameSeed) {
  SolverOptions seeded = options();
  seeded.seed = 3;
  const Searched first = search(seeded, true, 300);
  EXPECT_EQ(search(seeded, true, 300).points, first.points);
  const bool draws = algorithm_from_name(GetParam()).draws_random_numbers;
  seeded.seed = 4;
  EXPECT_EQ(search(seeded, true, 300).points == first.points, !draws);
}

std::vector<std::string> algorithm_names() {
  std::vector<std::string> names;
  for (const AlgorithmInfo& a : algorithms()) names.emplace_back(a.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Algorithms, EverySolver, testing::ValuesIn(algorithm_names()),
                         [](const auto& algorithm) { return algorithm.param; });

TEST_P(EverySolver, SearchesManyParametersOrSaysThatItDoesNot) {
  SolverOptions options;
  options.algorithm = GetParam();
  SolverProblem problem;
  problem.start.assign(60, 0.5);
  std::size_t left = 400;
  problem.evaluate = [&left](const std::vector<SolverPoint>& points, std::vector<SolverValue>& values) {
    for (const SolverPoint& point : points) {
      if (left == 0) return false;
      --left;
      double sum = 0.0;
      for (const double x : point.x) sum += (x - 0.3) * (x - 0.3);
      values.push_back({sum, {}});
    }
    return true;
  };
  const std::size_t most = algorithm_from_name(GetParam()).most_parameters;
  if (most == 0) {
    minimize(problem, options);
    EXPECT_LT(left, 400U);
  } else {
    const InputError error = test::input_error([&] { minimize(problem, options); });
    EXPECT_THAT(error, test::refused_at({.value = GetParam(), .limit = "one for 60 parameters"}));
    EXPECT_THAT(error.what(), testing::HasSubstr(fmt::format("at most {} parameters", most)));
    problem.start.resize(most);
    minimize(problem, options);
    EXPECT_LT(left, 400U) << "as many as it takes";
  }
}

TEST(Solver, OffersTheAlgorithmsOfTheDocumentation) {
  EXPECT_THAT(algorithm_names(), testing::IsSupersetOf({"BOBYQA", "COBYLA", "SBPLX", "NELDERMEAD", "CRS2",
                                                        "ESCH", "ISRES", "DIRECT_L", "MLSL", "SLSQP"}));
}

TEST(Solver, AnExactPenaltyFindsTheConstrainedOptimumToo) {
  for (const char* algorithm : {"SBPLX", "NELDERMEAD"}) {
    SolverOptions options;
    options.algorithm = algorithm;
    options.constraints = ConstraintHandling::kPenalty;  // its weight is above the multiplier, 0.6
    EXPECT_LT(search(options, true, 4000).best, kOptimum + 0.01) << algorithm;
  }
}

TEST(Solver, AnUnknownAlgorithmIsRefusedWithTheNearest) {
  const InputError error = test::input_error([] { algorithm_from_name("BOBYQUA"); });
  EXPECT_THAT(error,
              test::refused_at({.value = "BOBYQUA",
                                .limit = fmt::format("one of: {}", fmt::join(algorithm_names(), ", "))}));
  EXPECT_EQ(test::suggested_by(error), "BOBYQA");
}

TEST(Solver, AnAlgorithmThatWasCutIsRefusedWithWhatToUseInstead) {
  for (const char* name : {"MMA", "CCSAQ"}) {
    EXPECT_THAT([name] { algorithm_from_name(name); }, test::refused_at({.value = name, .limit = "SLSQP"}))
        << "one name to take, not all";
  }
}

TEST(Solver, AStartThatIsNoNumberOrOutsideItsBoundsIsRefusedByItsPlace) {
  SolverProblem problem;
  problem.evaluate = [](const std::vector<SolverPoint>&, std::vector<SolverValue>&) {
    ADD_FAILURE() << "asked for a point";
    return false;
  };
  const auto refused = [&problem](double start, double lower, double upper) {
    problem.start = {0.5, start};
    problem.lower = {0.0, lower};
    problem.upper = {1.0, upper};
    SolverOptions options;
    options.algorithm = "COBYLA";
    return test::input_error([&] { minimize(problem, options); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using test::refused_at;
  EXPECT_THAT(refused(nan, 0.0, 1.0), refused_at({.key = "start/1", .value = "nan", .limit = "0 to 1"}));
  EXPECT_THAT(refused(1.5, 0.0, 1.0), refused_at({.key = "start/1", .value = "1.5", .limit = "0 to 1"}));
  EXPECT_THAT(refused(0.5, 1.0, 0.0), refused_at({.key = "start/1", .value = "0.5", .limit = "1 to 0"}));
  EXPECT_THAT(refused(0.5, nan, 1.0), refused_at({.key = "start/1", .value = "0.5", .limit = "nan to 1"}));
}

TEST(Solver, DoesNotOfferWhatNLoptDoesBadly) {
  // NEWUOA_BOUND, AGS, STOGO and PRAXIS, by NLopt's names with and without what it puts in front of them.
  for (const char* name :
       {"NEWUOA_BOUND", "LN_NEWUOA_BOUND", "NLOPT_LN_NEWUOA_BOUND", "AGS", "GN_AGS", "NLOPT_GN_AGS", "STOGO",
        "GD_STOGO", "NLOPT_GD_STOGO", "PRAXIS", "LN_PRAXIS", "NLOPT_LN_PRAXIS"}) {
    EXPECT_THAT(algorithm_names(), testing::Not(testing::Contains(name)));
    const std::string message = test::refusal([&] { algorithm_from_name(name); });
    EXPECT_THAT(message, testing::StartsWith(std::string("algorithm '") + name + "' is unknown"));
    EXPECT_EQ(test::refusal([&] { algorithm_for(name, 2); }), message);
    SolverProblem problem;
    problem.start = {0.5, 0.5};
    problem.evaluate = [](const std::vector<SolverPoint>&, std::vector<SolverValue>&) {
      ADD_FAILURE() << "asked for a point";
      return false;
    };
    SolverOptions options;
    options.algorithm = name;
    EXPECT_EQ(test::refusal([&] { minimize(problem, options); }), message);
  }
}

}  // namespace solver_test
}  // namespace armtune::internal

// Small minimax problems with known solutions. No simulation is involved.

#include "tuner/minimax/minimax_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace armtune::internal {
namespace minimax_search_test {

using Eigen::Index;
using Eigen::VectorXd;
using Function = std::function<double(const VectorXd&)>;

/// A problem whose rows are functions. Differences of functions that are nearly quadratic are their gradients
/// up to 1e-9.
class Problem {
 public:
  explicit Problem(double box) : box_(box) {}

  void add_term(double weight, std::vector<Function> rows) { terms_.emplace_back(weight, std::move(rows)); }
  void add_constraint(std::vector<Function> rows) { constraints_.push_back(std::move(rows)); }
  /// Only rows within this distance of the largest one are in the models.
  void keep_rows_within(double band) { band_ = band; }

  SolverValue value(const VectorXd& x) const {
    SolverValue v;
    for (const auto& [weight, rows] : terms_) v.objective += weight * largest(rows, x);
    for (const auto& rows : constraints_) v.constraints.push_back(largest(rows, x));
    return v;
  }

  MinimaxResult solve(const VectorXd& start, MinimaxOptions options = exact()) {
    points.clear();
    MinimaxProblem problem;
    problem.lower = VectorXd::Constant(start.size(), -box_);
    problem.upper = VectorXd::Constant(start.size(), box_);
    problem.model = [this](const VectorXd& x) { return std::optional(model(x)); };
    problem.evaluate = [this](const VectorXd& x) -> std::optional<SolverValue> {
      if (points.size() == most) return std::nullopt;
      points.push_back(x);
      return value(x);
    };
    return minimize_maxima(problem, start, value(start), options);
  }

  /// Lengths and tolerances for problems whose variables are about 1.
  static MinimaxOptions exact() {
    MinimaxOptions options;
    options.radius = 0.5;
    options.largest_radius = 4.0;
    options.smallest_radius = 1e-8;
    options.least_decrease = 1e-9;
    return options;
  }

  std::vector<VectorXd> points;  ///< that were evaluated
  std::size_t most = 1000;       ///< number of evaluations at which the search is ended

 private:
  static double largest(const std::vector<Function>& rows, const VectorXd& x) {
    double most = -HUGE_VAL;
    for (const Function& f : rows) most = std::max(most, f(x));
    return most;
  }

  Maximum rows_at(const std::vector<Function>& rows, const VectorXd& x) const {
    constexpr double kStep = 1e-6;
    const double top = largest(rows, x);
    Maximum found;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      LinearRow row{0, static_cast<double>(i), rows[i](x), VectorXd(x.size())};
      if (row.value < top - band_) continue;
      for (Index j = 0; j < x.size(); ++j) {
        const VectorXd h = kStep * VectorXd::Unit(x.size(), j);
        row.gradient[j] = (rows[i](x + h) - rows[i](x - h)) / (2.0 * kStep);
      }
      found.push_back(std::move(row));
    }
    return found;
  }

  MinimaxModel model(const VectorXd& x) const {
    MinimaxModel model;
    for (const auto& [weight, rows] : terms_) model.terms.push_back({weight, rows_at(rows, x)});
    for (const auto& rows : constraints_) model.constraints.push_back(rows_at(rows, x));
    return model;
  }

  double box_;
  double band_ = HUGE_VAL;
  std::vector<std::pair<double, std::vector<Function>>> terms_;
  std::vector<std::vector<Function>> constraints_;
};

VectorXd vector(std::vector<double> values) {
  return Eigen::Map<VectorXd>(values.data(), static_cast<Index>(values.size()));
}

/// The rows of max |f(t, x)| over points from `begin` to `end`.
std::vector<Function> absolute(const std::function<double(double, const VectorXd&)>& f, double begin,
                               double end, int points) {
  std::vector<Function> rows;
  for (int i = 0; i < points; ++i) {
    const double t = begin + (end - begin) * i / (points - 1);
    for (const double sign : {1.0, -1.0})
      rows.push_back([f, t, sign](const VectorXd& x) { return sign * f(t, x); });
  }
  return rows;
}

// Chebyshev: the best line for t^2 on [0, 1] is t - 1/8, wrong by 1/8 at 0, 1/2 and 1.
TEST(MinimaxSearch, FindsTheBestLineForAParabola) {
  Problem problem(10.0);
  problem.add_term(
      1.0, absolute([](double t, const VectorXd& x) { return t * t - x[0] - x[1] * t; }, 0.0, 1.0, 41));
  const MinimaxResult found = problem.solve(vector({3.0, -2.0}));
  EXPECT_NEAR(found.value.objective, 0.125, 1e-6);
  EXPECT_NEAR(found.x[0], -0.125, 1e-5);
  EXPECT_NEAR(found.x[1], 1.0, 1e-5);
  EXPECT_NE(found.ended, MinimaxEnd::kStopped);
}

// The peaks move while the search goes on: only those near the present ones are in its models.
TEST(MinimaxSearch, SamplesNearThePeaksAreEnough) {
  Problem problem(10.0);
  problem.add_term(
      1.0, absolute([](double t, const VectorXd& x) { return std::sin(t) - x[0] - x[1] * t - x[2] * t * t; },
                    0.0, 3.0, 61));
  const VectorXd start = vector({0.5, 0.5, 0.5});
  const double all = problem.solve(start).value.objective;
  problem.keep_rows_within(0.02);
  EXPECT_NEAR(problem.solve(start).value.objective, all, 1e-6);
  EXPECT_LT(all, 0.05);
}

// Charalambous and Bandler 1976, as CB2 of Luksan and Vlcek, Test problems for nonsmooth optimization, 2000.
TEST(MinimaxSearch, SolvesTheProblemOfCharalambousAndBandler) {
  Problem problem(10.0);
  problem.add_term(1.0, {[](const VectorXd& x) { return x[0] * x[0] + std::pow(x[1], 4); },
                         [](const VectorXd& x) { return std::pow(2 - x[0], 2) + std::pow(2 - x[1], 2); },
                         [](const VectorXd& x) { return 2 * std::exp(x[1] - x[0]); }});
  const MinimaxResult found = problem.solve(vector({1.0, -0.1}));
  EXPECT_NEAR(found.value.objective, 1.9522245, 1e-6);
  EXPECT_LE(problem.points.size(), 40U);
}

// DEM of the same collection: the optimum lies where two planes meet a paraboloid.
TEST(MinimaxSearch, SolvesTheProblemOfDemyanovAndMalozemov) {
  Problem problem(10.0);
  problem.add_term(1.0, {[](const VectorXd& x) { return 5 * x[0] + x[1]; },
                         [](const VectorXd& x) { return -5 * x[0] + x[1]; },
                         [](const VectorXd& x) { return x.squaredNorm() + 4 * x[1]; }});
  const MinimaxResult found = problem.solve(vector({1.0, 1.0}));
  EXPECT_NEAR(found.value.objective, -3.0, 1e-6);
  EXPECT_NEAR(found.x[1], -3.0, 1e-3);
}

/// The problem of Rosen and Suzuki (Hock and Schittkowski 43), whose solution is (0, 1, 2, -1) with -44.
Problem rosen_suzuki() {
  Problem problem(10.0);
  problem.add_term(1.0, {[](const VectorXd& x) {
                     return x[0] * x[0] + x[1] * x[1] + 2 * x[2] * x[2] + x[3] * x[3] - 5 * x[0] - 5 * x[1] -
                            21 * x[2] + 7 * x[3];
                   }});
  problem.add_constraint({[](const VectorXd& x) { return x.squaredNorm() + x[0] - x[1] + x[2] - x[3] - 8; }});
  problem.add_constraint(
      {[](const VectorXd& x) { return x.squaredNorm() + x[1] * x[1] + x[3] * x[3] - x[0] - x[3] - 10; }});
  problem.add_constraint({[](const VectorXd& x) {
    return 2 * x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + 2 * x[0] - x[1] - x[3] - 5;
  }});
  return problem;
}

TEST(MinimaxSearch, SolvesTheProblemOfRosenAndSuzukiFromInsideAndFromOutside) {
  for (const VectorXd& start : {vector({0, 0, 0, 0}), vector({3, 3, 3, 3})}) {
    Problem problem = rosen_suzuki();
    const MinimaxResult found = problem.solve(start);
    EXPECT_NEAR(found.value.objective, -44.0, 1e-5);
    for (const double c : found.value.constraints) EXPECT_LE(c, 1e-6);
    EXPECT_LE((found.x - vector({0, 1, 2, -1})).lpNorm<Eigen::Infinity>(), 1e-3);
    EXPECT_LE(problem.points.size(), 60U);
  }
}

TEST(MinimaxSearch, TheCheaperOfTwoMaximaGivesWay) {
  // |x - 1| + 3 |y + 1| with x + y >= 1: y stays at -1, x goes to 2.
  Problem problem(10.0);
  problem.add_term(1.0,
                   {[](const VectorXd& x) { return x[0] - 1; }, [](const VectorXd& x) { return 1 - x[0]; }});
  problem.add_term(3.0,
                   {[](const VectorXd& x) { return x[1] + 1; }, [](const VectorXd& x) { return -1 - x[1]; }});
  problem.add_constraint({[](const VectorXd& x) { return 1 - x[0] - x[1]; }});
  const MinimaxResult found = problem.solve(vector({0.0, 3.0}));
  EXPECT_NEAR(found.x[0], 2.0, 1e-5);
  EXPECT_NEAR(found.x[1], -1.0, 1e-5);
}

TEST(MinimaxSearch, AnInfeasibleStartReachesFeasibilityAlsoWithAPenaltyThatIsTooLow) {
  Problem problem(10.0);
  problem.add_term(1.0, {[](const VectorXd& x) { return 5.0 * (x[0] + x[1]); }});
  problem.add_constraint({[](const VectorXd& x) { return x.squaredNorm() - 1.0; }});
  MinimaxOptions options = Problem::exact();
  options.penalty = 0.01;
  const MinimaxResult found = problem.solve(vector({3.0, 2.0}), options);
  EXPECT_LE(found.value.constraints[0], 1e-6);
  EXPECT_NEAR(found.value.objective, -5.0 * std::sqrt(2.0), 1e-5);
}

TEST(MinimaxSearch, EndsBetweenConstraintsThatContradictEachOther) {
  Problem problem(10.0);
  problem.add_term(1.0, {[](const VectorXd& x) { return 0.1 * x[0]; }});
  problem.add_constraint({[](const VectorXd& x) { return 1.0 - x[0]; }});  // x >= 1
  problem.add_constraint({[](const VectorXd& x) { return x[0] + 1.0; }});  // x <= -1
  const MinimaxResult found = problem.solve(vector({6.0}));
  EXPECT_NE(found.ended, MinimaxEnd::kStopped);
  EXPECT_NEAR(std::max(0.0, found.value.constraints[0]) + std::max(0.0, found.value.constraints[1]), 2.0,
              1e-4);
}

TEST(MinimaxSearch, StaysInItsBoxAndEndsAtIt) {
  Problem problem(1.0);
  problem.add_term(1.0, {[](const VectorXd& x) { return std::pow(x[0] - 3, 2) + std::pow(x[1], 2); }});
  const MinimaxResult found = problem.solve(vector({-1.0, 0.9}));
  EXPECT_NEAR(found.x[0], 1.0, 1e-6);
  EXPECT_NEAR(found.x[1], 0.0, 1e-3);
  for (const VectorXd& x : problem.points) EXPECT_LE(x.lpNorm<Eigen::Infinity>(), 1.0);
}

TEST(MinimaxSearch, NoStepIsLongerThanTheTrustRegionAndEveryAcceptedOneIsBetter) {
  Problem problem = rosen_suzuki();
  MinimaxOptions options = Problem::exact();
  options.radius = 0.1;
  options.largest_radius = 0.1;
  problem.most = 10;
  VectorXd at = vector({0, 0, 0, 0});
  const MinimaxResult found = problem.solve(at, options);
  EXPECT_EQ(found.ended, MinimaxEnd::kStopped);
  EXPECT_EQ(problem.points.size(), 10U);
  EXPECT_LT(found.value.objective, problem.value(at).objective);
  for (const VectorXd& x : problem.points) {
    EXPECT_LE((x - at).lpNorm<Eigen::Infinity>(), 0.1 + 1e-12);
    if (problem.value(x).objective < problem.value(at).objective) at = x;
  }
}

TEST(MinimaxSearch, TakesTheSamePointsEveryTime) {
  Problem problem = rosen_suzuki();
  problem.solve(vector({3, 3, 3, 3}));
  const auto first = problem.points;
  problem.solve(vector({3, 3, 3, 3}));
  EXPECT_EQ(problem.points, first);
}

// A function that is not what its model says, as a derivative across an event can be.
TEST(MinimaxSearch, AWrongModelEndsTheSearchAndMovesNothing) {
  MinimaxProblem problem;
  problem.lower = VectorXd::Constant(1, -1.0);
  problem.upper = VectorXd::Constant(1, 1.0);
  problem.model = [](const VectorXd& x) {
    return std::optional(MinimaxModel{{{1.0, {{0, 0.0, x[0] * x[0], VectorXd::Constant(1, -1.0)}}}}, {}});
  };
  int evaluations = 0;
  problem.evaluate = [&evaluations](const VectorXd& x) {
    ++evaluations;
    return std::optional(SolverValue{x[0] * x[0], {}});
  };
  const MinimaxResult found = minimize_maxima(problem, VectorXd::Zero(1), {0.0, {}}, {});
  EXPECT_EQ(found.x[0], 0.0);
  EXPECT_EQ(found.accepted, 0);
  EXPECT_EQ(found.ended, MinimaxEnd::kRadius);
  EXPECT_LE(evaluations, 10);
}

}  // namespace minimax_search_test
}  // namespace armtune::internal

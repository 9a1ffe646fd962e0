#include "tuner/minimax/epigraph_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace armtune::internal {
namespace epigraph_program_test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

LinearRow row(double value, const VectorXd& gradient) {
  return {0, 0.0, value, gradient};
}
LinearRow row(double value, double slope) {
  return row(value, VectorXd::Constant(1, slope));
}

/// Solves a program of one variable with curvature b, in the box lower .. upper.
EpigraphStep solve(const MinimaxModel& model, double b, double lower = -10.0, double upper = 10.0,
                   double penalty = 100.0) {
  return solve_epigraph(model, MatrixXd::Constant(1, 1, b),
                        {VectorXd::Constant(1, lower), VectorXd::Constant(1, upper)}, penalty);
}

constexpr double kExact = 1e-6;  // tolerances of the interior point method, over curvatures of about 1

TEST(EpigraphProgram, ATermWithOneRowIsItsGradient) {
  const MinimaxModel model{{{2.0, {row(5.0, 0.3)}}, {1.0, {row(-1.0, -1.2)}}}, {}};
  const EpigraphStep step = solve(model, 4.0);
  EXPECT_NEAR(step.d[0], -(2.0 * 0.3 - 1.2) / 4.0, kExact);
  EXPECT_EQ(step.terms[0][0], 2.0);
  EXPECT_EQ(step.terms[1][0], 1.0);
}

TEST(EpigraphProgram, TheStepEndsWhereTwoRowsOfATermMeet) {
  // max(d, 2 - d) has its kink at d = 1. The curvature alone would go to 0.
  const double weight = 3.0, b = 0.5;
  const EpigraphStep step = solve({{{weight, {row(0.0, 1.0), row(2.0, -1.0)}}}, {}}, b);
  EXPECT_NEAR(step.d[0], 1.0, kExact);
  // b d + y_1 - y_2 = 0 and y_1 + y_2 = weight.
  EXPECT_NEAR(step.terms[0][0], (weight - b) / 2.0, kExact);
  EXPECT_NEAR(step.terms[0][1], (weight + b) / 2.0, kExact);
}

TEST(EpigraphProgram, AConstraintEndsTheStepAndItsMultiplierIsWhatItCosts) {
  // minimise -d + d^2 / 4 subject to d - 0.5 <= 0
  const EpigraphStep step = solve({{{1.0, {row(0.0, -1.0)}}}, {{row(-0.5, 1.0)}}}, 0.5);
  EXPECT_NEAR(step.d[0], 0.5, kExact);
  EXPECT_NEAR(step.constraints[0][0], 1.0 - 0.5 * 0.5, kExact);
}

TEST(EpigraphProgram, AConstraintThatIsSatisfiedWithoutItPullsAtNothing) {
  const EpigraphStep step = solve({{{1.0, {row(0.0, -1.0)}}}, {{row(-9.0, 1.0)}}}, 2.0);
  EXPECT_NEAR(step.d[0], 0.5, kExact);
  EXPECT_NEAR(step.constraints[0][0], 0.0, kExact);
}

TEST(EpigraphProgram, WhereAConstraintCannotBeSatisfiedItsPenaltyDecides) {
  // 1 + d <= 0, but |d| <= 0.3; the objective pulls to the other side with 1.
  const MinimaxModel model{{{1.0, {row(0.0, -1.0)}}}, {{row(1.0, 1.0)}}};
  const EpigraphStep dear = solve(model, 1e-3, -0.3, 0.3, 2.0);
  EXPECT_NEAR(dear.d[0], -0.3, kExact);
  EXPECT_NEAR(dear.constraints[0][0], 2.0, kExact) << "a violated row costs its penalty";
  EXPECT_NEAR(solve(model, 1e-3, -0.3, 0.3, 0.5).d[0], 0.3, kExact);
}

TEST(EpigraphProgram, BothBoundsOfTheBoxHold) {
  EXPECT_NEAR(solve({{{1.0, {row(0.0, -1.0)}}}, {}}, 0.1, -0.2, 0.4).d[0], 0.4, kExact);
  EXPECT_NEAR(solve({{{1.0, {row(0.0, 1.0)}}}, {}}, 0.1, -0.2, 0.4).d[0], -0.2, kExact);
  EXPECT_NEAR(solve({{{1.0, {row(0.0, 1.0)}}}, {}}, 0.1, 0.0, 0.4).d[0], 0.0, kExact) << "at its bound";
  EXPECT_EQ(solve({{{1.0, {row(0.0, 1.0)}}}, {}}, 0.1, 0.0, 0.0).d[0], 0.0) << "no room at all";
}

TEST(EpigraphProgram, AConstraintWithoutRowsIsLeftOut) {
  const EpigraphStep step = solve({{{1.0, {row(0.0, -1.0)}}}, {{}, {row(-0.5, 1.0)}}}, 0.5);
  EXPECT_EQ(step.constraints[0].size(), 0);
  EXPECT_NEAR(step.d[0], 0.5, kExact);
  EXPECT_NEAR(step.constraints[1][0], 0.75, kExact);
}

Maximum random_rows(Index n, int count) {
  Maximum rows;
  for (int i = 0; i < count; ++i) rows.push_back(row(VectorXd::Random(1)[0], VectorXd::Random(n)));
  return rows;
}

/// Expects that rows with a multiplier have the largest value.
void expect_complementary(const Maximum& rows, const VectorXd& multipliers, const VectorXd& d) {
  const LinearRow& largest = largest_row(rows, d);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (multipliers[static_cast<Index>(i)] < 1e-3) continue;
    EXPECT_NEAR(rows[i].value + rows[i].gradient.dot(d), largest.value + largest.gradient.dot(d), 1e-3);
  }
}

/// The conditions of Karush, Kuhn and Tucker, written out. Every sign and weight of the program is in them.
void expect_optimal(const MinimaxModel& model, const MatrixXd& B, const StepBounds& bounds, double penalty,
                    const EpigraphStep& step) {
  VectorXd gradient = B * step.d;
  for (std::size_t k = 0; k < model.terms.size(); ++k) {
    const WeightedMaximum& term = model.terms[k];
    EXPECT_NEAR(step.terms[k].sum(), term.weight, 1e-5);
    expect_complementary(term.rows, step.terms[k], step.d);
    for (std::size_t i = 0; i < term.rows.size(); ++i)
      gradient += step.terms[k][static_cast<Index>(i)] * term.rows[i].gradient;
  }
  for (std::size_t c = 0; c < model.constraints.size(); ++c) {
    const Maximum& rows = model.constraints[c];
    const double sum = step.constraints[c].sum();
    const LinearRow& largest = largest_row(rows, step.d);
    const double excess = largest.value + largest.gradient.dot(step.d);
    EXPECT_LE(sum, penalty + 1e-5);
    if (excess > 1e-4) {
      EXPECT_NEAR(sum, penalty, 1e-2);
    }
    if (excess < -1e-3) {
      EXPECT_NEAR(sum, 0.0, 1e-2);
    }
    if (sum > 1e-2) expect_complementary(rows, step.constraints[c], step.d);
    for (std::size_t i = 0; i < rows.size(); ++i)
      gradient += step.constraints[c][static_cast<Index>(i)] * rows[i].gradient;
  }
  for (Index j = 0; j < gradient.size(); ++j) {
    const bool at_lower = step.d[j] < bounds.lower[j] + 1e-4;
    const bool at_upper = step.d[j] > bounds.upper[j] - 1e-4;
    if (!at_lower) {
      EXPECT_LE(gradient[j], 1e-4) << "it would be better to go down";
    }
    if (!at_upper) {
      EXPECT_GE(gradient[j], -1e-4) << "it would be better to go up";
    }
  }
}

TEST(EpigraphProgram, SatisfiesTheOptimalityConditionsOfRandomPrograms) {
  int violated = 0, satisfied = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::srand(seed);
    const Index n = 2 + seed % 7;
    const MatrixXd root = MatrixXd::Random(n, n);
    const MatrixXd B = root * root.transpose() + 0.1 * MatrixXd::Identity(n, n);
    MinimaxModel model;
    for (const int rows : {1, 3, 12}) model.terms.push_back({0.5 + 0.2 * rows, random_rows(n, rows)});
    for (const int rows : {1, 6}) model.constraints.push_back(random_rows(n, rows));
    const StepBounds bounds = {-0.5 * VectorXd::Ones(n) + 0.2 * VectorXd::Random(n),
                               0.5 * VectorXd::Ones(n) + 0.2 * VectorXd::Random(n)};
    const double penalty = 3.0;
    const EpigraphStep step = solve_epigraph(model, B, bounds, penalty);
    SCOPED_TRACE(seed);
    expect_optimal(model, B, bounds, penalty, step);
    (violation_at(model, step.d) > 1e-4 ? violated : satisfied) += 1;
  }
  EXPECT_GT(violated, 3) << "or these programs say nothing about the penalty";
  EXPECT_GT(satisfied, 3);
}

TEST(EpigraphProgram, FortyGainsAndAThousandSamplesAreSolvedToo) {
  std::srand(9);
  const Index n = 40;
  MinimaxModel model;
  for (int k = 0; k < 16; ++k) model.terms.push_back({1.0 / 16, random_rows(n, 60)});
  for (int c = 0; c < 4; ++c) model.constraints.push_back(random_rows(n, 60));
  const StepBounds bounds = {VectorXd::Constant(n, -0.05), VectorXd::Constant(n, 0.05)};
  const MatrixXd B = 20.0 * MatrixXd::Identity(n, n);
  expect_optimal(model, B, bounds, 10.0, solve_epigraph(model, B, bounds, 10.0));
}

}  // namespace epigraph_program_test
}  // namespace armtune::internal

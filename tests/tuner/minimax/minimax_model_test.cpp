#include "tuner/minimax/minimax_model.hpp"

#include <gtest/gtest.h>

namespace armtune::internal {
namespace minimax_model_test {

using Eigen::VectorXd;

LinearRow row(int series, double place, double value, double slope) {
  return {series, place, value, VectorXd::Constant(1, slope)};
}

TEST(MinimaxModel, AnotherPeakTakesOverWhenTheFirstOneFalls) {
  const MinimaxModel model{{{2.0, {row(0, 1.0, 5.0, 3.0), row(0, 4.0, 4.0, -1.0)}}}, {}};
  const auto objective = [&model](double d) { return objective_at(model, VectorXd::Constant(1, d)); };
  EXPECT_DOUBLE_EQ(objective(0.0), 2.0 * 5.0);
  EXPECT_DOUBLE_EQ(objective(0.5), 2.0 * 6.5);
  EXPECT_DOUBLE_EQ(objective(-1.0), 2.0 * 5.0) << "the second peak, which rises";
  EXPECT_EQ(largest_row(model.terms[0].rows, VectorXd::Constant(1, -1.0)).place, 4.0);
}

TEST(MinimaxModel, ViolationsAddUpAndSatisfiedConstraintsCountNothing) {
  const MinimaxModel model{{},
                           {{row(0, 0.0, 0.5, 1.0)}, {}, {row(0, 0.0, -2.0, 1.0), row(1, 0.0, -1.0, 1.0)}}};
  const auto violation = [&model](double d) { return violation_at(model, VectorXd::Constant(1, d)); };
  EXPECT_DOUBLE_EQ(violation(0.0), 0.5);
  EXPECT_DOUBLE_EQ(violation(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(violation(3.0), 3.5 + 2.0);
}

TEST(MinimaxModel, ARowIsRecognisedByItsSeriesAndTheNearestTime) {
  const Maximum rows = {row(7, 1.0, 0.0, 0.0), row(7, 1.4, 0.0, 0.0), row(8, 1.2, 0.0, 0.0)};
  EXPECT_EQ(same_row(rows, row(7, 1.3, 0.0, 0.0)), &rows[1]);
  EXPECT_EQ(same_row(rows, row(8, 9.0, 0.0, 0.0)), &rows[2]);
  EXPECT_EQ(same_row(rows, row(9, 1.0, 0.0, 0.0)), nullptr);
}

}  // namespace minimax_model_test
}  // namespace armtune::internal

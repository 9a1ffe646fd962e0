#pragma once
// Models a minimax problem around one point by linear functions. The objective is a weighted sum of maxima.
// Each constraint is a maximum that must not be above zero.
//
// A metric of a rollout is often the extreme value of a time series. The samples near its peaks become the
// rows of a maximum. The model thereby knows that another peak takes over as the first one falls, which one
// gradient cannot tell. A metric without an extreme value, such as an RMS value, has one row.

#include <Eigen/Core>
#include <vector>

namespace armtune::internal {

/// A linear function of the step d from the model's point: value + gradient^T d.
struct LinearRow {
  int series = 0;      ///< number of the time series to which the row belongs, the same at every point
  double place = 0.0;  ///< place in the series; the time of a sample [s]
  double value = 0.0;
  Eigen::VectorXd gradient;  ///< (variables)
};

/// The largest value of its rows.
using Maximum = std::vector<LinearRow>;

struct WeightedMaximum {
  double weight = 1.0;  ///< not negative
  Maximum rows;         ///< at least one
};

struct MinimaxModel {
  std::vector<WeightedMaximum> terms;  ///< the objective is the sum of weight times maximum
  std::vector<Maximum> constraints;    ///< satisfied at zero or less; without rows: not modelled
};

/// Returns the row with the largest value at the step d. The maximum must have rows.
const LinearRow& largest_row(const Maximum& rows, const Eigen::VectorXd& d);

/// Returns the modelled objective at the step d.
double objective_at(const MinimaxModel& model, const Eigen::VectorXd& d);

/// Returns the sum of the modelled violations of all constraints at the step d.
double violation_at(const MinimaxModel& model, const Eigen::VectorXd& d);

/// Returns the row of the same series that is nearest to the place of `row`, or null if `rows` has none of
/// this series. It shows how the gradient of a sample has changed between two points.
const LinearRow* same_row(const Maximum& rows, const LinearRow& row);

}  // namespace armtune::internal

#include "tuner/minimax/minimax_model.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

double value_at(const LinearRow& row, const Eigen::VectorXd& d) {
  return row.value + row.gradient.dot(d);
}

}  // namespace

const LinearRow& largest_row(const Maximum& rows, const Eigen::VectorXd& d) {
  return *std::max_element(rows.begin(), rows.end(), [&d](const LinearRow& a, const LinearRow& b) {
    return value_at(a, d) < value_at(b, d);
  });
}

double objective_at(const MinimaxModel& model, const Eigen::VectorXd& d) {
  double sum = 0.0;
  for (const WeightedMaximum& term : model.terms) sum += term.weight * value_at(largest_row(term.rows, d), d);
  return sum;
}

double violation_at(const MinimaxModel& model, const Eigen::VectorXd& d) {
  double sum = 0.0;
  for (const Maximum& rows : model.constraints) {
    if (!rows.empty()) sum += std::max(0.0, value_at(largest_row(rows, d), d));
  }
  return sum;
}

const LinearRow* same_row(const Maximum& rows, const LinearRow& row) {
  const LinearRow* nearest = nullptr;
  for (const LinearRow& other : rows) {
    if (other.series != row.series) continue;
    if (nearest == nullptr || std::abs(other.place - row.place) < std::abs(nearest->place - row.place))
      nearest = &other;
  }
  return nearest;
}

}  // namespace armtune::internal

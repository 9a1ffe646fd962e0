#include "tuner/minimax/epigraph_program.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "tuner/quadratic/dense_cholesky.hpp"
#include "tuner/quadratic/interior_point.hpp"

namespace armtune::internal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kNoBound = std::numeric_limits<double>::infinity();

std::vector<int> consecutive(int begin, int end) {
  std::vector<int> all(static_cast<std::size_t>(end - begin));
  std::iota(all.begin(), all.end(), begin);
  return all;
}

/// The program while it is set up. Its variables are d, then the t of the terms with several rows, then the v
/// of the constraints with rows. Each t is relative to the value of its maximum at d = 0.
class Epigraph {
 public:
  Epigraph(const MinimaxModel& model, const Eigen::MatrixXd& B, const StepBounds& bounds, double penalty)
      : model_(model), n_(static_cast<int>(B.rows())) {
    const VectorXd here = VectorXd::Zero(n_);
    gradient_ = here;
    for (const WeightedMaximum& term : model.terms) {
      if (term.rows.size() > 1) {
        add(term.rows, term.weight, largest_row(term.rows, here).value);
      } else {
        gradient_ += term.weight * term.rows.front().gradient;
      }
    }
    const int first_violation = n_ + static_cast<int>(costs_.size());
    for (const Maximum& rows : model.constraints) {
      if (!rows.empty()) add(rows, penalty, 0.0);
    }
    variables_ = n_ + static_cast<int>(costs_.size());
    add_bounds(consecutive(first_violation, variables_), {}, {});
    add_bounds(consecutive(0, n_), bounds.lower, bounds.upper);
    curvature_.values(curvature_.add(consecutive(0, n_))) = B;
  }

  EpigraphStep solve(const StepBounds& bounds);

 private:
  /// Adds a variable with this cost, and a row value + gradient^T d - variable <= offset for each row.
  void add(const Maximum& rows, double cost, double offset);
  /// Adds lower <= variable <= upper for each of these variables; without bounds: variable >= 0.
  void add_bounds(const std::vector<int>& variables, const VectorXd& lower, const VectorXd& upper);
  RowBounds row_bounds() const;

  const MinimaxModel& model_;
  int n_;
  int variables_ = 0;
  BlockRows none_, rows_;
  CurvatureBlocks curvature_;
  VectorXd gradient_;          ///< by d
  std::vector<double> costs_;  ///< of the variables behind d
  std::vector<double> lower_, upper_;
};

void Epigraph::add(const Maximum& rows, double cost, double offset) {
  std::vector<int> columns = consecutive(0, n_);
  columns.push_back(n_ + static_cast<int>(costs_.size()));
  costs_.push_back(cost);
  double* value = rows_.values(rows_.block(rows_.add(static_cast<int>(rows.size()), columns)));
  for (const LinearRow& row : rows) {
    value = std::copy_n(row.gradient.data(), n_, value);
    *value++ = -1.0;
    lower_.push_back(-kNoBound);
    upper_.push_back(offset - row.value);
  }
}

void Epigraph::add_bounds(const std::vector<int>& variables, const VectorXd& lower, const VectorXd& upper) {
  if (variables.empty()) return;
  double* value = rows_.values(rows_.block(rows_.add_diagonal(variables)));
  std::fill_n(value, variables.size(), 1.0);
  const bool given = lower.size() > 0;
  for (Index i = 0; i < static_cast<Index>(variables.size()); ++i) {
    lower_.push_back(given ? lower[i] : 0.0);
    upper_.push_back(given ? upper[i] : kNoBound);
  }
}

RowBounds Epigraph::row_bounds() const {
  const auto rows = static_cast<Index>(lower_.size());
  return {Eigen::Map<const VectorXd>(lower_.data(), rows), Eigen::Map<const VectorXd>(upper_.data(), rows),
          VectorXd::Constant(rows, kNoBound)};
}

EpigraphStep Epigraph::solve(const StepBounds& bounds) {
  QuadraticProgram program;
  program.residuals = &none_;
  program.curvature = &curvature_;
  program.rows = &rows_;
  program.bounds = row_bounds();
  program.gradient.resize(variables_);
  program.gradient << gradient_, Eigen::Map<const VectorXd>(costs_.data(), static_cast<Index>(costs_.size()));
  program.damping = VectorXd::Zero(variables_);
  VectorXd x = VectorXd::Zero(variables_);
  VectorXd y = VectorXd::Zero(rows_.rows());
  InteriorPoint(variables_, none_, curvature_, rows_, make_dense_cholesky).solve(program, {}, x, y);

  EpigraphStep step;
  step.d = VectorXd::Zero(n_);
  if (x.allFinite()) step.d = x.head(n_).cwiseMax(bounds.lower).cwiseMin(bounds.upper);
  Index next = 0;
  const auto multipliers = [&](const Maximum& rows) -> VectorXd {
    const auto count = static_cast<Index>(rows.size());
    next += count;
    return y.segment(next - count, count).cwiseMax(0.0);
  };
  for (const WeightedMaximum& term : model_.terms) {
    step.terms.push_back(term.rows.size() > 1 ? multipliers(term.rows) : VectorXd::Constant(1, term.weight));
  }
  for (const Maximum& rows : model_.constraints) step.constraints.push_back(multipliers(rows));
  return step;
}

}  // namespace

EpigraphStep solve_epigraph(const MinimaxModel& model, const Eigen::MatrixXd& B, const StepBounds& bounds,
                            double penalty) {
  return Epigraph(model, B, bounds, penalty).solve(bounds);
}

}  // namespace armtune::internal

// The optima of plans against those of Ipopt, another method and another implementation, on the same
// programs.

#include <gtest/gtest.h>

#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cmath>

#include "tuner/planning/tasks/solve_plan.hpp"

namespace armtune {
namespace {

using Eigen::Map;
using Eigen::VectorXd;
using Ipopt::Index;
using Ipopt::Number;

constexpr Number kNone = 2e19;  // what Ipopt takes for no bound

/// A program of ours as Ipopt wants it.
class AsTnlp : public Ipopt::TNLP {
 public:
  AsTnlp(TrajectoryProgram& program, VectorXd start)
      : program_(program),
        z_(std::move(start)),
        hessian_(program.variables(), program.curvature, {&program.residuals}) {}

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian, IndexStyleEnum& style) override {
    n = program_.variables();
    m = program_.rows.rows();
    jacobian = 0;
    for (const RowBlock& block : program_.rows.blocks())
      jacobian += block.diagonal ? block.rows : block.rows * block.columns;
    hessian = static_cast<Index>(hessian_.matrix().rows.size());
    style = C_STYLE;
    return true;
  }
  bool get_bounds_info(Index n, Number* lower, Number* upper, Index m, Number* row_lower,
                       Number* row_upper) override {
    std::fill_n(lower, n, -kNone);
    std::fill_n(upper, n, kNone);
    for (Index i = 0; i < m; ++i) {
      row_lower[i] = std::max(-kNone, program_.bounds.lower[i]);
      row_upper[i] = std::min(kNone, program_.bounds.upper[i]);
    }
    return true;
  }
  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool, Number*) override {
    std::copy_n(z_.data(), n, x);
    return true;
  }
  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    program_.evaluate(Map<const VectorXd>(x, n), residual_, row_);
    value = program_.cost.dot(Map<const VectorXd>(x, n)) + 0.5 * residual_.squaredNorm();
    return true;
  }
  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    program_.linearize(Map<const VectorXd>(x, n), residual_, row_);
    VectorXd sum = program_.cost;
    program_.residuals.add_transposed(residual_, sum);
    std::copy_n(sum.data(), n, gradient);
    return true;
  }
  bool eval_g(Index n, const Number* x, bool, Index m, Number* rows) override {
    program_.evaluate(Map<const VectorXd>(x, n), residual_, row_);
    std::copy_n(row_.data(), m, rows);
    return true;
  }
  bool eval_jac_g(Index n, const Number* x, bool, Index, Index, Index* row, Index* column,
                  Number* values) override {
    if (values != nullptr) program_.linearize(Map<const VectorXd>(x, n), residual_, row_);
    for (const RowBlock& block : program_.rows.blocks()) {
      const int* columns = program_.rows.columns(block);
      const double* value = program_.rows.values(block);
      for (int i = 0; i < block.rows; ++i) {
        for (int j = 0; j < block.columns; ++j) {
          if (block.diagonal && i != j) continue;
          if (values == nullptr) {
            *row++ = block.first_row + i;
            *column++ = columns[j];
          } else {
            *values++ = block.diagonal ? value[i] : value[i * block.columns + j];
          }
        }
      }
    }
    return true;
  }
  bool eval_h(Index n, const Number* x, bool, Number factor, Index m, const Number* multipliers, bool, Index,
              Index* row, Index* column, Number* values) override {
    const SymmetricMatrix& H = hessian_.matrix();
    if (values == nullptr) {
      for (int c = 0; c < H.size; ++c) {
        for (int e = H.column_starts[static_cast<std::size_t>(c)];
             e < H.column_starts[static_cast<std::size_t>(c) + 1]; ++e) {
          *row++ = H.rows[static_cast<std::size_t>(e)];
          *column++ = c;
        }
      }
      return true;
    }
    const Map<const VectorXd> z(x, n);
    program_.linearize(z, residual_, row_);
    program_.curve(z, factor * residual_, Map<const VectorXd>(multipliers, m));
    const VectorXd weights = VectorXd::Constant(program_.residuals.rows(), factor);
    hessian_.assemble(VectorXd::Zero(n), {&weights});
    std::copy(H.values.begin(), H.values.end(), values);
    return true;
  }
  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number*, const Number*, Index,
                         const Number*, const Number*, Number objective, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    z_ = Map<const VectorXd>(x, n);
    objective_ = objective;
  }

  const VectorXd& solution() const { return z_; }
  double objective() const { return objective_; }

 private:
  TrajectoryProgram& program_;
  VectorXd z_;
  NormalMatrix hessian_;
  VectorXd residual_, row_;
  double objective_ = NAN;
};

/// Where Ipopt begins.
enum class From { kTheSameGuess, kOurOptimum };

/// On the same grid; Ipopt knows no coarser ones.
void expect_same_optimum(PlanTask task, From from = From::kTheSameGuess) {
  task.knots = 36;
  task.smoothness = 1e-6;
  const PlanProblem problem = plan_problem(task);
  const PlannedTrajectory ours = solve_plan(problem);
  ASSERT_EQ(ours.result.status, PlanStatus::kSolved) << task.name;

  TrajectoryProgram program(problem.task(problem.grid));
  Ipopt::SmartPtr<AsTnlp> tnlp =
      new AsTnlp(program, from == From::kOurOptimum ? ours.result.z : program.unknowns(problem.guess));
  Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt = IpoptApplicationFactory();
  ipopt->Options()->SetIntegerValue("print_level", 0);
  ipopt->Options()->SetStringValue("sb", "yes");
  ipopt->Options()->SetIntegerValue("max_iter", 3000);
  ipopt->Options()->SetNumericValue("tol", 1e-9);
  ASSERT_EQ(ipopt->Initialize(), Ipopt::Solve_Succeeded);
  ASSERT_EQ(ipopt->OptimizeTNLP(Ipopt::GetRawPtr(tnlp)), Ipopt::Solve_Succeeded) << task.name;
  EXPECT_NEAR(ours.objective(), tnlp->objective(), 1e-4 * std::abs(tnlp->objective())) << task.name;
  testing::Test::RecordProperty(task.name + "_ours", std::to_string(ours.objective()));
  testing::Test::RecordProperty(task.name + "_ipopt", std::to_string(tnlp->objective()));
  const Trajectory theirs = program.trajectory(tnlp->solution());
  EXPECT_NEAR(ours.trajectory.durations[0], theirs.durations[0], 1e-4 * theirs.durations[0]) << task.name;
}

class AgainstIpopt : public testing::TestWithParam<const char*> {};

TEST_P(AgainstIpopt, FindsTheSameOptimum) {
  expect_same_optimum(load_plan_task(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Tasks, AgainstIpopt,
                         testing::Values("ur10_move", "ur10_switch", "ur10_return", "ur10_fastest_circle",
                                         "ur10_least_gaze_error"));

// Past obstacles there are several optima: from the common guess Ipopt ends in one that waits for an obstacle
// to pass, at two and a half times our duration. Ours has to be one of its own.
TEST(IpoptUnderLimits, HasNothingBetterBesideAPlanPastObstacles) {
  expect_same_optimum(load_plan_task("ur10_clear_of_obstacles"), From::kOurOptimum);
}

TEST(IpoptUnderLimits, FindsTheSameLeastErrorOfALapThatIsTooFast) {
  PlanTask task = load_plan_task("ur10_lap");
  task.scenario.path.frequency *= 8.0;  // a turn in 1.25 s
  task.duration = 1.25;
  task.limits.velocity = 0.25;
  task.start.position = JointVector(6);
  task.start.position << 0.35, -1.57, -1.57, -1.57, 1.57, 0.0;  // at rest, off the path
  expect_same_optimum(task);
}

TEST(IpoptUnderLimits, FindsTheSameOptimumUnderAccelerationAndJerkLimits) {
  PlanTask task = load_plan_task("ur10_move");
  task.limits.acceleration = JointVector::Constant(6, 8.0);
  task.limits.jerk = JointVector::Constant(6, 100.0);
  expect_same_optimum(task);
}

}  // namespace
}  // namespace armtune

#include "ipopt_solver.hpp"

#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <algorithm>

namespace armtune::internal {
namespace {

using Eigen::Map;
using Eigen::VectorXd;
using Ipopt::Index;
using Ipopt::Number;

constexpr Number kNone = 2e19;      // what Ipopt takes for no bound
constexpr double kWarmMu = 1e-4;    // complementarity to start from where there are multipliers
constexpr double kWarmPush = 1e-6;  // and how far inside its bounds a value starts

/// A program of ours as Ipopt wants it.
class AsTnlp : public Ipopt::TNLP {
 public:
  AsTnlp(NonlinearProgram& program, const VectorXd& start, const VectorXd& multipliers)
      : program_(program),
        hessian_(program.variables(), program.curvature, {&program.residuals}),
        start_(start),
        start_y_(multipliers) {
    lower_ = VectorXd::Constant(program.variables(), -kNone);
    upper_ = VectorXd::Constant(program.variables(), kNone);
    for (const RowBlock& block : program.rows.blocks()) {
      if (!block.diagonal) {
        for (int i = 0; i < block.rows; ++i) rows_.push_back(block.first_row + i);
        entries_ += block.rows * block.columns;
        continue;
      }
      for (int i = 0; i < block.rows; ++i) bound(block, i);
    }
  }

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian, IndexStyleEnum& style) override {
    n = program_.variables();
    m = static_cast<Index>(rows_.size());
    jacobian = entries_;
    hessian = static_cast<Index>(hessian_.matrix().rows.size());
    style = C_STYLE;
    return true;
  }
  bool get_bounds_info(Index n, Number* lower, Number* upper, Index, Number* row_lower,
                       Number* row_upper) override {
    std::copy_n(lower_.data(), n, lower);
    std::copy_n(upper_.data(), n, upper);
    for (const int row : rows_) {
      *row_lower++ = std::max(-kNone, program_.bounds.lower[row]);
      *row_upper++ = std::min(kNone, program_.bounds.upper[row]);
    }
    return true;
  }
  bool get_starting_point(Index n, bool, Number* x, bool bounds_too, Number* z_lower, Number* z_upper, Index,
                          bool rows_too, Number* y) override {
    std::copy_n(start_.data(), n, x);
    if (rows_too) {
      for (const int row : rows_) *y++ = start_y_[row];
    }
    if (!bounds_too) return true;
    std::fill_n(z_lower, n, 0.0);
    std::fill_n(z_upper, n, 0.0);
    for (const Single& single : singles_) {
      const double pull = single.factor * start_y_[single.row];
      z_upper[single.column] += std::max(0.0, pull);
      z_lower[single.column] += std::max(0.0, -pull);
    }
    return true;
  }
  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    at(x, n, false);
    value = program_.cost.dot(z_) + 0.5 * residual_.squaredNorm();
    return true;
  }
  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    at(x, n, true);
    VectorXd sum = program_.cost;
    program_.residuals.add_transposed(residual_, sum);
    std::copy_n(sum.data(), n, gradient);
    return true;
  }
  bool eval_g(Index n, const Number* x, bool, Index, Number* values) override {
    at(x, n, false);
    for (const int row : rows_) *values++ = row_[row];
    return true;
  }
  bool eval_jac_g(Index n, const Number* x, bool, Index, Index, Index* row, Index* column,
                  Number* values) override {
    if (values != nullptr) at(x, n, true);
    Index first = 0;
    for (const RowBlock& block : program_.rows.blocks()) {
      if (block.diagonal) continue;
      const int count = block.rows * block.columns;
      if (values != nullptr) {
        values = std::copy_n(program_.rows.values(block), count, values);
        continue;
      }
      for (int i = 0; i < count; ++i) {
        *row++ = first + i / block.columns;
        *column++ = program_.rows.columns(block)[i % block.columns];
      }
      first += block.rows;
    }
    return true;
  }
  bool eval_h(Index n, const Number* x, bool, Number factor, Index, const Number* y, bool, Index, Index* row,
              Index* column, Number* values) override {
    const SymmetricMatrix& H = hessian_.matrix();
    if (values == nullptr) {
      for (int c = 0; c < H.size; ++c) {
        const auto end = static_cast<std::size_t>(H.column_starts[static_cast<std::size_t>(c) + 1]);
        for (auto e = static_cast<std::size_t>(H.column_starts[static_cast<std::size_t>(c)]); e < end; ++e) {
          *row++ = H.rows[e];
          *column++ = c;
        }
      }
      return true;
    }
    at(x, n, true);
    VectorXd all = VectorXd::Zero(program_.rows.rows());
    for (const int place : rows_) all[place] = *y++;
    program_.curve(z_, factor * residual_, all);
    const VectorXd weights = VectorXd::Constant(program_.residuals.rows(), factor);
    hessian_.assemble(VectorXd::Zero(n), {&weights});
    std::copy(H.values.begin(), H.values.end(), values);
    return true;
  }
  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number* z_lower,
                         const Number* z_upper, Index, const Number*, const Number* y, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    solution = Map<const VectorXd>(x, n);
    found_y = VectorXd::Zero(program_.rows.rows());
    for (const int row : rows_) found_y[row] = *y++;
    // Of several rows that bound the same unknown the first takes the multiplier.
    VectorXd pull = Map<const VectorXd>(z_upper, n) - Map<const VectorXd>(z_lower, n);
    for (const Single& single : singles_) {
      found_y[single.row] = pull[single.column] / single.factor;
      pull[single.column] = 0.0;
    }
  }

  VectorXd solution;
  VectorXd found_y;  ///< multipliers of the program's rows

 private:
  struct Single {
    int row, column;
    double factor;  ///< the row's value over the unknown's
  };

  /// Row i of a diagonal block as bounds of its unknown.
  void bound(const RowBlock& block, int i) {
    const Single single{block.first_row + i, program_.rows.columns(block)[i], program_.rows.values(block)[i]};
    singles_.push_back(single);
    double lower = program_.bounds.lower[single.row] / single.factor;
    double upper = program_.bounds.upper[single.row] / single.factor;
    if (single.factor < 0.0) std::swap(lower, upper);
    lower_[single.column] = std::max(lower_[single.column], lower);
    upper_[single.column] = std::min(upper_[single.column], upper);
  }
  /// Evaluates once for each point, however many of Ipopt's callbacks ask for it.
  void at(const Number* x, Index n, bool derivatives) {
    const Map<const VectorXd> z(x, n);
    const bool same = z_.size() == n && (z.array() == z_.array()).all();
    if (same && (derivatives_ || !derivatives)) return;
    z_ = z;
    derivatives_ = derivatives;
    derivatives ? program_.linearize(z_, residual_, row_) : program_.evaluate(z_, residual_, row_);
  }

  NonlinearProgram& program_;
  NormalMatrix hessian_;
  const VectorXd& start_;
  const VectorXd& start_y_;
  std::vector<int> rows_;        ///< those that stay rows, in Ipopt's order
  std::vector<Single> singles_;  ///< those that became bounds
  Index entries_ = 0;
  VectorXd lower_, upper_;
  VectorXd z_, residual_, row_;
  bool derivatives_ = false;
};

PlanStatus status_of(Ipopt::ApplicationReturnStatus returned) {
  if (returned == Ipopt::Solve_Succeeded || returned == Ipopt::Solved_To_Acceptable_Level)
    return PlanStatus::kSolved;
  if (returned == Ipopt::Infeasible_Problem_Detected) return PlanStatus::kInfeasible;
  return PlanStatus::kStalled;
}

std::string word_of(Ipopt::ApplicationReturnStatus returned) {
  switch (returned) {
    case Ipopt::Solve_Succeeded:
      return "solved";
    case Ipopt::Solved_To_Acceptable_Level:
      return "acceptable";
    case Ipopt::Infeasible_Problem_Detected:
      return "infeasible";
    case Ipopt::Maximum_Iterations_Exceeded:
      return "iterations";
    case Ipopt::Maximum_CpuTime_Exceeded:
      return "time";
    case Ipopt::Restoration_Failed:
      return "restoration";
    default:
      return "error " + std::to_string(static_cast<int>(returned));
  }
}

}  // namespace

IpoptRun solve_by_ipopt(NonlinearProgram& program, const VectorXd& z, const VectorXd& multipliers,
                        const IpoptOptions& options) {
  Ipopt::SmartPtr<AsTnlp> tnlp = new AsTnlp(program, z, multipliers);
  Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt = IpoptApplicationFactory();
  const auto& set = ipopt->Options();
  set->SetIntegerValue("print_level", 0);
  set->SetStringValue("sb", "yes");
  set->SetIntegerValue("max_iter", options.max_iterations);
  set->SetNumericValue("max_cpu_time", options.max_seconds);
  set->SetNumericValue("tol", options.stationarity);
  set->SetNumericValue("constr_viol_tol", options.violation);
  set->SetNumericValue("compl_inf_tol", options.complementarity);
  if (multipliers.size() > 0) {
    set->SetStringValue("warm_start_init_point", "yes");
    set->SetNumericValue("mu_init", kWarmMu);
    for (const char* push : {"warm_start_bound_push", "warm_start_bound_frac", "warm_start_slack_bound_push",
                             "warm_start_slack_bound_frac", "warm_start_mult_bound_push"})
      set->SetNumericValue(push, kWarmPush);
  }
  IpoptRun run;
  if (ipopt->Initialize() != Ipopt::Solve_Succeeded) return run;
  const Ipopt::ApplicationReturnStatus returned = ipopt->OptimizeTNLP(Ipopt::GetRawPtr(tnlp));
  run.status = status_of(returned);
  run.word = word_of(returned);
  if (Ipopt::IsValid(ipopt->Statistics())) run.iterations = ipopt->Statistics()->IterationCount();
  run.z = tnlp->solution.size() > 0 ? tnlp->solution : z;
  run.multipliers = tnlp->found_y.size() > 0 ? tnlp->found_y : VectorXd::Zero(program.rows.rows());
  return run;
}

}  // namespace armtune::internal

// The only file that includes NLopt. It uses NLopt's C interface, which returns codes where the C++ interface
// throws. One of these codes is ROUNDOFF_LIMITED, which BOBYQA can return at the optimum.

#include "tuner/solver/solver.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <exception>
#include <memory>

#include "armtune/error.hpp"
#include "core/common/nearest.hpp"

namespace armtune::internal {
namespace {

struct Offered {
  AlgorithmInfo info;
  nlopt_algorithm code;
};

const std::vector<Offered>& offered() {
  static const std::vector<Offered> list = {
      {{"COBYLA", true, true, false, false, "linear models"}, NLOPT_LN_COBYLA},
      {{"BOBYQA", true, false, false, false, "quadratic models"}, NLOPT_LN_BOBYQA},
      {{"SBPLX", true, false, false, false, "Nelder-Mead on subspaces"}, NLOPT_LN_SBPLX},
      {{"NELDERMEAD", true, false, false, false, "simplex"}, NLOPT_LN_NELDERMEAD},
      {{"SLSQP", true, true, true, false, "sequential quadratic programming"}, NLOPT_LD_SLSQP},
      {{"CRS2", false, false, false, true, "controlled random search"}, NLOPT_GN_CRS2_LM},
      {{"ESCH", false, false, false, true, "evolutionary"}, NLOPT_GN_ESCH},
      {{"ISRES", false, true, false, true, "evolutionary with stochastic ranking"}, NLOPT_GN_ISRES},
      {{"DIRECT_L", false, false, false, false, "dividing rectangles"}, NLOPT_GN_DIRECT_L},
      // With more than 32 parameters, NLopt 2.7 writes beyond the ends of its arrays.
      {{"ORIG_DIRECT", false, true, false, false, "dividing rectangles", 32}, NLOPT_GN_ORIG_DIRECT},
      {{"MLSL", false, false, false, false, "many BOBYQA searches from low-discrepancy points"},
       NLOPT_GN_MLSL_LDS},
  };
  return list;
}

/// An algorithm that was removed from armtune (docs/decisions.md), and the one to use instead.
struct Cut {
  const char* name;
  const char* instead;
};
constexpr Cut kCut[] = {{"MMA", "SLSQP"}, {"CCSAQ", "SLSQP"}};

const Offered& find(const std::string& name) {
  for (const Cut& cut : kCut) {
    if (name != cut.name) continue;
    throw InputError(
        fmt::format("algorithm '{}' is no longer part of armtune; use {} instead", name, cut.instead))
        .with_value(name, cut.instead);
  }
  std::vector<std::string> names;
  std::string all;
  for (const Offered& candidate : offered()) {
    if (name == candidate.info.name) return candidate;
    names.emplace_back(candidate.info.name);
    all += (all.empty() ? "" : ", ") + names.back();
  }
  throw InputError("algorithm '" + name + "' is unknown" + suggestion(name, names) +
                   "; the algorithms are: " + all)
      .with_value(name, "one of: " + all);
}

using Optimizer = std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)>;

Optimizer create(nlopt_algorithm code, std::size_t n) {
  return {nlopt_create(code, static_cast<unsigned>(n)), nlopt_destroy};
}

/// The oracle is called again for a point that NLopt requests more often than this in a row, more often than
/// its objective and constraints need. Otherwise CRS2 might never end: once its population has shrunk to one
/// point, it requests nothing else.
constexpr long kMostSameQuestions = 8;

/// The data that the callbacks share. NLopt requests objective and constraints of a point in separate calls.
/// Therefore the answer at the last point is kept.
struct Search {
  const SolverProblem* problem = nullptr;
  const Oracle* oracle = nullptr;
  double penalty = 0.0;  ///< per unit of violation; 0: NLopt handles the constraints
  nlopt_opt outer = nullptr;
  std::vector<double> x;
  SolverAnswer answer;
  bool known = false;
  bool derivatives = false;  ///< true if the derivatives are known, too
  bool stopped = false;
  std::exception_ptr error;

  long repeats = 0;  ///< further requests of the last point in a row

  void stop() {
    stopped = true;
    nlopt_force_stop(outer);
  }

  const SolverAnswer& at(unsigned n, const double* point, bool with_derivatives) {
    if (stopped) return answer;
    const bool same = known && std::equal(x.begin(), x.end(), point);
    repeats = same ? repeats + 1 : 0;
    if (same && repeats <= kMostSameQuestions && (derivatives || !with_derivatives)) return answer;
    x.assign(point, point + n);
    try {
      stopped = !(*oracle)(x, with_derivatives, answer);
      known = !stopped;
      derivatives = known && with_derivatives;
    } catch (...) {  // NLopt would lose the exception's message
      error = std::current_exception();
      stopped = true;
    }
    if (stopped) {
      stop();
      answer.value.constraints.resize(problem->constraint_count, 0.0);
      answer.gradient.assign(n, 0.0);
      answer.constraint_gradients.assign(n * problem->constraint_count, 0.0);
    }
    return answer;
  }
};

double objective(unsigned n, const double* x, double* gradient, void* data) {
  auto* search = static_cast<Search*>(data);
  const SolverAnswer& answer = search->at(n, x, gradient != nullptr);
  if (gradient != nullptr) std::copy_n(answer.gradient.begin(), n, gradient);
  double penalised = answer.value.objective;
  if (search->penalty > 0.0) {
    for (std::size_t c = 0; c < answer.value.constraints.size(); ++c) {
      const double g = answer.value.constraints[c];
      if (g <= 0.0) continue;
      penalised += search->penalty * g;
      for (std::size_t i = 0; gradient != nullptr && i < n; ++i) {
        gradient[i] += search->penalty * answer.constraint_gradients[c * n + i];
      }
    }
  }
  return penalised;
}

void constraints(unsigned m, double* g, unsigned n, const double* x, double* gradients, void* data) {
  const SolverAnswer& answer = static_cast<Search*>(data)->at(n, x, gradients != nullptr);
  std::copy_n(answer.value.constraints.begin(), m, g);
  if (gradients != nullptr) std::copy_n(answer.constraint_gradients.begin(), std::size_t{m} * n, gradients);
}

/// Largest first step, as a share of the range. BOBYQA needs a step that fits between the bounds either way.
constexpr double kMostOfWidth = 0.49;

void set_box(nlopt_opt opt, const SolverProblem& problem, const SolverOptions& options) {
  std::vector<double> step(problem.start.size());
  for (std::size_t i = 0; i < step.size(); ++i) {
    const double lower = problem.lower_bound(i);
    const double upper = problem.upper_bound(i);
    nlopt_set_lower_bound(opt, static_cast<int>(i), lower);
    nlopt_set_upper_bound(opt, static_cast<int>(i), upper);
    step[i] = std::min(options.initial_step, kMostOfWidth * (upper - lower));
  }
  nlopt_set_initial_step(opt, step.data());
  nlopt_set_xtol_abs1(opt, options.x_tolerance);
  nlopt_set_ftol_rel(opt, options.objective_tolerance);
}

std::string reason(nlopt_result code) {
  switch (code) {
    case NLOPT_SUCCESS:
    case NLOPT_FTOL_REACHED:
      return "converged: the objective no longer changes";
    case NLOPT_XTOL_REACHED:
      return "converged: the gains no longer change";
    case NLOPT_STOPVAL_REACHED:
      return "converged: stop value reached";
    case NLOPT_ROUNDOFF_LIMITED:
      return "converged as far as rounding allows";
    case NLOPT_FORCED_STOP:
      return "stopped";
    default:
      return std::string("NLopt ended with ") + nlopt_result_to_string(code);
  }
}

}  // namespace

const std::vector<AlgorithmInfo>& algorithms() {
  static const std::vector<AlgorithmInfo> list = [] {
    std::vector<AlgorithmInfo> infos;
    for (const Offered& candidate : offered()) infos.push_back(candidate.info);
    return infos;
  }();
  return list;
}

const AlgorithmInfo& algorithm_from_name(const std::string& name) {
  return find(name).info;
}

const AlgorithmInfo& algorithm_for(const std::string& name, std::size_t parameters) {
  const AlgorithmInfo& info = algorithm_from_name(name);
  if (info.most_parameters > 0 && parameters > info.most_parameters) {
    throw InputError(
        fmt::format(
            "algorithm '{}' takes at most {} parameters, but there are {}; use another algorithm, or tune "
            "fewer gains",
            name, info.most_parameters, parameters))
        .with_value(name, fmt::format("one for {} parameters", parameters));
  }
  return info;
}

/// Throws InputError if the start is outside its bounds. NLopt itself accepts a start that is NaN, and does
/// not report which bound is wrong.
void check_start(const SolverProblem& problem) {
  for (std::size_t i = 0; i < problem.start.size(); ++i) {
    const double lower = problem.lower_bound(i);
    const double upper = problem.upper_bound(i);
    if (lower <= problem.start[i] && problem.start[i] <= upper) continue;
    throw InputError(InputPlace{.key = fmt::format("start/{}", i)},
                     fmt::format("coordinate {} of the start point is {}; its bounds are {} .. {}", i + 1,
                                 problem.start[i], lower, upper))
        .with_value(fmt::to_string(problem.start[i]), fmt::format("{} to {}", lower, upper));
  }
}

SolverOutcome run_algorithm(const SolverProblem& problem, const SolverOptions& options,
                            const Oracle& oracle) {
  algorithm_for(options.algorithm, problem.start.size());
  check_start(problem);
  const Offered& chosen = find(options.algorithm);
  const std::size_t n = problem.start.size();
  nlopt_srand(options.seed);  // applies to this thread only

  Optimizer inner = create(chosen.code, n);
  set_box(inner.get(), problem, options);
  if (chosen.code == NLOPT_GN_MLSL_LDS) {
    const Optimizer local = create(NLOPT_LN_BOBYQA, n);
    set_box(local.get(), problem, options);
    nlopt_set_local_optimizer(inner.get(), local.get());
  }
  const bool constrained = problem.constraint_count > 0;
  const bool penalised = constrained && options.constraints == ConstraintHandling::kPenalty;
  const bool wrap =
      constrained && !penalised &&
      (options.constraints == ConstraintHandling::kLagrangian || !chosen.info.takes_constraints);
  Optimizer outer = wrap ? create(NLOPT_AUGLAG, n) : std::move(inner);
  if (wrap) {
    set_box(outer.get(), problem, options);
    nlopt_set_local_optimizer(outer.get(), inner.get());
  }

  Search search;
  search.problem = &problem;
  search.oracle = &oracle;
  search.outer = outer.get();
  if (penalised) search.penalty = options.penalty;
  nlopt_set_min_objective(outer.get(), objective, &search);
  if (constrained && !penalised) {
    const std::vector<double> tolerance(problem.constraint_count, 0.0);
    nlopt_add_inequality_mconstraint(outer.get(), static_cast<unsigned>(problem.constraint_count),
                                     constraints, &search, tolerance.data());
  }
  std::vector<double> x = problem.start;
  double smallest = 0.0;
  const nlopt_result code = nlopt_optimize(outer.get(), x.data(), &smallest);
  if (search.error) std::rethrow_exception(search.error);
  const bool converged = code > 0 || code == NLOPT_ROUNDOFF_LIMITED;
  return {converged && !search.stopped, search.stopped, reason(search.stopped ? NLOPT_FORCED_STOP : code)};
}

}  // namespace armtune::internal

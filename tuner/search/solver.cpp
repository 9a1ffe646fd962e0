// The only file that includes NLopt. Its C interface returns codes where the C++ one throws, among them
// ROUNDOFF_LIMITED, which BOBYQA can return at the optimum.

#include "tuner/search/solver.hpp"

#include <nlopt.h>

#include <algorithm>
#include <exception>
#include <memory>

#include "core/common/error.hpp"
#include "core/common/nearest.hpp"

namespace armtune {
namespace {

struct Offered {
  AlgorithmInfo info;
  nlopt_algorithm code;
};

const std::vector<Offered>& offered() {
  static const std::vector<Offered> list = {
      {{"COBYLA", true, "local, linear models, takes constraints"}, NLOPT_LN_COBYLA},
      {{"BOBYQA", false, "local, quadratic models"}, NLOPT_LN_BOBYQA},
      {{"SBPLX", false, "local, Nelder-Mead on subspaces"}, NLOPT_LN_SBPLX},
      {{"NELDERMEAD", false, "local, simplex"}, NLOPT_LN_NELDERMEAD},
      {{"CRS2", false, "global, controlled random search"}, NLOPT_GN_CRS2_LM},
      {{"ESCH", false, "global, evolutionary"}, NLOPT_GN_ESCH},
      {{"ISRES", true, "global, evolutionary, takes constraints"}, NLOPT_GN_ISRES},
      {{"DIRECT_L", false, "global, dividing rectangles"}, NLOPT_GN_DIRECT_L},
      {{"MLSL", false, "global, many BOBYQA searches from low-discrepancy starts"}, NLOPT_GN_MLSL_LDS},
  };
  return list;
}

const Offered& find(const std::string& name) {
  std::vector<std::string> names;
  std::string all;
  for (const Offered& candidate : offered()) {
    if (name == candidate.info.name) return candidate;
    names.emplace_back(candidate.info.name);
    all += (all.empty() ? "" : ", ") + names.back();
  }
  throw InputError("algorithm '" + name + "' is not offered" + suggestion(name, names) +
                   "; there are: " + all);
}

using Optimizer = std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)>;

Optimizer create(nlopt_algorithm code, std::size_t n) {
  return {nlopt_create(code, static_cast<unsigned>(n)), nlopt_destroy};
}

/// What the callbacks share. NLopt asks for objective and constraints of a point in separate calls: the last
/// point's values are kept.
struct Search {
  const SolverProblem* problem = nullptr;
  double penalty = 0.0;  ///< 0: constraints go to NLopt
  nlopt_opt outer = nullptr;
  std::vector<double> x;
  SolverValue value;
  bool known = false;
  bool stopped = false;
  std::exception_ptr error;

  const SolverValue& at(unsigned n, const double* point) {
    if (stopped || (known && std::equal(x.begin(), x.end(), point))) return value;
    x.assign(point, point + n);
    try {
      stopped = !problem->evaluate(x, value);
      known = !stopped;
    } catch (...) {  // an exception loses its message on its way through NLopt
      error = std::current_exception();
      stopped = true;
    }
    if (stopped) {
      nlopt_force_stop(outer);
      value.constraints.resize(problem->constraint_count, 0.0);
    }
    return value;
  }
};

double objective(unsigned n, const double* x, double*, void* data) {
  auto* search = static_cast<Search*>(data);
  const SolverValue& value = search->at(n, x);
  double penalised = value.objective;
  if (search->penalty > 0.0) {
    for (const double g : value.constraints) penalised += search->penalty * std::max(0.0, g);
  }
  return penalised;
}

void constraints(unsigned m, double* g, unsigned n, const double* x, double*, void* data) {
  const SolverValue& value = static_cast<Search*>(data)->at(n, x);
  std::copy_n(value.constraints.begin(), m, g);
}

void set_box(nlopt_opt opt, const SolverOptions& options) {
  nlopt_set_lower_bounds1(opt, 0.0);
  nlopt_set_upper_bounds1(opt, 1.0);
  nlopt_set_initial_step1(opt, options.initial_step);
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

SolverOutcome minimize(const SolverProblem& problem, const SolverOptions& options) {
  const Offered& chosen = find(options.algorithm);
  const std::size_t n = problem.start.size();
  nlopt_srand(options.seed);

  Optimizer inner = create(chosen.code, n);
  set_box(inner.get(), options);
  if (chosen.code == NLOPT_GN_MLSL_LDS) {
    const Optimizer local = create(NLOPT_LN_BOBYQA, n);
    set_box(local.get(), options);
    nlopt_set_local_optimizer(inner.get(), local.get());
  }
  const bool constrained = problem.constraint_count > 0;
  const bool penalised = constrained && options.constraints == ConstraintHandling::kPenalty;
  const bool wrap =
      constrained && !penalised &&
      (options.constraints == ConstraintHandling::kLagrangian || !chosen.info.takes_constraints);
  Optimizer outer = wrap ? create(NLOPT_AUGLAG, n) : std::move(inner);
  if (wrap) {
    set_box(outer.get(), options);
    nlopt_set_local_optimizer(outer.get(), inner.get());
  }

  Search search;
  search.problem = &problem;
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

}  // namespace armtune

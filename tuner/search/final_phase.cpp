#include "tuner/search/final_phase.hpp"

#include <algorithm>
#include <cmath>

#include "tuner/search/metric_model.hpp"

namespace armtune::internal {
namespace {

std::vector<double> to_coordinates(const Eigen::VectorXd& x) {
  return {x.begin(), x.end()};
}

Eigen::VectorXd vector_of(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

/// Returns objective and constraints, with the reserve of the model. The last constraint, which is satisfied
/// if every scenario completed, has no reserve.
SolverValue value_inside(const Evaluation& e) {
  SolverValue value{e.objective, e.relative};
  for (std::size_t c = 0; c + 1 < value.constraints.size(); ++c) value.constraints[c] += kInside;
  return value;
}

}  // namespace

long copies_per_iteration(const Study& study) {
  return static_cast<long>(study.space.free.size()) + 1;
}

long final_evaluations(const Study& study, long left) {
  if (!study.final_phase) return 0;
  const long share = std::lround(study.final_share * static_cast<double>(left));
  return share > copies_per_iteration(study) ? share : 0;
}

MinimaxResult run_final_phase(const Study& study, const Objective& objective, const Evaluation& best,
                              const WarmPoint& box, const FinalPhaseRollouts& rollouts) {
  std::vector<Evaluation> trials = {best};  // since the last model
  MinimaxProblem problem;
  problem.lower = vector_of(box.lower);
  problem.upper = vector_of(box.upper);
  problem.model = [&](const Eigen::VectorXd& x) -> std::optional<MinimaxModel> {
    const auto derivatives = rollouts.differentiate(to_coordinates(x));
    if (!derivatives) return std::nullopt;
    const auto at = std::find_if(trials.begin(), trials.end(),
                                 [&](const Evaluation& e) { return e.x == derivatives->x; });
    const Evaluation centre = *at;
    trials.clear();
    return metric_model(study, objective, centre, *derivatives, kInside);
  };
  problem.evaluate = [&](const Eigen::VectorXd& x) -> std::optional<SolverValue> {
    const Evaluation* e = rollouts.evaluate(to_coordinates(x));
    if (e == nullptr) return std::nullopt;
    trials.push_back(*e);
    return value_inside(*e);
  };
  MinimaxOptions options;
  options.penalty = study.solver.penalty;
  options.smallest_radius = study.solver.x_tolerance;
  return minimize_maxima(problem, vector_of(best.x), value_inside(best), options);
}

}  // namespace armtune::internal

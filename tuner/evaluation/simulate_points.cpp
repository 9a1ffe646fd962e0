#include "tuner/evaluation/simulate_points.hpp"

#include "sim/controller_files/parameter_file.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {

RolloutPlan plan_of(const Study& study, double deadline) {
  RolloutPlan plan = plan_of(simulated_scenarios(study), study.stepper, study.robust);
  plan.deadline = deadline;
  if (!study.source.empty()) plan.facts.emplace_back("study", hash_of_input(study.source));
  if (!study.gains.empty()) {
    for (const std::string& file : files_of_gains(study.gains))
      plan.facts.emplace_back("start gains", hash_of_input(file));
  }
  return plan;
}

std::optional<std::vector<Evaluation>> simulate_points(
    const Study& study, const std::vector<std::vector<double>>& points, CandidateRunner& workers,
    const std::atomic<bool>& stop, const Conditions& conditions,
    const std::function<void(std::size_t, const Evaluation&)>& finished) {
  std::vector<Gains> gains;
  std::vector<Evaluation> evaluations(points.size());
  gains.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    evaluations[i].x = points[i];
    evaluations[i].gains = study.space.gains_at(points[i]);
    evaluations[i].engine = conditions.engine;
    gains.push_back(evaluations[i].gains);
  }
  const bool whole = workers
                         .run(
                             gains, stop,
                             [&](std::size_t i, const std::vector<RolloutResult>& results) {
                               evaluations[i].results = results;
                               if (finished) finished(i, evaluations[i]);
                             },
                             conditions)
                         .has_value();
  if (!whole) return std::nullopt;
  return evaluations;
}

}  // namespace armtune::internal

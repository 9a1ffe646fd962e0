// Measures what ending rollouts early saves. The same study, seed and budget run in the native engine, first
// with no rollout ended early, then with hopeless rollouts ended as the study says. Simulated seconds are
// free of noise; processor seconds are printed beside them. The search sees other values at hopeless points
// and may take another path.
//
// Usage: benchmark_early_end [STUDY [ALGORITHM [EVALUATIONS [SEED]]]]

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "tuner/search/tune.hpp"

namespace armtune::internal {
namespace {

struct Outcome {
  long evaluations = 0;
  long hopeless = 0;       ///< evaluations with a rollout that ended as hopeless
  double simulated = 0.0;  ///< [s]
  double processor = 0.0;  ///< [s]
  Evaluation best;
};

bool any(const Evaluation& e, RolloutStatus status) {
  return std::any_of(e.results.begin(), e.results.end(),
                     [status](const RolloutResult& r) { return r.status == status; });
}

Outcome run(const Study& study) {
  constexpr int kWorkers = 1;  // one worker, because times are compared
  CandidateRunner workers(study.scenarios, study.stepper, kWorkers, study.robust);
  const std::atomic<bool> never{false};
  Outcome outcome;
  TuneCallbacks callbacks;
  callbacks.evaluated = [&outcome](const char*, const Evaluation& e) {
    if (any(e, RolloutStatus::kHopeless)) ++outcome.hopeless;
  };
  const std::clock_t ticks = std::clock();
  TuneResult result = tune(study, workers, never, callbacks);
  outcome.processor = static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC;
  outcome.simulated = workers.simulated();
  outcome.evaluations = result.evaluations;
  outcome.best = std::move(result.best);
  return outcome;
}

void print(const char* ends, const Outcome& o, const Outcome& whole) {
  fmt::print("{:<26}{:>12}{:>15}{:>15.0f}{:>7.1f} %{:>15.1f}{:>12.2f}{:>8.3f}  {:.6f}{}\n", ends,
             o.evaluations, o.hopeless, o.simulated, 100.0 * o.simulated / whole.simulated, o.processor,
             static_cast<double>(o.evaluations) / o.processor, whole.processor / o.processor,
             o.best.objective, o.best.feasible ? "" : " (infeasible)");
}

void compare(const std::vector<std::string>& args) {
  Study study = load_study(!args.empty() ? args[0] : "benchmarks/studies/ur10_gaze_nominal.yaml");
  if (args.size() > 1) study.solver.algorithm = algorithm_from_name(args[1]).name;
  study.global_algorithm.clear();
  if (args.size() > 2) study.max_evaluations = std::stol(args[2]);
  if (args.size() > 3) study.solver.seed = std::stoul(args[3]);
  study.engine = Engine::kNative;
  study.verify_share = 0.0;
  study.sweep.clear();
  fmt::print("{}: {}, seed {}\n{:<26}{:>12}{:>15}{:>24}{:>15}{:>20}  {}\n", study.name,
             study.solver.algorithm, study.solver.seed, "ended early", "evaluations", "beyond repair",
             "simulated [s]", "processor [s]", "evaluations/s", "best");
  Study none = study;
  for (Constraint& c : none.constraints) c.hopeless.kind = Hopeless::Kind::kNever;
  const Outcome whole = run(none);
  print("nothing", whole, whole);
  print("what is beyond repair", run(study), whole);
}

}  // namespace
}  // namespace armtune::internal

int main(int argc, char** argv) {
  try {
    armtune::internal::compare({argv + 1, argv + argc});
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 2;
  }
}

// What ending hopeless rollouts early saves: the same study, seed and budget with every constraint's
// `hopeless` as the study has it, and with `never`. Simulated seconds are free of noise; processor and wall
// seconds stand beside them. The search sees other values at hopeless points and may take another way: both
// bests are shown.
//
// Usage: benchmark_early_end [STUDY [ALGORITHM [EVALUATIONS [SEED]]]]

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "tuner/search/tune.hpp"

namespace armtune {
namespace {

struct Outcome {
  long evaluations = 0;
  long hopeless = 0;       ///< evaluations with a rollout that ended early
  double simulated = 0.0;  ///< [s]; of a study on many arms, of the arm that ended first
  double processor = 0.0;  ///< [s]
  double wall = 0.0;       ///< [s]
  Evaluation best;
};

Outcome run(const Study& study) {
  constexpr int kWorkers = 1;  // times are compared
  Workers workers(study.scenarios, study.stepper, kWorkers, study.robust);
  const std::atomic<bool> never{false};
  Outcome outcome;
  TuneCallbacks callbacks;
  callbacks.evaluated = [&outcome](const char*, const Evaluation& e) {
    bool ended = false;
    for (const RolloutResult& r : e.results) {
      outcome.simulated += r.end_time;
      ended = ended || r.status == RolloutStatus::kHopeless;
    }
    if (ended) ++outcome.hopeless;
  };
  const std::clock_t ticks = std::clock();
  const auto began = std::chrono::steady_clock::now();
  TuneResult result = tune(study, workers, never, callbacks);
  outcome.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  outcome.processor = static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC;
  outcome.evaluations = result.evaluations;
  outcome.best = std::move(result.best);
  return outcome;
}

void print(const char* ends, const Outcome& o) {
  fmt::print("{:<10}{:>12}{:>15}{:>15.1f}{:>15.1f}{:>10.1f}{:>17.3f}  {:.6f}{}\n", ends, o.evaluations,
             o.hopeless, o.simulated, o.processor, o.wall, static_cast<double>(o.evaluations) / o.processor,
             o.best.objective, o.best.feasible ? "" : " (infeasible)");
}

void compare(const std::vector<std::string>& args) {
  Study study = load_study(!args.empty() ? args[0] : "ur10_gaze");
  if (args.size() > 1) study.solver.algorithm = algorithm_from_name(args[1]).name;
  if (args.size() > 2) study.max_evaluations = std::stol(args[2]);
  if (args.size() > 3) study.solver.seed = std::stoul(args[3]);
  fmt::print("{}: {}, seed {}\n{:<10}{:>12}{:>15}{:>15}{:>15}{:>10}{:>17}  {}\n", study.name,
             study.solver.algorithm, study.solver.seed, "ends", "evaluations", "of them ended",
             "simulated [s]", "processor [s]", "wall [s]", "per processor s", "best");
  const Outcome early = run(study);
  print("by study", early);
  for (Constraint& c : study.constraints) c.hopeless.kind = Hopeless::Kind::kNever;
  const Outcome whole = run(study);
  print("never", whole);
  fmt::print("simulated {:.1f} %, processor {:.1f} % of whole rollouts; {} best\n",
             100.0 * early.simulated / whole.simulated, 100.0 * early.processor / whole.processor,
             early.best.x == whole.best.x ? "the same" : "another");
}

}  // namespace
}  // namespace armtune

int main(int argc, char** argv) {
  try {
    armtune::compare({argv + 1, argv + argc});
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 2;
  }
}

#include "tuner/cli/tune_help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/metrics/metric.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/solver/solver.hpp"
#include "tuner/study/hopeless.hpp"
#include "tuner/study/search_keys.hpp"

namespace armtune::internal::cli {

namespace {

/// When an algorithm is the one to take, from what is declared of it.
std::string use_of(const AlgorithmInfo& a) {
  std::string text = a.local ? "Use it to refine gains that are good already"
                             : "Use it to search the whole range of every gain, if the start gains may be "
                               "far from the best";
  if (a.uses_differences) text += ", with several workers (it evaluates finite differences in parallel)";
  if (a.takes_constraints) text += "; it handles constraints itself";
  if (a.draws_random_numbers) text += "; it uses random numbers, so try several seeds";
  if (a.most_parameters > 0) text += fmt::format("; for at most {} gains", a.most_parameters);
  return text + ".";
}

}  // namespace

std::string tune_help() {
  return fmt::format(
      "Bundled studies: {}\n\n"
      "These commands list what a study file can name:\n"
      "  armtune metrics      metrics for the objective and constraints\n"
      "  armtune algorithms   search algorithms, and the other keys of search\n"
      "  armtune controllers  controllers and their gains\n\n"
      "Example that tunes gains, then compares them with the published ones:\n"
      "  armtune tune ur10_gaze --max-evaluations 100 --out runs/tuned\n"
      "  armtune compare published runs/tuned --scenarios moving_target\n\n"
      "To tune a ROS controller (if all checks pass, its file with tuned gains is in the run folder):\n"
      "  armtune tune --robot arm.urdf --controllers ros2_controllers.yaml --trajectory moves.csv "
      "--out runs/mine\n",
      fmt::join(bundled_names("studies"), " "));
}

std::string algorithms_text() {
  std::string text = "Algorithms (study file, search/algorithm):\n";
  for (const AlgorithmInfo& a : algorithms()) {
    text += fmt::format("  {:<12} {}, {}\n  {:<12} {}\n", a.name, a.local ? "local" : "global", a.meaning, "",
                        use_of(a));
  }
  Study silent;
  default_search(silent);
  text += fmt::format(
      R"(
If a study names no algorithm, the search has two stages, with constraints as penalties. First {} searches
the whole range of every gain, with half of the evaluations and minutes that the start gains and the sweep
leave. Then {} refines the best gains found. scripts/compare-algorithms found this combination best. A warm
start skips the first stage, unless the study names it with the key global, as the study.yaml of a run does.
)",
      silent.global_algorithm, silent.solver.algorithm);
  text +=
      R"(
Other keys of search:
  constraints      penalty; lagrangian: an augmented Lagrangian around the algorithm; or auto: the algorithm
                   itself if it handles constraints, else lagrangian
  global           algorithm that searches first
  global_share     its share of the evaluations and minutes that the start gains and the sweep leave
  starts           number of local searches that run at once, from different start points
  differences      finite differences, for algorithms that use them: forward or central
  difference_step  their step, as a share of each gain's range
  engine           simbody, or native: armtune's own dynamics, several times faster and equal up to rounding
  verify_share     with native: share of the evaluations and of max_minutes that is kept for Simbody
  max_minutes      limit of the wall time from the start gains to the last evaluation, summed over all
                   sessions of a resumed run

After a native search, Simbody simulates the best gains again, and its figures are reported. Stability
margins are searched with the same engine, and Simbody confirms that the loop holds on one side of the edge
and fails on the other. Simbody also confirms the importance of the three most important gains.

Evaluations that are running when max_minutes is over are finished. Simbody's last steps are part of that
time. The time kept for them follows from what the start gains took; the best few points are simulated even
if it was too short. Final rollouts, report and analysis come after it (--no-analysis leaves the analysis
out).

If the best gains fail the endurance or yield check of the verdict, up to three points on the line back to
the start gains are simulated as well. The first that passes is the result.

Other keys of a study file: 'controller: NAME' tunes another controller than that of the gains file, with
start gains computed from the arm's inertia. 'warm_start' has the keys from, parameters, box and step, with
the meanings of --warm-start, --warm-parameters, --warm-box and --warm-step of armtune tune.
)";
  return text;
}

std::string metrics_text() {
  std::string text =
      "Metrics for the objective and the constraints of a study (+ more is better, - less is better, no "
      "sign: not for the objective):\n";
  for (const MetricField& field : metric_fields()) {
    const char* sign = field.better == Better::kMore ? "+" : field.better == Better::kLess ? "-" : " ";
    text += fmt::format("{} {:<34} {} [{}]\n", sign, field.name, field.meaning, field.unit);
  }
  text += R"(
The search abandons a rollout that breaks a constraint too far to recover. The key hopeless of a constraint
sets where that is: auto, never, or a value beyond the limit. The default auto means twice the limit of
joint_velocity/max_ratio, 0.1 rad (m) beyond the limit of joint_position/min_margin, and never for other
metrics.
A value can be given for an at_most limit of these metrics:
 )";
  for (const Metric m : all_metrics()) {
    if (can_be_hopeless(m, true)) text += fmt::format(" {}", name(m));
  }
  text += "\nand for an at_least limit of these:\n ";
  for (const Metric m : all_metrics()) {
    if (can_be_hopeless(m, false)) text += fmt::format(" {}", name(m));
  }
  return text + "\n";
}

}  // namespace armtune::internal::cli

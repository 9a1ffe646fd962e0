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
  std::string text = a.local ? "To refine gains that are good already"
                             : "To search the whole box, where the start gains may be far from the best";
  if (a.uses_differences) text += ", with several workers (it evaluates its differences in parallel)";
  if (a.takes_constraints) text += "; it takes constraints itself";
  if (a.draws_random_numbers) text += "; it draws random numbers, so try several seeds";
  if (a.most_parameters > 0) text += fmt::format("; at most {} parameters", a.most_parameters);
  return text + ".";
}

}  // namespace

std::string tune_help() {
  return fmt::format(
      "Bundled studies: {}\n\n"
      "What a study can name:\n"
      "  armtune metrics      objectives and constraints\n"
      "  armtune algorithms   searches, and the other keys of search\n"
      "  armtune controllers  controllers and their gains\n\n"
      "Example, and a look at the result:\n"
      "  armtune tune ur10_gaze --max-evaluations 100 --out runs/tuned\n"
      "  armtune compare published runs/tuned --scenarios moving_target\n\n"
      "To tune a ROS controller, and find its parameter file with tuned gains in the run's folder:\n"
      "  armtune tune --robot arm.urdf --controllers ros2_controllers.yaml --trajectory moves.csv --out runs/mine\n",
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
      R"(A study that names no algorithm searches with {} over the whole box first, for half of the evaluations and minutes
that start and sweep leave, then with {} from the best found, constraints as penalties: what
scripts/compare-algorithms found best. A warm start goes without the first, unless the study names it, as the
study.yaml of a run does.
)",
      silent.global_algorithm, silent.solver.algorithm);
  text +=
      R"(Around those that do not take constraints an augmented Lagrangian or a penalty is put (search/constraints).
Also in search: global and global_share (another algorithm first, for that part of evaluations and minutes), starts
(several local searches at once), differences (forward, central) and difference_step; engine: native searches
in armtune's own dynamics, several times faster than Simbody's and equal to it but for rounding, and leaves
verify_share of the evaluations and of max_minutes to Simbody, whose figures are reported; margins are
looked for in the same engine then, and confirmed by Simbody on either side of the edge; of the sensitivities
Simbody confirms the importance of the three gains that matter most.
Where the best found fails the verdict's endurance or yield, up to three points on the way back to the start are
simulated as well, and the first that passes is the result.
controller: NAME tunes another controller's gains than the file's, from a start that the arm's inertia gives.
max_minutes is wall time from start to last evaluation, of all sessions of a resumed run together: evaluations
under way when it is over are finished; Simbody's last steps are within it (time for the best few is kept from
what the start took, and they are simulated even if that was too little); fresh rollouts, report and analysis
(--no-analysis) come after it. warm_start: from, parameters, box, step, as the options of armtune tune.
)";
  return text;
}

std::string metrics_text() {
  std::string text =
      "Metrics (study file, objective and constraints; + more is better, - less is, no sign: not for the "
      "objective):\n";
  for (const MetricField& field : metric_fields()) {
    const char* sign = field.better == Better::kMore ? "+" : field.better == Better::kLess ? "-" : " ";
    text += fmt::format("{} {:<34} {} [{}]\n", sign, field.name, field.meaning, field.unit);
  }
  text += R"(
The search abandons a rollout that breaks a constraint too far to recover (study file, constraints/hopeless: auto,
never, or a value beyond the limit). By default that is twice the limit of joint_velocity/max_ratio and 0.1 rad
beyond that of joint_position/min_margin, never for others; a value can be given for at_most of
 )";
  for (const Metric m : all_metrics()) {
    if (can_be_hopeless(m, true)) text += fmt::format(" {}", name(m));
  }
  text += "\nand for at_least of\n ";
  for (const Metric m : all_metrics()) {
    if (can_be_hopeless(m, false)) text += fmt::format(" {}", name(m));
  }
  return text + "\n";
}

}  // namespace armtune::internal::cli

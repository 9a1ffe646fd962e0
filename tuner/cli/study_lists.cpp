#include "tuner/cli/study_lists.hpp"

#include <fmt/format.h>

#include "sim/metrics/metric.hpp"
#include "tuner/solver/solver.hpp"
#include "tuner/study/hopeless.hpp"
#include "tuner/study/search_keys.hpp"

namespace armtune::internal::cli {
namespace {

/// Returns advice on when to use an algorithm, from its declared properties.
std::string use_of(const AlgorithmInfo& a) {
  std::string text = a.local ? "Use it to refine gains that are good already"
                             : "Use it to search the whole range of every gain, if the start gains may be "
                               "far from the best";
  if (a.uses_differences)
    text += "; with several workers, the points of its finite differences are simulated in parallel";
  if (a.takes_constraints) text += "; it handles constraints itself";
  if (a.draws_random_numbers) text += "; it uses random numbers, so try several seeds";
  if (a.most_parameters > 0) text += fmt::format("; for at most {} gains", a.most_parameters);
  return text + ".";
}

}  // namespace

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
the whole range of every gain, with half of the evaluations and minutes that remain after the start gains
and the sweep (the study's grid around the start gains). Then {} refines the best gains found. This
combination was the best of those that scripts/compare-algorithms compared. With a warm start, the first
stage is skipped, unless the study has the key 'global'. The study.yaml in the folder of a run has this key
if the run had this first stage.
)",
      silent.global_algorithm, silent.solver.algorithm);
  text +=
      R"(
Other keys of the section 'search' of a study file:
  constraints      how constraints are handled. penalty: violations are added to the objective; lagrangian:
                   an augmented Lagrangian around the algorithm; auto: by the algorithm itself if it can,
                   otherwise lagrangian
  global           algorithm of the first stage, which searches the whole range of every gain
  global_share     share that the first stage gets of the evaluations and minutes that remain after the start
                   gains and the sweep
  starts           number of local searches that run at once, from different start points
  final_phase      minimax: a last phase models every metric separately, from derivatives that the native
                   engine computes, and refines the best gains
  final_share      share of the final phase in what is left to it and to the local searches
  differences      finite differences, for algorithms that use them: forward or central
  difference_step  step of the finite differences, as a share of each gain's range
  engine           simbody, or native for armtune's own dynamics, which are several times faster and equal up
                   to rounding
  verify_share     with 'engine: native': share of the evaluations and of max_minutes that is reserved for
                   simulations of the best gains in Simbody
  max_minutes      limit of the wall time from the start gains to the last evaluation, summed over all
                   sessions of a resumed run

After a search in the native engine, Simbody simulates the best gains again, and the values from Simbody are
reported. The native engine also searches for the stability margins. Simbody then confirms that the closed
loop is stable at each margin and fails just beyond it. Simbody also confirms the importance of the three
most important gains.

When max_minutes is over, evaluations that have started are still completed. max_minutes includes the last
evaluations in Simbody. The time reserved for them is computed from the time that the start gains took. If
it is too short, the best few points are simulated all the same. Final rollouts, report and analysis are not
part of max_minutes (--no-analysis skips the analysis).

If the best gains fail the endurance or yield check of the verdict, up to three gain sets between the best
gains and the start gains are simulated as well. The first that passes both checks, is feasible and is better
than the start gains is the result.

Other keys of a study file: 'controller: NAME' tunes another controller than the one in the gains file,
with start gains computed from the arm's inertia. 'warm_start' has the keys from, parameters, box and step,
with the meanings of --warm-start, --warm-parameters, --warm-box and --warm-step of armtune tune.
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
To save time, the search abandons a rollout as soon as a constraint is violated beyond a threshold. The key
'hopeless' of the constraint sets this threshold: 'auto', 'never', or a value beyond the limit. The default
'auto' means twice the limit of joint_velocity/max_ratio, 0.1 rad (or m) beyond the limit of
joint_position/min_margin, and 'never' for other metrics.
A value can be given if the constraint is an 'at_most' limit of one of these metrics:
 )";
  for (const Metric m : all_metrics()) {
    if (can_be_hopeless(m, true)) text += fmt::format(" {}", name(m));
  }
  text += "\nor an 'at_least' limit of one of these:\n ";
  for (const Metric m : all_metrics()) {
    if (can_be_hopeless(m, false)) text += fmt::format(" {}", name(m));
  }
  return text + "\n";
}

}  // namespace armtune::internal::cli

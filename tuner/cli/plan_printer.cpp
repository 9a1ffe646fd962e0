#include "tuner/cli/plan_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tuner/cli/commands.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/planning/output/plan_facts.hpp"
#include "tuner/planning/output/scenario_file.hpp"
#include "tuner/planning/output/worst_violation.hpp"
#include "tuner/report/plan_recording.hpp"

namespace armtune::internal::cli {
namespace {

constexpr std::size_t kShownLimits = 4;

/// Returns the value with its unit, and the limit if the two differ.
std::string value_words(const BindingLimit& limit) {
  const std::string unit = limit.unit.empty() ? "" : " " + limit.unit;
  const std::string value = fmt::format("{:.4g}", limit.value);
  const std::string bound = fmt::format("{:.4g}", limit.bound);
  return value == bound ? bound + unit : fmt::format("{}{} (limit {})", value, unit, bound);
}

std::string limits_text(const std::vector<BindingLimit>& limits, const char* title) {
  std::string text = fmt::format("{}{}\n", title, limits.empty() ? " none" : "");
  for (std::size_t i = 0; i < std::min(limits.size(), kShownLimits); ++i) {
    const BindingLimit& limit = limits[i];
    text += fmt::format("  {}: {}, at {:.3g} % of the knots, from {:.3f} to {:.3f} s\n",
                        report::limit_words(limit.limit, limit.part), value_words(limit), 100.0 * limit.share,
                        limit.first, limit.last);
  }
  if (limits.size() > kShownLimits) text += fmt::format("  and {} more\n", limits.size() - kShownLimits);
  return text;
}

void print_infeasible(const PlanTask& task, const PlannedTrajectory& planned) {
  if (planned.too_short)
    say(fmt::format("{}: infeasible: the limits allow no less than {:.6g} s, but the duration is {:.6g} s\n",
                    task.name, planned.trajectory.durations.front(), *task.duration));
  else
    say(fmt::format("{}: infeasible: {}\n", task.name, sentence(worst_violation(planned))));
  say(limits_text(binding_limits(planned),
                  planned.too_short ? "limits that prevent a shorter time:" : "limits reached or exceeded:"));
  say(fmt::format("Allow {}; if only little is missing, try --knots above {}.\nNo trajectory was written.\n",
                  planned.too_short ? "more time, or wider limits or tolerances"
                                    : "wider limits or tolerances, or another start state",
                  planned.trajectory.time.size() - 1));
}

std::string plan_text(const PlanTask& task, const PlanOutcome& outcome) {
  const PlanProblem& problem = *outcome.problem;
  const PlannedTrajectory& planned = outcome.planned;
  std::string text = fmt::format("{}: {}\n", task.name, plan_headline(task, problem, planned));
  for (const std::string& note : plan_notes(task, problem, planned)) text += note + '\n';
  text += limits_text(binding_limits(planned), "limits that prevent a better result:");
  if (const std::string between = between_words(outcome.uses); !between.empty()) text += between + '\n';
  const SequentialQuadraticProgress& last = planned.result.last;
  return text + fmt::format(
                    "solver: {} intervals between knots, {} interior-point steps on all grids, {:.2f} s; "
                    "largest constraint violation {:.1e} of the limit, KKT residual {:.1e}\n",
                    planned.trajectory.time.size() - 1, planned.interior_iterations, outcome.seconds,
                    last.violation, std::max(last.stationarity, last.complementarity));
}

void print_solved(const PlanOutcome& outcome, const PlanSettings& settings) {
  const std::string& folder = settings.folder;
  say(plan_text(settings.task, outcome));
  say(fmt::format("wrote {}: {}\nto simulate the plan: armtune simulate {}/{}\n", folder,
                  fmt::join(outcome.files, ", "), folder, planned_scenario_name(settings.task)));
}

}  // namespace

int print_plan(const PlanOutcome& outcome, const PlanSettings& settings) {
  const PlanTask& task = settings.task;
  const PlannedTrajectory& planned = outcome.planned;
  const SequentialQuadraticProgress& last = planned.result.last;
  switch (planned.result.status) {
    case PlanStatus::kInterrupted:
      say(fmt::format("{}: interrupted; no trajectory was written\n", task.name));
      return kInterrupted;
    case PlanStatus::kInfeasible:
      print_infeasible(task, planned);
      return kChecksFailed;
    case PlanStatus::kStalled:
      fmt::print(
          stderr,
          "{}: no solution found after {} steps (constraint violation {:.1e}: {}; KKT residual {:.1e}). The "
          "task may still have a solution: try another number of --knots, wider limits or tolerances, or "
          "another start state\n",
          task.name, last.iteration, last.violation, sentence(worst_violation(planned)),
          std::max(last.stationarity, last.complementarity));
      return kFailed;
    case PlanStatus::kSolved:
      break;
  }
  print_solved(outcome, settings);
  return kDone;
}

}  // namespace armtune::internal::cli

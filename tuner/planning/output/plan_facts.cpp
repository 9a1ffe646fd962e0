#include "tuner/planning/output/plan_facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "tuner/report/plan_recording.hpp"

namespace armtune::internal {
namespace {

/// Limits that the program enforces at the knots only.
struct AtKnotsOnly {
  const char* key;  ///< kind in run.json
  std::vector<LimitKind> kinds;
};

const std::vector<AtKnotsOnly>& at_knots_only() {
  static const std::vector<AtKnotsOnly> all = {
      {"torque", {LimitKind::kTorque}},
      {"tool_path", {LimitKind::kToolPath}},
      {"gaze", {LimitKind::kGaze}},
      {"distance", {LimitKind::kObstacle, LimitKind::kCellPart, LimitKind::kFloor, LimitKind::kLinks}}};
  return all;
}

constexpr double kTellingSmoothness = 1e-3;  // share of the duration above which smoothness is reported
constexpr double kSwitchRoom = 1e-6;         // s, tolerance in comparisons with the time of a switch
constexpr int kRows = 2000;                  // number of equal intervals at whose ends errors are measured

struct ToolErrors {
  double path = 0.0;  ///< largest distance from the path [m]
  double gaze = 0.0;  ///< rms of the gaze angle [rad]
};

ToolErrors errors_of(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory) {
  PlanSampler sampler(task, problem, trajectory);
  ToolErrors errors;
  const double start = trajectory.time.front();
  const double duration = trajectory.time.back() - start;
  for (int row = 0; row <= kRows; ++row) {
    const PlanSample& at = sampler.at(start + duration * row / kRows);
    errors.path = std::max(errors.path, (at.poses.p_0T - at.desired).norm());
    errors.gaze += at.gaze * at.gaze / (kRows + 1);
  }
  errors.gaze = std::sqrt(errors.gaze);
  return errors;
}

}  // namespace

std::string plan_headline(const PlanTask& task, const PlanProblem& problem,
                          const PlannedTrajectory& planned) {
  const double duration = planned.trajectory.durations.front();
  if (!task.duration) return fmt::format("{:.4g} s is the least time found within the limits", duration);
  if (task.kind == PlanKind::kTrack || task.least_error) {
    const ToolErrors errors = errors_of(task, problem, planned.trajectory);
    return fmt::format(
        "for a motion of {:.4g} s, the least error found within the limits: tool at most {:.3g} mm off its "
        "path, gaze {:.3g} mrad rms off its target",
        duration, 1e3 * errors.path, 1e3 * errors.gaze);
  }
  return fmt::format("the smoothest motion of {:.4g} s found within the limits", duration);
}

std::vector<std::string> plan_notes(const PlanTask& task, const PlanProblem& problem,
                                    const PlannedTrajectory& planned) {
  std::vector<std::string> notes;
  const Trajectory& trajectory = planned.trajectory;
  const double duration = trajectory.durations.front();
  const double smoothness = planned.objective() - duration;
  if (!task.duration && smoothness > kTellingSmoothness * duration)
    notes.push_back(
        fmt::format("the smoothness term adds as much to the objective as {:.2g} s of duration; a "
                    "`smoothness` below {:.2g} may give a shorter motion",
                    smoothness, task.smoothness));
  if (planned.weight != 1.0)
    notes.push_back(fmt::format(
        "the solver multiplied the objective by {:.0e} to give violated limits more weight; the KKT residual "
        "belongs to this scaled problem",
        planned.weight));
  if (trajectory.time.back() > problem.target_until + kSwitchRoom)
    notes.push_back(fmt::format(
        "the motion ends at {:.4g} s, after the next target switch at {:.4g} s; the plan ignores this switch "
        "and keeps the gaze target from before it",
        trajectory.time.back(), problem.target_until));
  return notes;
}

std::string between_words(const std::vector<LimitUse>& uses) {
  std::vector<std::string> parts;
  for (const AtKnotsOnly& limits : at_knots_only()) {
    const WorstUse worst = worst_between(uses, limits.kinds);
    if (worst.use == nullptr) continue;
    // For a distance, the share is limit / value.
    parts.push_back(is_distance(worst.use->kind)
                        ? fmt::format("{} at least {:.4f} times the required clearance", worst.use->limit,
                                      1.0 / worst.between)
                        : fmt::format("{} at most {:.4f} times its limit",
                                      report::limit_words(worst.use->limit, worst.use->part), worst.between));
  }
  return parts.empty() ? std::string() : fmt::format("between the knots: {}", fmt::join(parts, ", "));
}

PlanFacts plan_facts(const PlanTask& task, const PlanProblem& problem, const PlannedTrajectory& planned,
                     const std::vector<LimitUse>& uses) {
  const SequentialQuadraticProgress& last = planned.result.last;
  const Trajectory& trajectory = planned.trajectory;
  PlanFacts facts;
  facts.task = name(task.kind);
  facts.scenario = task.scenario.name;
  facts.headline = plan_headline(task, problem, planned);
  facts.duration = trajectory.durations.front();
  const auto& grid = planned.program->task().grid;
  for (std::size_t p = 0; p < grid.phases.size(); ++p)
    facts.phases.push_back({grid.phases[p].name, trajectory.durations[p]});
  facts.knots = static_cast<long>(trajectory.time.size());
  facts.violation = last.violation;
  facts.objective = planned.objective();
  facts.objective_weight = planned.weight;
  facts.stationarity = last.stationarity;
  facts.complementarity = last.complementarity;
  facts.interior_point_steps = planned.interior_iterations;
  for (const AtKnotsOnly& limits : at_knots_only()) {
    const WorstUse worst = worst_between(uses, limits.kinds);
    if (worst.use == nullptr) continue;
    facts.between_knots.push_back(
        {limits.key, worst.use->limit, worst.use->part, worst.between, worst.use->between_time});
  }
  return facts;
}

}  // namespace armtune::internal

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
  const char* key;  ///< part of a key of run.yaml
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

std::vector<std::pair<std::string, std::string>> plan_entries(const PlanTask& task,
                                                              const PlanProblem& problem,
                                                              const PlannedTrajectory& planned,
                                                              const std::vector<LimitUse>& uses) {
  const SequentialQuadraticProgress& last = planned.result.last;
  const Trajectory& trajectory = planned.trajectory;
  std::vector<std::string> phases;
  const auto& grid = planned.program->task().grid;
  phases.reserve(grid.phases.size());
  for (std::size_t p = 0; p < grid.phases.size(); ++p) {
    phases.push_back(fmt::format("{} {:.6g} s", grid.phases[p].name, trajectory.durations[p]));
  }
  std::vector<std::pair<std::string, std::string>> entries = {
      {"task", name(task.kind)},
      {"scenario", task.scenario.name},
      {"headline", plan_headline(task, problem, planned)},
      {"duration", fmt::format("{:.17g}", trajectory.durations.front())},
      {"phases", fmt::format("{}", fmt::join(phases, ", "))},
      {"knots", std::to_string(trajectory.time.size())},
      {"violation", fmt::format("{:.3g}", last.violation)},
      {"objective", fmt::format("{:.9g}", planned.objective())},
      {"objective_weight", fmt::format("{:.3g}", planned.weight)},
      {"kkt_stationarity", fmt::format("{:.3g}", last.stationarity)},
      {"kkt_complementarity", fmt::format("{:.3g}", last.complementarity)},
      {"interior_point_steps", std::to_string(planned.interior_iterations)}};
  for (const AtKnotsOnly& limits : at_knots_only()) {
    const WorstUse worst = worst_between(uses, limits.kinds);
    if (worst.use == nullptr) continue;
    entries.emplace_back(
        fmt::format("between_knots_{}", limits.key),
        fmt::format("{:.6g} times the limit, {} at {:.4f} s", worst.between,
                    report::limit_words(worst.use->limit, worst.use->part), worst.use->between_time));
  }
  return entries;
}

}  // namespace armtune::internal

#include "tuner/planning/session/rollout_measures.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tuner/run/hashed_table.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune::internal {
namespace {

struct PendingEvent {
  std::size_t scenario = 0;  ///< index
  Event event;
  YardstickOptions options;
};

/// Returns why plans cannot model the scenario, or an empty text if they can.
std::string why_left_out(const Scenario& scenario) {
  if (scenario.stimulus) return "plans do not model its stimulus (a step or sines)";
  if (scenario.orientation) return "it gives the tool's orientation; plans need gaze targets";
  if (!tracks_orientation(scenario.mask)) return "it tracks the position only; plans always include the gaze";
  return {};
}

/// Returns every event for which a motion is to be planned, scenario by scenario. recordings: receives the
/// path and the hash of each recording that was read.
std::vector<PendingEvent> pending_in(const std::string& folder, const std::vector<Scenario>& scenarios,
                                     const GainsOf& gains, YardstickOptions options,
                                     std::vector<std::pair<std::string, std::string>>& recordings,
                                     YardstickObserver& observer) {
  std::vector<PendingEvent> pending;
  for (std::size_t s = 0; s < scenarios.size(); ++s) {
    const Scenario& scenario = scenarios[s];
    if (const std::string why = why_left_out(scenario); !why.empty()) {
      observer.noted(scenario.name, "left out, because " + why);
      continue;
    }
    if (scenario.robot->chain.link_radius.size() > 0 && !scenario.obstacles.empty())
      observer.noted(scenario.name,
                     "plans keep the joint origins and the tool clear of obstacles, but not the links");
    const Gains set = gains(scenario);
    options.gaze_threshold = set.slerpAngularErrorThreshold;
    options.clearance = scenario.obstacles.empty() ? 0.0 : set.obstacleInfluenceRadius;
    const HashedTable rollout = read_hashed_table(run_file(folder, "rollout_" + scenario.name + ".csv"));
    recordings.emplace_back(rollout.table.name(), rollout.hash);
    const std::vector<Event> events = events_of(rollout.table, scenario, options.gaze_threshold);
    if (events.empty())
      observer.noted(scenario.name,
                     "has neither a target switch, nor a return to the path, nor a complete lap");
    for (const Event& event : events) pending.push_back({s, event, options});
  }
  return pending;
}

}  // namespace

RolloutMeasures measure_rollouts(const std::string& folder, const std::vector<Scenario>& scenarios,
                                 const GainsOf& gains, YardstickOptions options,
                                 const std::atomic<bool>& stop, YardstickObserver& observer) {
  RolloutMeasures result;
  const std::vector<PendingEvent> pending =
      pending_in(folder, scenarios, gains, options, result.recordings, observer);
  const Stopwatch watch;
  const auto seconds_left = [&](std::size_t done) {
    return done == 0
               ? NAN
               : watch.seconds() / static_cast<double>(done) * static_cast<double>(pending.size() - done);
  };
  std::vector<Measure>& measures = result.measures;
  measures.reserve(pending.size());
  for (const PendingEvent& next : pending) {
    if (stop) break;
    const Scenario& scenario = scenarios[next.scenario];
    const std::size_t done = measures.size();
    Measure found = measure(next.event, scenario, next.options, [&](const SequentialQuadraticProgress& at) {
      observer.progressed(
          {"yardstick", static_cast<long>(done), static_cast<long>(pending.size()), seconds_left(done),
           fmt::format("{} at {:.4g} s, step {}", scenario.name, next.event.time, at.iteration)});
      return !stop;
    });
    observer.part_is_over();
    if (found.status == MeasureStatus::kInterrupted) break;
    observer.measured(found, next.scenario);
    measures.push_back(std::move(found));
  }
  return result;
}

}  // namespace armtune::internal

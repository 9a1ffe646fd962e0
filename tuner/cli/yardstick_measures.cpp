#include "tuner/cli/yardstick_measures.hpp"

#include <fmt/format.h>

#include <chrono>

#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/planning/yardstick/yardstick_file.hpp"
#include "tuner/report/yardstick_rows.hpp"
#include "tuner/run/hashed_table.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::internal::cli {
namespace {

struct Pending {
  const Scenario* scenario = nullptr;
  Event event;
  YardstickOptions options;
};

/// Returns every event for which a motion is to be planned, scenario by scenario. recordings: receives the
/// path and the hash of each recording that was read.
std::vector<Pending> pending_in(const std::string& folder, const std::vector<Scenario>& scenarios,
                                const GainsOf& gains, YardstickOptions options,
                                std::vector<std::pair<std::string, std::string>>& recordings) {
  std::vector<Pending> pending;
  for (const Scenario& scenario : scenarios) {
    if (scenario.stimulus) {
      say(fmt::format("{}: left out, because plans do not model its stimulus (a step or sines)\n",
                      scenario.name));
      continue;
    }
    if (scenario.orientation) {
      say(fmt::format("{}: left out, because it gives the tool's orientation; plans need gaze targets\n",
                      scenario.name));
      continue;
    }
    if (!tracks_orientation(scenario.mask)) {
      say(fmt::format("{}: left out, because it tracks the position only; plans always include the gaze\n",
                      scenario.name));
      continue;
    }
    if (scenario.robot->chain.link_radius.size() > 0 && !scenario.obstacles.empty())
      say(fmt::format("{}: plans keep the joint origins and the tool clear of obstacles, but not the links\n",
                      scenario.name));
    const Gains set = gains(scenario);
    options.gaze_threshold = set.slerpAngularErrorThreshold;
    options.clearance = scenario.obstacles.empty() ? 0.0 : set.obstacleInfluenceRadius;
    const HashedTable rollout = read_hashed_table(run_file(folder, "rollout_" + scenario.name + ".csv"));
    recordings.emplace_back(rollout.table.name(), rollout.hash);
    const std::vector<Event> events = events_of(rollout.table, scenario, options.gaze_threshold);
    if (events.empty())
      say(fmt::format("{}: has no target switch, return to the path or complete lap\n", scenario.name));
    for (const Event& event : events) pending.push_back({&scenario, event, options});
  }
  return pending;
}

/// Prints a result in the words of the report.
void tell(const Measure& measure) {
  const auto rows = report::yardstick_of({CsvTable::parse(yardstick_csv({measure}), "yardstick.csv")});
  say(fmt::format("  {} at {:.4g} s: {}\n", rows.front().event, rows.front().time, rows.front().words));
}

}  // namespace

RolloutMeasures measure_rollouts(const std::string& folder, const std::vector<Scenario>& scenarios,
                                 const GainsOf& gains, YardstickOptions options) {
  RolloutMeasures result;
  const std::vector<Pending> pending = pending_in(folder, scenarios, gains, options, result.recordings);
  const auto began = std::chrono::steady_clock::now();
  const auto left = [&](std::size_t done) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - began;
    return done == 0 ? std::string()
                     : fmt::format(", {:.0f} s left", elapsed.count() / static_cast<double>(done) *
                                                          static_cast<double>(pending.size() - done));
  };
  std::vector<Measure>& measures = result.measures;
  measures.reserve(pending.size());
  ProgressLine line;
  const Scenario* told = nullptr;
  for (const Pending& next : pending) {
    if (stop_requested()) break;
    const std::size_t done = measures.size();
    Measure found =
        measure(next.event, *next.scenario, next.options, [&](const SequentialQuadraticProgress& at) {
          line.show(fmt::format("yardstick: {} of {} events{}; {} at {:.4g} s, step {}", done, pending.size(),
                                left(done), next.scenario->name, next.event.time, at.iteration));
          return !stop_requested();
        });
    line.clear();
    if (found.status == MeasureStatus::kInterrupted) break;
    if (told != next.scenario) say(fmt::format("{}:\n", next.scenario->name));
    told = next.scenario;
    tell(found);
    std::fflush(stdout);
    measures.push_back(std::move(found));
  }
  return result;
}

}  // namespace armtune::internal::cli

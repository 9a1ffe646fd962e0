#include "tuner/rollouts/simulate.hpp"

#include <fmt/format.h>

#include <mutex>
#include <optional>

#include "armtune/error.hpp"
#include "sim/rollout/motion_bag.hpp"
#include "tuner/ranks/patience.hpp"
#include "tuner/rollouts/recording_memory.hpp"
#include "tuner/workers/parallel.hpp"
#include "tuner/workers/rollout_plan.hpp"

namespace armtune::internal {
namespace {

/// Throws InputError if two scenarios have the same name.
void refuse_equal_names(const std::vector<Scenario>& scenarios) {
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (scenarios[i].name != scenarios[k].name) continue;
      throw InputError(
          InputPlace{scenarios[i].source},
          fmt::format("this scenario and {} are both named {}, so results would share a file; rename one",
                      scenarios[k].source, scenarios[i].name))
          .with_value(scenarios[i].name, "another name");
    }
  }
}

}  // namespace

std::vector<ScenarioResult> simulate(const std::vector<Scenario>& scenarios,
                                     const std::function<Gains(const Scenario&)>& gains_of,
                                     const SimulateOptions& options, const std::atomic<bool>& stop) {
  std::vector<ScenarioResult> results(scenarios.size());
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    results[i].scenario = scenarios[i].name;
    results[i].result.status = RolloutStatus::kInterrupted;
    results[i].result.reason = "interrupted before it began";
  }
  refuse_equal_names(scenarios);
  if (!options.folder.empty() || options.recorded) {
    require_recording_memory(scenarios, options.record_stride, options.workers,
                             options.recorded ? RecordingUse::kKept : RecordingUse::kWritten);
  }
  std::size_t done = 0;
  std::mutex progress_mutex;
  parallel_for(scenarios.size(), options.workers, stop, [&](std::size_t, std::size_t i) {
    Rollout rollout(scenarios[i], options.stepper, options.engine);
    std::optional<Recorder> recorder;
    if (!options.folder.empty() || options.recorded) recorder.emplace(scenarios[i], options.record_stride);
    const double deadline = deadline_of(options.deadline, scenarios[i]);
    LimitWatch limits(*scenarios[i].robot);
    ShakeWatch shakes(*scenarios[i].robot);
    RunningTime time;
    bool late = false;
    results[i].result = rollout.run(gains_of(scenarios[i]), [&](const Observation& o) {
      if (recorder) (*recorder)(o);
      limits.look(o);
      shakes.look(o);
      if (o.cell != nullptr) results[i].nearest = o.cell->least();
      late = time.look() > deadline;
      return !late && !stop;
    });
    results[i].broken = limits.broken();
    results[i].shake = shakes.first();
    if (late) {
      results[i].result.reason += fmt::format(
          " of {} s, because the rollout took longer than its deadline of {} s; give more time with "
          "--rollout-deadline, or find out what slows it down",
          scenarios[i].duration, deadline);
    }
    const RolloutStatus status = results[i].result.status;
    const bool whole = status == RolloutStatus::kCompleted || status == RolloutStatus::kNoSamples;
    if (!options.folder.empty()) {
      const std::string file = options.folder + "/rollout_" + scenarios[i].name;
      recorder->write_csv(file + ".csv", whole);
      if (options.mcap) {
        write_motion_bag(file + ".mcap",
                         {*scenarios[i].robot, column_names(recorder->columns()), recorder->rows(whole)},
                         &results[i].result.metrics);
      }
    }
    const std::lock_guard lock(progress_mutex);
    if (options.recorded) options.recorded(i, std::move(*recorder), whole);
    ++done;
    if (options.progress) options.progress(done);
  });
  return results;
}

}  // namespace armtune::internal

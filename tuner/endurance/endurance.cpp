#include "tuner/endurance/endurance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "tuner/endurance/error_windows.hpp"
#include "tuner/workers/parallel.hpp"

namespace armtune::internal {
namespace {

/// Shortest run for which the growth of the errors is computed [s]. The windows of shorter runs contain too
/// few laps to be comparable.
constexpr double kShortestCompared = 300.0;

/// Simulates one rollout in one engine until a limit is broken. Returns nothing if `stop` interrupted it.
std::optional<EnduranceResult> endure_in(Engine engine, const Scenario& scenario, const Gains& gains,
                                         const EnduranceOptions& options, const std::atomic<bool>& stop) {
  EnduranceResult result;
  result.scenario = scenario.name;
  result.engine = engine;
  LimitWatch limits(*scenario.robot, options.limit_share);
  ShakeWatch shakes(*scenario.robot);
  ErrorWindows errors(scenario.start_time, scenario.duration, scenario.control_period);
  LeastClearance touched;  // the first contact of the arm
  const RolloutResult rollout =
      Rollout(scenario, options.stepper, engine).run(gains, [&](const Observation& o) {
        limits.look(o);
        shakes.look(o);
        errors.look(o);
        if (o.cell != nullptr) {
          for (const LeastClearance& least : o.cell->least()) {
            if (least.distance < 0.0) touched = least;
          }
        }
        return !stop && !limits.any() && touched.pair == nullptr;
      });
  result.simulated = rollout.end_time;
  if (limits.any()) {
    result.broken = limits.broken().front();
  } else if (touched.pair != nullptr) {
    result.ended = scenario.clearance->name(*touched.pair) + " touch";
  } else if (rollout.status == RolloutStatus::kInterrupted) {
    return std::nullopt;
  } else if (rollout.status != RolloutStatus::kCompleted) {
    result.ended = rollout.reason;
  } else {
    result.ended = contact_text(rollout.metrics);
  }
  result.shake = shakes.first();
  if (result.shake && result.held()) result.ended = to_string(*result.shake);
  const bool compared = rollout.end_time - scenario.start_time >= kShortestCompared;
  result.rms_growth = compared ? errors.rms_growth() : NAN;
  result.peak_growth = compared ? errors.peak_growth() : NAN;
  return result;
}

}  // namespace

Scenario extended_to(const Scenario& scenario, double seconds) {
  Scenario extended = scenario;
  extended.duration = std::max(scenario.duration, seconds);
  return extended;
}

std::vector<std::string> how_extended(const Scenario& scenario) {
  std::vector<std::string> sentences;
  if (scenario.holds_end) {
    if (!scenario.holds_goal()) sentences.emplace_back("the joints stay where the planned motion ends");
  } else if (!scenario.has_task()) {
    sentences.emplace_back("after the planned motion, the arm performs the scenario's task");
  }
  if (scenario.path.spline && !scenario.path.spline->loops())
    sentences.emplace_back("the tool stays at its last waypoint");
  if (scenario.orientation && scenario.orientation->turn && !scenario.orientation->turn->loops())
    sentences.emplace_back("the orientation stays at its last waypoint");
  if (scenario.stimulus) {
    sentences.emplace_back(std::holds_alternative<Step>(scenario.stimulus->shape)
                               ? "the step stimulus keeps its height"
                               : "the sine stimulus continues");
  }
  if (!scenario.schedule.empty()) sentences.emplace_back("the last target of the schedule stays active");
  return sentences;
}

std::vector<EnduranceResult> endure(const std::vector<Scenario>& scenarios,
                                    const std::function<Gains(const Scenario&)>& gains_of,
                                    const EnduranceOptions& options, const std::atomic<bool>& stop) {
  std::vector<std::optional<EnduranceResult>> found(scenarios.size());
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(scenarios.size(), options.workers, stop, [&](std::size_t, std::size_t i) {
    const Scenario scenario = extended_to(scenarios[i], 60.0 * options.minutes);
    const Gains gains = gains_of(scenario);
    const bool native = options.stepper != Stepper::kReference;
    auto result = endure_in(native ? Engine::kNative : Engine::kSimbody, scenario, gains, options, stop);
    if (native && options.confirmed && result && !result->held())
      result = endure_in(Engine::kSimbody, scenario, gains, options, stop);
    const std::lock_guard lock(mutex);
    found[i] = std::move(result);
    if (options.progress) options.progress(++done, scenarios.size());
  });
  std::vector<EnduranceResult> results;
  for (auto& result : found) {
    if (result) results.push_back(std::move(*result));
  }
  return results;
}

}  // namespace armtune::internal

#include "tuner/report/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "core/control/state_machine.hpp"
#include "tuner/report/run_builder.hpp"

namespace armtune::internal::report {
namespace {

constexpr double kBytesPerValue = 8.0 / 3.0;  // two bytes in base64
constexpr double kOverhead = 120.0;           // bytes per series: name, group, unit, limits
constexpr double kLeastBuckets = 50.0;
constexpr double kLeastSamples = 100.0;
constexpr std::size_t kMostChanges = 2000;

std::string joint_column(const ArmJoint& joint, const char* what) {
  return "joint/" + joint.name + "/" + what;
}

/// Returns |commanded torque| / limit. Older files have no such column; then uses the torque after
/// saturation.
std::vector<double> torque_ratio(const NumberTable& rollout, const ArmJoint& joint) {
  if (const auto ratio = rollout.find(joint_column(joint, "torque_ratio"))) return rollout.numbers(*ratio);
  std::vector<double> values = rollout.numbers(rollout.column(joint_column(joint, "torque")));
  for (double& value : values) value = std::abs(value) / joint.effort_limit;
  return values;
}

void add_joint_columns(const NumberTable& rollout, const Arm& arm, RunBuilder& builder) {
  for (const ArmJoint& joint : arm.joints) {
    const std::string ratio = joint_column(joint, "velocity_ratio");
    builder.add(ratio, "velocity_ratio", "1", rollout.numbers(rollout.column(ratio)));
    builder.add(joint_column(joint, "torque_ratio"), "torque_ratio", "1", torque_ratio(rollout, joint));
    // Only scenarios with a plan have this column.
    const std::string error = joint_column(joint, "error");
    if (const auto c = rollout.find(error))
      builder.add(error, "joint_error", joint.prismatic ? "m" : "rad", rollout.numbers(*c));
  }
}

/// Returns the controller's state in a row. Throws InputError naming file and line.
int state_in(const NumberTable& rollout, std::size_t row, std::size_t column) {
  const double state = rollout.number(row, column);
  const bool known =
      state >= 0.0 && state <= static_cast<double>(ControlState::kFollowPlan) && state == std::floor(state);
  if (!known)
    throw InputError(
        at_line(rollout.name(), row + 2, "state"),
        fmt::format("{} in the column 'state' is not a state of the controller", shown_cell(state)));
  return static_cast<int>(state);
}

void add_states(const NumberTable& rollout, const std::vector<double>& time, Run& run) {
  const std::size_t state_column = rollout.column("state");
  const std::size_t slerp_column = rollout.column("slerping");
  int state = -1;
  bool slerping = false;
  for (std::size_t r = 0; r < time.size(); ++r) {
    const int now = state_in(rollout, r, state_column);
    if (now != state) run.states.push_back({time[r], now});
    state = now;
    const bool turns = rollout.number(r, slerp_column) == 1.0;
    if (turns && !slerping) run.slerps.emplace_back(time[r], time[r]);
    if (slerping) run.slerps.back().second = time[r];
    slerping = turns;
  }
}

/// Returns the changes of state without those to states that last less than `shortest` [s].
std::vector<StateChange> longer_than(double shortest, const std::vector<StateChange>& states, double end) {
  std::vector<StateChange> kept;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const double until = i + 1 < states.size() ? states[i + 1].time : end;
    if (i > 0 && until - states[i].time < shortest) continue;
    if (kept.empty() || kept.back().state != states[i].state) kept.push_back(states[i]);
  }
  return kept;
}

/// Leaves out short states and slerps, so that a run with very many changes does not fill the page.
void thin_changes(Run& run) {
  double shortest = 0.0;
  const std::vector<StateChange> states = run.states;
  const std::vector<std::pair<double, double>> slerps = run.slerps;
  while (run.states.size() > kMostChanges || run.slerps.size() > kMostChanges) {
    shortest = std::max(2.0 * shortest, 1e-5 * run.end);
    run.states = longer_than(shortest, states, run.end);
    run.slerps = slerps;
    std::erase_if(run.slerps, [shortest](const auto& s) { return s.second - s.first < shortest; });
    if (shortest > run.end) break;  // the rest has no duration
  }
  if (run.slerps.size() > kMostChanges) run.slerps.clear();
  run.shortest_state = shortest;
}

}  // namespace

std::size_t least_bytes(std::size_t columns, std::size_t replay_series) {
  const double plots = static_cast<double>(columns) * (kOverhead + 2.0 * kLeastBuckets * kBytesPerValue);
  const double replay = static_cast<double>(replay_series) * (kOverhead + kLeastSamples * kBytesPerValue);
  return static_cast<std::size_t>(plots + replay);
}

Resolution resolution_for(std::size_t bytes, std::size_t columns, std::size_t replay_series, double seconds) {
  constexpr double kMostBuckets = 700.0;
  constexpr double kMostRate = 25.0;  // [Hz]
  constexpr double kForPlots = 0.75;  // largest share of the bytes
  const double all = static_cast<double>(std::max<std::size_t>(1, columns));
  const double values = (kForPlots * static_cast<double>(bytes) / all - kOverhead) / kBytesPerValue;
  const double buckets = std::floor(std::clamp(values / 2.0, kLeastBuckets, kMostBuckets));
  Resolution resolution;
  resolution.buckets = static_cast<std::size_t>(buckets);
  const double left = static_cast<double>(bytes) - all * (kOverhead + 2.0 * buckets * kBytesPerValue);
  const double series = static_cast<double>(std::max<std::size_t>(1, replay_series));
  const double samples = std::max(kLeastSamples, (left / series - kOverhead) / kBytesPerValue);
  resolution.replay_rate = std::min(kMostRate, samples / std::max(seconds, 1.0));
  return resolution;
}

NumberTable read_recording(const std::string& path) {
  return NumberTable::read(path, [](std::string_view name) {
    return name == "time" || name == "state" || name == "slerping" || name.starts_with("joint/") ||
           name.starts_with("target/position/") || name.starts_with("closest/") || is_task_column(name);
  });
}

std::vector<std::string> joints_of(const NumberTable& rollout) {
  constexpr std::string_view kBegin = "joint/";
  constexpr std::string_view kEnd = "/position";
  std::vector<std::string> names;
  for (const std::string& column : rollout.header()) {
    if (column.size() < kBegin.size() + kEnd.size()) continue;
    if (!column.starts_with(kBegin) || !column.ends_with(kEnd)) continue;
    names.push_back(column.substr(kBegin.size(), column.size() - kBegin.size() - kEnd.size()));
  }
  return names;
}

Run run_of(const NumberTable& rollout, const SceneScenario* scenario, const Arm* arm,
           const Resolution& resolution) {
  RunBuilder builder(rollout, resolution);
  builder.run.start = builder.began();
  builder.add_task_columns();
  if (arm != nullptr) add_joint_columns(rollout, *arm, builder);
  add_states(rollout, builder.since(), builder.run);
  thin_changes(builder.run);
  builder.add_replay(scenario, arm);
  return std::move(builder.run);
}

}  // namespace armtune::internal::report

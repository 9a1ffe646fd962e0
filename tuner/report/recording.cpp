#include "tuner/report/recording.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tuner/report/run_builder.hpp"

namespace armtune::report {
namespace {

std::string joint_column(const ArmJoint& joint, const char* what) {
  return "joint/" + joint.name + "/" + what;
}

/// |torque| over its limit as commanded; in older files, which have no column of it, after saturation.
std::vector<double> torque_ratio(const CsvTable& rollout, const ArmJoint& joint) {
  if (const auto ratio = rollout.find(joint_column(joint, "torque_ratio"))) return rollout.numbers(*ratio);
  std::vector<double> values = rollout.numbers(rollout.column(joint_column(joint, "torque")));
  for (double& value : values) value = std::abs(value) / joint.effort_limit;
  return values;
}

void add_joint_columns(const CsvTable& rollout, const Arm& arm, RunBuilder& builder) {
  for (const ArmJoint& joint : arm.joints) {
    const std::string ratio = joint_column(joint, "velocity_ratio");
    builder.add(ratio, "velocity_ratio", "1", rollout.numbers(rollout.column(ratio)));
    builder.add(joint_column(joint, "torque_ratio"), "torque_ratio", "1", torque_ratio(rollout, joint));
    // Of scenarios with a plan.
    const std::string error = joint_column(joint, "error");
    if (const auto c = rollout.find(error))
      builder.add(error, "joint_error", joint.prismatic ? "m" : "rad", rollout.numbers(*c));
  }
}

void add_states(const CsvTable& rollout, const std::vector<double>& time, Run& run) {
  const std::size_t state_column = rollout.column("state");
  const std::size_t slerp_column = rollout.column("slerping");
  int state = -1;
  bool slerping = false;
  for (std::size_t r = 0; r < time.size(); ++r) {
    const int now = static_cast<int>(rollout.number(r, state_column));
    if (now != state) run.states.push_back({time[r], now});
    state = now;
    const bool turns = rollout.number(r, slerp_column) != 0.0;
    if (turns && !slerping) run.slerps.emplace_back(time[r], time[r]);
    if (slerping) run.slerps.back().second = time[r];
    slerping = turns;
  }
}

}  // namespace

Resolution resolution_for(std::size_t runs, std::size_t columns, double seconds, std::size_t bytes) {
  constexpr double kBytesPerValue = 8.0 / 3.0;  // two bytes in base64
  constexpr double kOverhead = 120.0;           // of a series: name, group, unit, limits
  constexpr std::size_t kLeast = 50;
  Resolution resolution;
  // Three quarters for plots, the rest for the replay, which has about half as many columns.
  const double all = static_cast<double>(std::max<std::size_t>(1, runs * columns));
  const double values = (0.75 * static_cast<double>(bytes) / all - kOverhead) / kBytesPerValue;
  const double buckets = std::clamp(values / 2.0, static_cast<double>(kLeast), 700.0);
  resolution.buckets = static_cast<std::size_t>(buckets);
  const double samples = 0.25 * static_cast<double>(bytes) / kBytesPerValue /
                         (0.5 * static_cast<double>(std::max<std::size_t>(1, columns)));
  resolution.replay_rate = std::min(25.0, samples / std::max(seconds, 1.0));
  return resolution;
}

std::vector<std::string> joints_of(const CsvTable& rollout) {
  constexpr std::string_view kBegin = "joint/";
  constexpr std::string_view kEnd = "/position";
  std::vector<std::string> names;
  for (const std::string& column : rollout.header()) {
    if (!column.starts_with(kBegin) || !column.ends_with(kEnd)) continue;
    names.push_back(column.substr(kBegin.size(), column.size() - kBegin.size() - kEnd.size()));
  }
  return names;
}

Run run_of(const CsvTable& rollout, const SceneScenario* scenario, const Arm* arm,
           const Resolution& resolution) {
  RunBuilder builder(rollout, resolution);
  builder.run.start = builder.began();
  builder.add_task_columns();
  if (arm != nullptr) add_joint_columns(rollout, *arm, builder);
  add_states(rollout, builder.since(), builder.run);
  builder.add_replay(scenario, arm);
  return std::move(builder.run);
}

}  // namespace armtune::report

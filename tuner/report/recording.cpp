#include "tuner/report/recording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/control/state_machine.hpp"
#include "tuner/report/buckets.hpp"

namespace armtune::report {
namespace {

struct GroupOf {
  const char* prefix;
  const char* group;
  const char* unit;
};

/// Of columns whose names begin so.
constexpr GroupOf kGroups[] = {{"tool/position/", "position", "m"},
                               {"desired/position/", "position", "m"},
                               {"error/position/", "position_error", "m"},
                               {"error/orientation/", "orientation_error", "rad"},
                               {"error/linear_velocity/", "linear_velocity_error", "m/s"},
                               {"error/angular_velocity/", "angular_velocity_error", "rad/s"},
                               {"gaze/angle", "gaze", "rad"},
                               {"compensation_error", "theta", "N m"},
                               {"obstacle/distance", "clearance", "m"},
                               {"manipulability", "manipulability", "m^3"}};

constexpr const char* kAxes[] = {"x", "y", "z"};

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

/// An error's column; no value in the states that do not track it, where the file has zeros.
std::vector<double> tracked(const CsvTable& rollout, std::size_t column, bool position) {
  const std::size_t state = rollout.column("state");
  std::vector<double> values = rollout.numbers(column);
  for (std::size_t r = 0; r < values.size(); ++r) {
    const auto now = static_cast<ControlState>(rollout.number(r, state));
    const bool free = tracks_joints(now) || (position && now == ControlState::kAvoidObstacles);
    if (free) values[r] = std::numeric_limits<double>::quiet_NaN();
  }
  return values;
}

void add_columns(const CsvTable& rollout, const Arm* arm, const Buckets& buckets, Run& run) {
  const auto add = [&](const std::string& name, const char* group, const char* unit,
                       const std::vector<double>& values) {
    run.columns.push_back({name, group, unit, quantize(buckets.extremes(values))});
  };
  for (const GroupOf& g : kGroups) {
    for (std::size_t c = 0; c < rollout.header().size(); ++c) {
      const std::string& name = rollout.header()[c];
      if (!name.starts_with(g.prefix)) continue;
      const bool error = name.starts_with("error/");
      add(name, g.group, g.unit,
          error ? tracked(rollout, c, name.starts_with("error/position/")) : rollout.numbers(c));
    }
  }
  if (arm == nullptr) return;
  for (const ArmJoint& joint : arm->joints) {
    const std::string ratio = joint_column(joint, "velocity_ratio");
    add(ratio, "velocity_ratio", "1", rollout.numbers(rollout.column(ratio)));
    add(joint_column(joint, "torque_ratio"), "torque_ratio", "1", torque_ratio(rollout, joint));
    // Of scenarios with a plan.
    const std::string error = joint_column(joint, "error");
    if (const auto c = rollout.find(error))
      add(error, "joint_error", joint.prismatic ? "m" : "rad", rollout.numbers(*c));
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

/// Rows nearest to k dt, for every k up to the last row's time. time: rising, at least one.
std::vector<std::size_t> sampled_rows(const std::vector<double>& time, double dt) {
  std::vector<std::size_t> rows;
  std::size_t r = 0;
  const double end = time.back() - time.front();
  for (std::size_t k = 0; static_cast<double>(k) * dt <= end * (1.0 + 1e-9); ++k) {
    const double wanted = time.front() + static_cast<double>(k) * dt;
    while (r + 1 < time.size() && std::abs(time[r + 1] - wanted) <= std::abs(time[r] - wanted)) ++r;
    rows.push_back(r);
  }
  return rows;
}

std::vector<double> picked(const std::vector<double>& values, const std::vector<std::size_t>& rows) {
  std::vector<double> kept;
  kept.reserve(rows.size());
  for (const std::size_t r : rows) kept.push_back(values[r]);
  return kept;
}

/// Largest value of the rows nearest to each of n samples: a peak between two of them is not missed.
std::vector<double> peaks(const std::vector<double>& values, const std::vector<double>& time, double dt,
                          std::size_t n) {
  std::vector<double> largest(n, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t r = 0; r < time.size(); ++r) {
    const auto nearest = static_cast<std::size_t>(std::max(0L, std::lround((time[r] - time.front()) / dt)));
    double& peak = largest[std::min(nearest, n - 1)];
    peak = std::fmax(peak, values[r]);
  }
  return largest;
}

/// x, y, z of a column's vector at the rows.
std::vector<Series> vector_series(const CsvTable& rollout, const std::string& name,
                                  const std::vector<std::size_t>& rows) {
  std::vector<Series> axes;
  axes.reserve(3);
  for (const char* axis : kAxes) {
    axes.push_back(quantize(picked(rollout.numbers(rollout.column(name + "/" + axis)), rows)));
  }
  return axes;
}

Series error_norm(const CsvTable& rollout, const std::vector<std::size_t>& rows) {
  std::vector<double> norms(rows.size(), 0.0);
  for (const char* axis : kAxes) {
    const std::size_t c = rollout.column(std::string("error/position/") + axis);
    const auto values = tracked(rollout, c, true);
    for (std::size_t i = 0; i < rows.size(); ++i) norms[i] = std::hypot(norms[i], values[rows[i]]);
  }
  return quantize(norms);
}

std::vector<Series> center_of(const HarmonicPath& obstacle, const std::vector<double>& times) {
  std::vector<Series> axes;
  axes.reserve(3);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    values.reserve(times.size());
    for (const double t : times) values.push_back(obstacle.at(t).position[axis]);
    axes.push_back(quantize(values));
  }
  return axes;
}

Replay replay_of(const CsvTable& rollout, const SceneScenario& scenario, const Arm& arm,
                 const std::vector<double>& time, double rate) {
  Replay replay;
  const double row_step =
      time.size() > 1 ? (time.back() - time.front()) / static_cast<double>(time.size() - 1) : 1.0;
  replay.dt = std::max(1.0 / rate, row_step);
  const auto rows = sampled_rows(time, replay.dt);
  replay.n = rows.size();
  for (const ArmJoint& joint : arm.joints) {
    const auto column = [&](const char* what) {
      return rollout.numbers(rollout.column(joint_column(joint, what)));
    };
    replay.q.push_back(quantize(picked(column("position"), rows)));
    replay.velocity_ratio.push_back(quantize(peaks(column("velocity_ratio"), time, replay.dt, replay.n)));
  }
  replay.target = vector_series(rollout, "target/position", rows);
  replay.tool = vector_series(rollout, "tool/position", rows);
  replay.error = error_norm(rollout, rows);
  const std::vector<double> times = picked(time, rows);
  for (const HarmonicPath& obstacle : scenario.obstacles)
    replay.obstacles.push_back(center_of(obstacle, times));
  return replay;
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
  Run run;
  const std::vector<double> time = rollout.numbers(rollout.column("time"));
  if (!time.empty()) run.start = time.front();
  std::vector<double> since = time;
  for (double& t : since) t -= run.start;
  if (!since.empty()) run.end = since.back();
  const Buckets buckets(time.size(), resolution.buckets);
  run.time = quantize(buckets.times(since));
  add_columns(rollout, arm, buckets, run);
  add_states(rollout, since, run);
  if (scenario != nullptr && arm != nullptr && !time.empty()) {
    run.replay = replay_of(rollout, *scenario, *arm, time, resolution.replay_rate);
  }
  return run;
}

}  // namespace armtune::report

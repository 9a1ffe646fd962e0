#include "tuner/report/replay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/control/state_machine.hpp"

namespace armtune::internal::report {
namespace {

constexpr const char* kAxes[] = {"x", "y", "z"};

/// Returns the row nearest to each time k dt, up to the time of the last row. time: at least one, not
/// decreasing.
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

/// Returns, for each of n samples, the largest value of the rows nearest to it. Thus no peak is missed.
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

/// Returns x, y, z of a vector at the rows; empty if the file does not have the vector.
std::vector<Series> vector_series(const NumberTable& rollout, const std::string& name,
                                  const std::vector<std::size_t>& rows) {
  std::vector<Series> axes;
  if (!rollout.find(name + "/x")) return axes;
  axes.reserve(3);
  for (const char* axis : kAxes) {
    axes.push_back(quantize(picked(rollout.numbers(rollout.column(name + "/" + axis)), rows)));
  }
  return axes;
}

Series error_norm(const NumberTable& rollout, const std::vector<std::size_t>& rows) {
  if (!rollout.find("error/position/x"))  // a plan from point to point
    return quantize(std::vector<double>(rows.size(), std::numeric_limits<double>::quiet_NaN()));
  std::vector<double> norms(rows.size(), 0.0);
  for (const char* axis : kAxes) {
    const std::size_t c = rollout.column(std::string("error/position/") + axis);
    const auto values = tracked(rollout, c, true);
    for (std::size_t i = 0; i < rows.size(); ++i) norms[i] = std::hypot(norms[i], values[rows[i]]);
  }
  return quantize(norms);
}

std::vector<Series> center_of(const Path& obstacle, const std::vector<double>& times) {
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

}  // namespace

std::vector<double> tracked(const NumberTable& rollout, std::size_t column, bool position) {
  std::vector<double> values = rollout.numbers(column);
  const auto state = rollout.find("state");
  if (!state) return values;
  for (std::size_t r = 0; r < values.size(); ++r) {
    const double number = rollout.number(r, *state);
    if (!(number >= 0.0 && number <= static_cast<double>(ControlState::kFollowPlan))) continue;
    const auto now = static_cast<ControlState>(number);
    const bool free = tracks_joints(now) || (position && now == ControlState::kAvoidObstacles);
    if (free) values[r] = std::numeric_limits<double>::quiet_NaN();
  }
  return values;
}

Replay replay_of(const NumberTable& rollout, const SceneScenario& scenario, const Arm& arm,
                 const std::vector<double>& time, double rate) {
  Replay replay;
  const double row_step =
      time.size() > 1 ? (time.back() - time.front()) / static_cast<double>(time.size() - 1) : 1.0;
  replay.dt = std::max(1.0 / rate, row_step);
  const auto rows = sampled_rows(time, replay.dt);
  replay.n = rows.size();
  for (const ArmJoint& joint : arm.joints) {
    const auto column = [&](const char* what) {
      return rollout.numbers(rollout.column("joint/" + joint.name + "/" + what));
    };
    replay.q.push_back(quantize(picked(column("position"), rows)));
    replay.velocity_ratio.push_back(quantize(peaks(column("velocity_ratio"), time, replay.dt, replay.n)));
  }
  replay.target = vector_series(rollout, "target/position", rows);
  replay.tool = vector_series(rollout, "tool/position", rows);
  replay.error = error_norm(rollout, rows);
  const std::vector<double> times = picked(time, rows);
  for (const SceneObstacle& obstacle : scenario.obstacles)
    replay.obstacles.push_back(center_of(obstacle.path, times));
  for (const ScenePart& part : scenario.cell) replay.cell.push_back(center_of(part.path, times));
  replay.closest = vector_series(rollout, "closest/of", rows);
  for (Series& axis : vector_series(rollout, "closest/to", rows)) replay.closest.push_back(std::move(axis));
  if (replay.closest.size() != 6) replay.closest.clear();
  return replay;
}

}  // namespace armtune::internal::report

#include "tuner/validation/motion_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

/// Returns the largest RMS error of each joint (n) that matches at a horizon.
JointVector allowed_errors(const MotionValidation& found, std::size_t horizon) {
  const ValidationThresholds& thresholds = found.thresholds;
  const double share =
      found.kind == CommandKind::kTorque ? thresholds.torque_motion : thresholds.drive_motion;
  JointVector allowed(static_cast<Eigen::Index>(found.joint.size()));
  for (std::size_t j = 0; j < found.joint.size(); ++j) {
    allowed[static_cast<Eigen::Index>(j)] =
        std::max(share * found.joint[j].yardstick(horizon), thresholds.drift * found.horizons[horizon]);
  }
  return allowed;
}

/// Sets the horizon by which the motion is judged, and how far each joint exceeds its allowed error.
void judge(MotionValidation& found) {
  const ValidationThresholds& thresholds = found.thresholds;
  const std::size_t at = found.index_of(found.kind == CommandKind::kTorque ? thresholds.torque_horizon
                                                                           : thresholds.drive_horizon);
  found.judged = found.horizons[at];
  const JointVector allowed = allowed_errors(found, at);
  for (std::size_t j = 0; j < found.joint.size(); ++j) {
    // Without a window that reaches the horizon there is nothing that could match.
    const double excess = found.joint[j].rms[at] / allowed[static_cast<Eigen::Index>(j)];
    found.excess.push_back(std::isfinite(excess) ? excess : std::numeric_limits<double>::infinity());
  }
}

/// Keeps the positions of the windows with the largest, a median and the smallest error at the judged
/// horizon.
void keep_examples(const std::vector<WindowRun>& runs, MotionValidation& found) {
  const std::size_t at = found.index_of(found.judged);
  const JointVector allowed = allowed_errors(found, at);
  const auto size = [&](std::size_t w) {
    const auto row = static_cast<Eigen::Index>(std::min(at, runs[w].time.size() - 1));
    const Eigen::VectorXd error = (runs[w].simulated.row(row) - runs[w].measured.row(row)).transpose();
    return error.cwiseAbs().cwiseQuotient(allowed).maxCoeff();
  };
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  std::vector<std::size_t> kept = {order.front(), order[order.size() / 2], order.back()};
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  for (const std::size_t w : kept) {
    MotionExample example{w, runs[w].time, runs[w].measured, runs[w].simulated};
    for (double& t : example.time) t += runs[w].begin;
    found.examples.push_back(std::move(example));
  }
}

}  // namespace

bool MotionValidation::model_matches() const {
  return static_cast<double>(failed) <= thresholds.failed_windows * static_cast<double>(windows.size()) &&
         std::all_of(excess.begin(), excess.end(), [](double x) { return x <= 1.0; });
}

int MotionValidation::worst_joint() const {
  return static_cast<int>(std::max_element(excess.begin(), excess.end()) - excess.begin());
}

std::size_t MotionValidation::index_of(double horizon) const {
  const auto after = std::upper_bound(horizons.begin(), horizons.end(), horizon + 0.5 * kHorizonStep);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - horizons.begin(), 1)) - 1;
}

MotionValidation validate_motion(const RobotModel& model, const JointLog& log, const MotionCommands& commands,
                                 const ValidationThresholds& thresholds) {
  check_motion_commands(model, log, commands);
  const LoggedMotion motion = joint_motion(model, log, thresholds);
  const std::vector<WindowPlace> places = place_windows(motion, commands, thresholds);
  if (places.empty()) {
    throw InputError(
        InputPlace{log.source, 0, "command time"},
        {fmt::format("no commands were logged while the positions of the log have no gap; the commands reach "
                     "from {} s to {} s, check their clock",
                     commands.time.front(), commands.time.back()),
         fmt::format("{} s to {} s", commands.time.front(), commands.time.back()),
         fmt::format("{} s to {} s", log.time.front(), log.time.back())});
  }
  MotionValidation found;
  found.thresholds = thresholds;
  found.kind = commands.kind;
  WindowSimulator simulator(model, commands);
  std::vector<WindowRun> runs;
  std::size_t horizons = 0;
  for (const WindowPlace& place : places) {
    const WindowRun& run = runs.emplace_back(simulator.run(motion.stretches[place.stretch], place));
    found.windows.push_back({run.begin, place.duration, run.failed_at, run.limit_joint, run.limit_at});
    found.failed += run.failed_at >= 0.0 ? 1 : 0;
    found.at_limit += run.limit_joint >= 0 ? 1 : 0;
    horizons = std::max(horizons, horizon_count(place.duration));
  }
  for (std::size_t h = 0; h < horizons; ++h) {
    found.horizons.push_back(static_cast<double>(h) * kHorizonStep);
    found.count.push_back(
        std::count_if(runs.begin(), runs.end(), [h](const WindowRun& run) { return h < run.time.size(); }));
  }
  for (int j = 0; j < model.n(); ++j) found.joint.push_back(horizon_curve(runs, j, horizons));
  judge(found);
  keep_examples(runs, found);
  return found;
}

}  // namespace armtune::internal

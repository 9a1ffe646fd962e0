#include "tuner/validation/joint_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

/// Fewest samples that can be filtered at all.
constexpr Eigen::Index kFewestSamples = 20;
constexpr std::size_t kMostJumps = 100;
/// A jump is this many times as fast as the joint's fast steps, so that a log in degrees has none.
constexpr double kOverOwnSpeed = 5.0;
/// Share of the joint's steps that are slower than its fast steps.
constexpr double kFastShare = 0.95;
/// A sample nearer to its neighbour than this share of the period has the same time.
constexpr double kSameTime = 0.05;
/// A sample nearer to a point of the grid than this share of the period is taken as it is.
constexpr double kOnGrid = 1e-3;

void check_channel(const JointLog& log, const Eigen::MatrixXd& values, const char* key, int joints) {
  if (values.rows() != log.samples() || values.cols() != joints) {
    throw InputError(
        InputPlace{log.source, 0, key},
        {fmt::format("{} samples of {} joints, although the log has {} times and the arm {} joints",
                     values.rows(), values.cols(), log.samples(), joints),
         fmt::format("{} x {}", values.rows(), values.cols()),
         fmt::format("{} x {}", log.samples(), joints)});
  }
  for (Eigen::Index j = 0; j < values.cols(); ++j) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      if (std::isfinite(values(i, j))) continue;
      throw InputError(
          InputPlace{log.source, 0, key},
          {fmt::format("sample {} of joint {} is {}; leave this sample out", i + 1, j + 1, values(i, j)),
           fmt::to_string(values(i, j)), "a finite number"});
    }
  }
}

/// Returns the value that a share of the numbers does not exceed.
double share_below(std::vector<double> numbers, double share) {
  const auto place =
      numbers.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(numbers.size() - 1));
  std::nth_element(numbers.begin(), place, numbers.end());
  return *place;
}

/// Cubic interpolation of a column between the samples i and i + 1 by Lagrange's polynomial through four
/// samples, or linear interpolation at the ends. from, to: first and last sample that may be used.
double cubic(const JointLog& log, const std::vector<Eigen::Index>& kept, std::size_t i, Eigen::Index column,
             double t) {
  const auto at = [&](std::size_t k) { return log.q(kept[k], column); };
  const auto time = [&](std::size_t k) { return log.time[static_cast<std::size_t>(kept[k])]; };
  const std::size_t first = i > 0 && i + 2 < kept.size() ? i - 1 : i;
  const std::size_t last = first < i ? i + 2 : i + 1;
  double value = 0.0;
  for (std::size_t k = first; k <= last; ++k) {
    double weight = 1.0;
    for (std::size_t l = first; l <= last; ++l) {
      if (l != k) weight *= (t - time(l)) / (time(k) - time(l));
    }
    value += weight * at(k);
  }
  return value;
}

/// Resamples the kept samples at their mean rate.
UniformStretch resampled(const JointLog& log, const std::vector<Eigen::Index>& kept) {
  const auto time = [&](std::size_t k) { return log.time[static_cast<std::size_t>(kept[k])]; };
  const Eigen::Index n = log.q.cols();
  const auto count = static_cast<Eigen::Index>(kept.size());
  UniformStretch out;
  out.begin = time(0);
  out.period = (time(kept.size() - 1) - time(0)) / static_cast<double>(count - 1);
  out.q.resize(count, n);
  out.torque.setZero(count, n);
  if (log.has_velocities()) out.qd.resize(count, n);
  std::size_t i = 0;
  for (Eigen::Index row = 0; row < count; ++row) {
    const double t = out.begin + static_cast<double>(row) * out.period;
    while (i + 2 < kept.size() && time(i + 1) <= t) ++i;
    const double share = (t - time(i)) / (time(i + 1) - time(i));
    const bool on_first = std::abs(t - time(i)) < kOnGrid * out.period;
    const bool on_second = std::abs(t - time(i + 1)) < kOnGrid * out.period;
    const auto linear = [&](const Eigen::MatrixXd& x, Eigen::Index j) {
      if (on_first) return x(kept[i], j);
      if (on_second) return x(kept[i + 1], j);
      return x(kept[i], j) + share * (x(kept[i + 1], j) - x(kept[i], j));
    };
    for (Eigen::Index j = 0; j < n; ++j) {
      out.q(row, j) = on_first || on_second ? linear(log.q, j) : cubic(log, kept, i, j, t);
      if (log.has_torques()) out.torque(row, j) = linear(log.torque, j);
      if (log.has_velocities()) out.qd(row, j) = linear(log.qd, j);
    }
  }
  return out;
}

}  // namespace

void check_joint_log(const RobotModel& model, const JointLog& log) {
  if (log.samples() < kFewestSamples) {
    throw InputError(
        InputPlace{log.source, 0, "time"},
        {fmt::format("{} samples are too few to compare with the arm; log longer", log.samples()),
         fmt::to_string(log.samples()), fmt::format("at least {}", kFewestSamples)});
  }
  check_channel(log, log.q, "position", model.n());
  if (log.has_torques()) check_channel(log, log.torque, "torque", model.n());
  if (log.has_velocities()) check_channel(log, log.qd, "velocity", model.n());
  for (std::size_t i = 0; i < log.time.size(); ++i) {
    const double step = i == 0 ? 0.0 : log.time[i] - log.time[i - 1];
    if (std::isfinite(log.time[i]) && step >= 0.0) continue;
    throw InputError(
        InputPlace{log.source, 0, "time"},
        {fmt::format("the time of sample {} is {} s, which is not after the one before; split the log there",
                     i + 1, log.time[i]),
         fmt::to_string(log.time[i]), "a time that does not decrease"});
  }
  if (!(log.time.back() > log.time.front()))
    throw InputError(InputPlace{log.source, 0, "time"},
                     {"all samples have the same time; check the time column",
                      fmt::to_string(log.time.front()), "increasing times"});
}

double sampling_period(const JointLog& log) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < log.time.size(); ++i) {
    if (log.time[i] > log.time[i - 1]) steps.push_back(log.time[i] - log.time[i - 1]);
  }
  return share_below(std::move(steps), 0.5);
}

std::vector<PositionJump> position_jumps(const RobotModel& model, const JointLog& log,
                                         const ValidationThresholds& thresholds) {
  const double period = sampling_period(log);
  std::vector<PositionJump> jumps;
  for (int j = 0; j < model.n(); ++j) {
    std::vector<double> speeds;
    for (Eigen::Index i = 1; i < log.samples(); ++i)
      speeds.push_back(std::abs(log.q(i, j) - log.q(i - 1, j)) /
                       std::max(period, log.time[static_cast<std::size_t>(i)] -
                                            log.time[static_cast<std::size_t>(i - 1)]));
    const double limit = model.joints[static_cast<std::size_t>(j)].limits.velocity;
    const double fast =
        std::max(thresholds.jump_speed * limit, kOverOwnSpeed * share_below(speeds, kFastShare));
    for (Eigen::Index i = 1; i < log.samples() && jumps.size() < kMostJumps; ++i) {
      const double size = log.q(i, j) - log.q(i - 1, j);
      if (speeds[static_cast<std::size_t>(i - 1)] <= fast || std::abs(size) < thresholds.jump_size) continue;
      jumps.push_back({j, i, log.time[static_cast<std::size_t>(i)], size});
    }
  }
  return jumps;
}

std::vector<UniformStretch> uniform_stretches(const JointLog& log, const std::vector<PositionJump>& jumps,
                                              const ValidationThresholds& thresholds) {
  const double period = sampling_period(log);
  std::vector<bool> begins(log.time.size(), false);
  for (const PositionJump& jump : jumps) begins[static_cast<std::size_t>(jump.sample)] = true;
  std::vector<UniformStretch> stretches;
  std::vector<Eigen::Index> kept;
  const auto finish = [&] {
    if (static_cast<Eigen::Index>(kept.size()) >= kFewestSamples) stretches.push_back(resampled(log, kept));
    kept.clear();
  };
  for (std::size_t i = 0; i < log.time.size(); ++i) {
    if (!kept.empty()) {
      const double step = log.time[i] - log.time[static_cast<std::size_t>(kept.back())];
      if (step > thresholds.gap * period || begins[i]) {
        finish();
      } else if (step < kSameTime * period) {
        continue;
      }
    }
    kept.push_back(static_cast<Eigen::Index>(i));
  }
  finish();
  return stretches;
}

}  // namespace armtune::internal

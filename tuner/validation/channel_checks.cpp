#include "tuner/validation/channel_checks.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Fewest samples at an extreme value, and fewest of them in a row, that are no coincidence.
constexpr int kFewestClipped = 20;
constexpr int kShortestRun = 3;
/// Samples nearer to the extreme than this share of the channel's range are at the extreme.
constexpr double kAtExtreme = 1e-6;
/// Correlation from which a velocity is that of a position.
constexpr double kSameSignal = 0.9;
/// A wrong rate has the same factor in all joints within this.
constexpr double kSameFactor = 0.03;
/// Slope of a velocity in degrees per second over one in radians per second.
constexpr double kDegreesPerRadian = 180.0 / M_PI;
/// Least change of a position while its channel or a velocity channel should not be frozen [rad, m].
constexpr double kFrozenMotion = 0.02;
/// A moving joint has this share of its positions beyond a limit if the unit is wrong.
constexpr double kUnitShare = 0.05;

/// Counts the samples of a channel at one of its extremes that belong to runs, while the joint moves.
LogFinding clipped_at(const JointLog& log, Eigen::Index joint, double extreme, double range) {
  LogFinding found{
      .kind = LogFindingKind::kTorqueClipped, .joint = static_cast<int>(joint), .value = extreme};
  double samples = 0.0;
  int runs = 0;
  for (Eigen::Index i = 0; i < log.samples();) {
    Eigen::Index end = i;
    while (end < log.samples() && std::abs(log.torque(end, joint) - extreme) <= kAtExtreme * range) ++end;
    const bool moves = end > i && log.q(i, joint) != log.q(end - 1, joint);
    if (end - i >= kShortestRun && moves) {
      samples += static_cast<double>(end - i);
      ++runs;
    }
    i = std::max(end, i + 1);
  }
  found.share = samples >= kFewestClipped && runs >= 2 ? samples / static_cast<double>(log.samples()) : 0.0;
  return found;
}

void add_clipped(const JointLog& log, Eigen::Index joint, double least_share, std::vector<LogFinding>& out) {
  const double low = log.torque.col(joint).minCoeff();
  const double high = log.torque.col(joint).maxCoeff();
  for (const double extreme : {low, high}) {
    const LogFinding found = clipped_at(log, joint, extreme, high - low);
    if (high > low && found.share >= least_share) out.push_back(found);
  }
}

/// The longest time for which a channel keeps one value although `moves` says that it must not.
template <typename Moves>
LogFinding longest_frozen(const JointLog& log, const Eigen::MatrixXd& channel, Eigen::Index joint,
                          LogFindingKind kind, const Moves& moves) {
  LogFinding found{.kind = kind, .joint = static_cast<int>(joint)};
  const auto time = [&](Eigen::Index i) { return log.time[static_cast<std::size_t>(i)]; };
  for (Eigen::Index i = 0; i < log.samples();) {
    Eigen::Index end = i + 1;
    while (end < log.samples() && channel(end, joint) == channel(i, joint)) ++end;
    const double kept = time(end - 1) - time(i);
    if (kept > found.value && moves(i, end)) {
      found.value = kept;
      found.time = time(i);
    }
    i = end;
  }
  return found;
}

double range_of(const Eigen::MatrixXd& channel, Eigen::Index joint, Eigen::Index begin, Eigen::Index end) {
  const auto part = channel.col(joint).segment(begin, end - begin);
  return part.maxCoeff() - part.minCoeff();
}

void add_frozen(const JointLog& log, Eigen::Index joint, double longest, std::vector<LogFinding>& out) {
  const auto position_moves = [&](Eigen::Index i, Eigen::Index end) {
    return range_of(log.q, joint, i, end) > kFrozenMotion;
  };
  const auto add = [&](const LogFinding& found) {
    if (found.value > longest) out.push_back(found);
  };
  // A torque that stays at the value at which it is clipped is no frozen channel.
  const auto is_clipped = [&](double torque) {
    return std::any_of(out.begin(), out.end(), [&](const LogFinding& one) {
      return one.kind == LogFindingKind::kTorqueClipped && one.joint == joint && one.value == torque;
    });
  };
  if (log.has_torques()) {
    add(longest_frozen(log, log.torque, joint, LogFindingKind::kTorqueFrozen,
                       [&](Eigen::Index i, Eigen::Index end) {
                         return position_moves(i, end) && !is_clipped(log.torque(i, joint));
                       }));
  }
  if (!log.has_velocities()) return;
  add(longest_frozen(
      log, log.qd, joint, LogFindingKind::kVelocityFrozen, [&](Eigen::Index i, Eigen::Index end) {
        const double duration =
            log.time[static_cast<std::size_t>(end - 1)] - log.time[static_cast<std::size_t>(i)];
        const double expected = log.qd(i, joint) * duration;
        return std::abs(log.q(end - 1, joint) - log.q(i, joint) - expected) > kFrozenMotion ||
               range_of(log.q, joint, i, end) > kFrozenMotion + std::abs(expected);
      }));
  add(longest_frozen(
      log, log.q, joint, LogFindingKind::kPositionFrozen, [&](Eigen::Index i, Eigen::Index end) {
        double travelled = 0.0;
        for (Eigen::Index k = i + 1; k < end; ++k)
          travelled += std::abs(log.qd(k, joint)) *
                       (log.time[static_cast<std::size_t>(k)] - log.time[static_cast<std::size_t>(k - 1)]);
        return travelled > 2.0 * kFrozenMotion;
      }));
}

/// Returns the position that a share of kUnitShare of the samples exceeds, as a multiple of the joint's
/// larger limit.
double over_limit(const RobotModel& model, const JointLog& log, Eigen::Index joint) {
  const JointLimits& limits = model.joints[static_cast<std::size_t>(joint)].limits;
  if (model.chain.motion[static_cast<std::size_t>(joint)] != JointMotion::kRevolute) return 0.0;
  std::vector<double> sizes;
  for (Eigen::Index i = 0; i < log.samples(); ++i) sizes.push_back(std::abs(log.q(i, joint)));
  const auto place =
      sizes.begin() + static_cast<std::ptrdiff_t>((1.0 - kUnitShare) * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), place, sizes.end());
  const double limit =
      limits.has_position ? std::max(std::abs(limits.lower), std::abs(limits.upper)) : 2.0 * M_PI;
  return *place / std::max(limit, 0.1);
}

}  // namespace

std::vector<LogFinding> channel_findings(const RobotModel& model, const JointLog& log,
                                         const LoggedMotion& motion, const ValidationThresholds& thresholds) {
  std::vector<LogFinding> out;
  for (const PositionJump& jump : motion.jumps)
    out.push_back(
        {.kind = LogFindingKind::kJump, .joint = jump.joint, .value = jump.size, .time = jump.time});
  for (Eigen::Index j = 0; j < model.n(); ++j) {
    if (log.has_torques()) add_clipped(log, j, thresholds.clipped_share, out);
    add_frozen(log, j, thresholds.frozen_time, out);
    const double over = over_limit(model, log, j);
    if (over > thresholds.outside_limits)
      out.push_back({.kind = LogFindingKind::kPositionUnit, .joint = static_cast<int>(j), .value = over});
  }
  return out;
}

std::vector<LogFinding> velocity_findings(const LoggedMotion& motion,
                                          const ValidationThresholds& thresholds) {
  std::vector<LogFinding> out;
  std::vector<double> slopes, lags;
  for (const VelocityAgreement& joint : motion.velocities) {
    if (!joint.compared || std::abs(joint.correlation) < kSameSignal) continue;
    slopes.push_back(joint.slope);
    lags.push_back(joint.lag);
  }
  const auto apart = [](const std::vector<double>& x) {
    return *std::max_element(x.begin(), x.end()) - *std::min_element(x.begin(), x.end());
  };
  // All velocities in degrees per second have a common factor too, and so have all positions in degrees.
  const auto is_near = [&](double factor) {
    return !slopes.empty() && std::abs(slopes.front() / factor - 1.0) < kSameFactor;
  };
  const bool degrees = is_near(kDegreesPerRadian) || is_near(1.0 / kDegreesPerRadian);
  const bool wrong_rate = !degrees && slopes.size() >= 2 && slopes.front() > 0.0 &&
                          apart(slopes) < kSameFactor * slopes.front() &&
                          std::abs(slopes.front() - 1.0) > thresholds.velocity_scale;
  if (wrong_rate) out.push_back({.kind = LogFindingKind::kRate, .value = 1.0 / slopes.front()});
  if (!lags.empty()) {
    std::nth_element(lags.begin(), lags.begin() + static_cast<std::ptrdiff_t>(lags.size() / 2), lags.end());
    const double lag = lags[lags.size() / 2];
    if (std::abs(lag) > thresholds.time_offset)
      out.push_back({.kind = LogFindingKind::kVelocityOffset, .value = lag});
  }
  for (std::size_t j = 0; j < motion.velocities.size(); ++j) {
    const VelocityAgreement& joint = motion.velocities[j];
    if (!joint.compared) continue;
    const auto add = [&](LogFindingKind kind, double value) {
      out.push_back({.kind = kind, .joint = static_cast<int>(j), .other = joint.best_joint, .value = value});
    };
    if (std::abs(joint.correlation) < kSameSignal) {
      const bool order =
          joint.best_joint != static_cast<int>(j) && std::abs(joint.best_correlation) >= kSameSignal;
      add(order ? LogFindingKind::kVelocityOrder : LogFindingKind::kVelocityOther, joint.correlation);
    } else if (joint.slope < 0.0) {
      add(LogFindingKind::kVelocitySign, joint.slope);
    } else if (!wrong_rate && std::abs(joint.slope - 1.0) > thresholds.velocity_scale) {
      add(LogFindingKind::kVelocityScale, joint.slope);
    }
  }
  return out;
}

}  // namespace armtune::internal

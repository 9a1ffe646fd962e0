#include "tuner/validation/joint_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

/// Longest lag between measured and differentiated velocity that is looked for [s].
constexpr double kLongestLag = 0.4;

/// Sums over pairs of measured and differentiated velocities.
struct VelocitySums {
  double count = 0.0, products = 0.0, measured = 0.0, differentiated = 0.0;
  double correlation() const { return products / std::sqrt(std::max(1e-30, measured * differentiated)); }
  double slope() const { return products / std::max(1e-30, differentiated); }
  double error() const {
    return std::sqrt(std::max(0.0, measured - 2.0 * products + differentiated) /
                     std::max(1e-30, differentiated));
  }
};

/// Compares the measured velocity of `channel`, `shift` instants later, with the differentiated position of
/// `joint`.
VelocitySums velocity_sums(const LoggedMotion& motion, int channel, int joint, long shift) {
  VelocitySums sums;
  for (const MotionStretch& stretch : motion.stretches) {
    const auto count = static_cast<long>(stretch.instants.size());
    for (long i = std::max(0L, -shift); i < std::min(count, count - shift); ++i) {
      const double a = stretch.instants[static_cast<std::size_t>(i + shift)].logged_velocity[channel];
      const double b = stretch.instants[static_cast<std::size_t>(i)].qd[joint];
      sums.count += 1.0;
      sums.products += a * b;
      sums.measured += a * a;
      sums.differentiated += b * b;
    }
  }
  return sums;
}

/// Returns the place of the maximum of the parabola through three values at -1, 0 and 1.
double parabola_peak(double before, double at, double after) {
  const double curvature = before - 2.0 * at + after;
  return curvature < 0.0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0.0;
}

VelocityAgreement agreement(const LoggedMotion& motion, int joint, int joints,
                            const ValidationThresholds& thresholds) {
  VelocityAgreement found;
  const VelocitySums same = velocity_sums(motion, joint, joint, 0);
  found.best_joint = joint;
  found.speed = std::sqrt(same.differentiated / std::max(1.0, same.count));
  if (found.speed < thresholds.moving) return found;
  found.compared = true;
  found.error = same.error();
  for (int k = 0; k < joints; ++k) {
    const double correlation = velocity_sums(motion, joint, k, 0).correlation();
    if (std::abs(correlation) > std::abs(found.best_correlation)) {
      found.best_correlation = correlation;
      found.best_joint = k;
    }
  }
  const double period = motion.stretches.front().period;
  const long longest = std::lround(kLongestLag / period);
  const auto size = [&](long shift) {
    return std::abs(velocity_sums(motion, joint, joint, shift).correlation());
  };
  long best = 0;
  for (long shift = -longest; shift <= longest; ++shift) {
    if (size(shift) > size(best)) best = shift;
  }
  const VelocitySums at_best = velocity_sums(motion, joint, joint, best);
  found.correlation = at_best.correlation();
  found.slope = at_best.slope();
  found.lag =
      (static_cast<double>(best) + parabola_peak(size(best - 1), size(best), size(best + 1))) * period;
  found.used = found.error < thresholds.velocity_error &&
               std::abs(found.slope - 1.0) < thresholds.velocity_scale &&
               std::abs(found.lag) < thresholds.time_offset;
  return found;
}

/// Applies the first filter to a stretch.
MotionStretch filtered(const RobotModel& model, const UniformStretch& log, bool velocities, double cutoff,
                       double& torque_norm) {
  ParallelFilter filter(model.n(), velocities, log.period, cutoff, 0.0, 1);
  torque_norm = filter.torque_norm();
  MotionStretch out;
  out.begin = log.begin + filter.first_half() * log.period;
  out.period = filter.motion_period();
  out.sample_period = log.period;
  for (Eigen::Index i = 0; i < log.q.rows(); ++i) {
    const JointVector q = log.q.row(i).transpose();
    const JointVector torque = log.torque.row(i).transpose();
    const JointVector qd = velocities ? JointVector(log.qd.row(i).transpose()) : JointVector();
    if (filter.push(q, qd, torque)) out.instants.push_back(filter.motion());
  }
  return out;
}

}  // namespace

LoggedMotion joint_motion(const RobotModel& model, const JointLog& log,
                          const ValidationThresholds& thresholds, double cutoff) {
  check_joint_log(model, log);
  LoggedMotion motion;
  motion.sample_period = sampling_period(log);
  motion.jumps = position_jumps(model, log, thresholds);
  motion.velocities.resize(static_cast<std::size_t>(model.n()));
  const std::vector<UniformStretch> stretches = uniform_stretches(log, motion.jumps, thresholds);
  double slowest = motion.sample_period;
  for (const UniformStretch& stretch : stretches) slowest = std::max(slowest, stretch.period);
  motion.cutoff = std::min(cutoff, ParallelFilter::kHighestCutoff / slowest);
  for (const UniformStretch& stretch : stretches) {
    const double duration = static_cast<double>(stretch.q.rows() - 1) * stretch.period;
    // The windows of both filters have to fit; the first is four times as short as the second.
    if (duration < 2.6 * low_pass_half_length(motion.cutoff)) continue;
    MotionStretch part = filtered(model, stretch, log.has_velocities(), motion.cutoff, motion.torque_norm);
    if (!part.instants.empty()) motion.stretches.push_back(std::move(part));
  }
  if (motion.stretches.empty()) {
    throw InputError(
        InputPlace{log.source, 0, "time"},
        {fmt::format(
             "no part of the log without gaps and jumps is longer than the filters at {:.3g} Hz need; log "
             "longer, or check the time column",
             motion.cutoff),
         fmt::format("{} s", log.time.back() - log.time.front()),
         fmt::format("parts of at least {:.3g} s", 2.6 * low_pass_half_length(motion.cutoff))});
  }
  if (!log.has_velocities()) return motion;
  for (int j = 0; j < model.n(); ++j)
    motion.velocities[static_cast<std::size_t>(j)] = agreement(motion, j, model.n(), thresholds);
  for (MotionStretch& stretch : motion.stretches) {
    for (FilteredMotion& at : stretch.instants) {
      for (int j = 0; j < model.n(); ++j) {
        if (!motion.velocities[static_cast<std::size_t>(j)].used) continue;
        at.qd[j] = at.logged_velocity[j];
        at.qdd[j] = at.logged_velocity_d[j];
      }
    }
  }
  return motion;
}

}  // namespace armtune::internal

#include "tuner/identification/parallel_filter.hpp"

#include <algorithm>

namespace armtune::internal {
namespace {

/// Cutoff of the first filter, as a multiple of the second filter's cutoff.
constexpr double kWide = 4.0;
/// Largest cutoff of the first filter, as a share of the sampling rate.
constexpr double kWidest = 2.0 * ParallelFilter::kHighestCutoff;
/// Number of samples per second that are kept of a filtered signal, in units of the filter's cutoff. The
/// signal has no content above 1.5 times the cutoff.
constexpr double kRate = 4.0;

double wide_cutoff(double cutoff, double period) {
  return std::min(kWide * cutoff, kWidest * (1.0 / period));
}

int decimation(double cutoff, double period) {
  return std::max(1, static_cast<int>(1.0 / (kRate * cutoff * period)));
}

}  // namespace

ParallelFilter::ParallelFilter(int joints, bool velocities, double period, double cutoff, double torque_delay,
                               Eigen::Index columns)
    : joints_(joints),
      velocities_(velocities),
      period_(period),
      columns_(columns),
      motion_filter_(low_pass(wide_cutoff(cutoff, period), period)),
      torque_filter_(low_pass(wide_cutoff(cutoff, period), period, torque_delay)),
      motion_step_(decimation(wide_cutoff(cutoff, period), period)),
      row_filter_(low_pass(cutoff, period * motion_step_)),
      row_step_(decimation(cutoff, period * motion_step_)),
      motion_((velocities ? 3 : 2) * static_cast<Eigen::Index>(joints), motion_filter_.length(),
              motion_step_),
      rows_(columns, row_filter_.length(), row_step_),
      sample_((velocities ? 3 : 2) * static_cast<Eigen::Index>(joints)) {}

bool ParallelFilter::push(const JointVector& q, const JointVector& qd, const JointVector& torque) {
  sample_.head(joints_) = q;
  sample_.segment(joints_, joints_) = torque;
  if (velocities_) sample_.tail(joints_) = qd;
  return motion_.push(sample_);
}

FilteredMotion ParallelFilter::motion() const {
  const Eigen::Index n = joints_;
  FilteredMotion at;
  at.q = motion_.sum(motion_filter_.value, 0, n);
  at.qd = motion_.sum(motion_filter_.first, 0, n);
  at.qdd = motion_.sum(motion_filter_.second, 0, n);
  at.torque = motion_.sum(torque_filter_.value, n, n);
  if (velocities_) {
    at.logged_velocity = motion_.sum(motion_filter_.value, 2 * n, n);
    at.logged_velocity_d = motion_.sum(motion_filter_.first, 2 * n, n);
  }
  return at;
}

double ParallelFilter::torque_norm() const {
  // The second filter is applied to every motion_step_-th result of the first.
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(
      torque_filter_.length() + static_cast<Eigen::Index>(motion_step_) * 2 * row_filter_.half);
  for (Eigen::Index i = 0; i < row_filter_.value.size(); ++i)
    weights.segment(i * motion_step_, torque_filter_.value.size()) +=
        row_filter_.value[i] * torque_filter_.value;
  return weights.norm();
}

double ParallelFilter::longest_delay(double cutoff, double period) {
  return 0.1 * low_pass_half_length(wide_cutoff(cutoff, period));
}

}  // namespace armtune::internal

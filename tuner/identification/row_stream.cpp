#include "tuner/identification/row_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

/// Cutoff of the first filter, as a multiple of the second filter's cutoff.
constexpr double kWide = 4.0;
/// Largest cutoff of the first filter, as a share of the sampling rate.
constexpr double kWidest = 0.25;
/// Largest deviation from 1 of the regression of logged on differentiated velocity. The velocities of real
/// drives and sensors agree within a few percent. Those in degrees, with a wrong sign or from a wrong column
/// do not.
constexpr double kVelocityMismatch = 0.2;
/// The velocities of a joint slower than this [rad/s, m/s] (RMS) are not checked, because the differentiated
/// noise of the positions would affect the comparison.
constexpr double kSlow = 0.1;
/// Number of samples per second that are kept of a filtered signal, in units of the filter's cutoff. The
/// signal has no content above 1.5 times the cutoff.
constexpr double kRate = 4.0;
/// Number of columns that pass through the second filter in addition to the rows: position, velocity and
/// acceleration.
constexpr int kMotion = 3;
/// Longest time between samples that is likely in a controller's log [s].
constexpr double kSlowest = 0.05;

/// Returns a hint at the unit of the time stamps for which the log's period would be a likely one; empty if
/// there is none.
std::string time_unit_hint(double period) {
  struct Unit {
    double scale;
    const char* name;
  };
  for (const Unit& unit : {Unit{1e-3, "milliseconds"}, {1e-6, "microseconds"}, {1e-9, "nanoseconds"}}) {
    if (period < kSlowest || period * unit.scale > kSlowest) continue;
    return fmt::format(
        "; if the time stamps are in {}, set `time_scale: {}` in the column map (--columns FILE)", unit.name,
        unit.scale);
  }
  return "";
}

double checked(const RowOptions& options, const LogFile& log) {
  if (!(options.cutoff > 0.0))
    throw InputError(InputPlace{.key = "--cutoff"},
                     {.problem = fmt::format("the cutoff is {} Hz", options.cutoff),
                      .value = fmt::to_string(options.cutoff),
                      .limit = "above zero"});
  const double rate = 1.0 / log.period();
  if (2.0 * options.cutoff > kWidest * rate) {
    throw InputError(
        InputPlace{log.path()},
        fmt::format(
            "{:.4g} samples per second are too few for a cutoff of {} Hz; the cutoff may be at most {:.3g} "
            "Hz{}",
            rate, options.cutoff, 0.5 * kWidest * rate, time_unit_hint(log.period())))
        .with_value(fmt::to_string(options.cutoff),
                    fmt::format("a cutoff of at most {:.3g} Hz", 0.5 * kWidest * rate));
  }
  return std::min(kWide * options.cutoff, kWidest * rate);
}

int decimation(double cutoff, double period) {
  return std::max(1, static_cast<int>(1.0 / (kRate * cutoff * period)));
}

/// Returns the Euclidean norm of the weights of two filters in series. The second filter is applied to every
/// step-th result of the first.
double norm_of_both(const LowPass& first, const LowPass& second, int step) {
  Eigen::VectorXd weights =
      Eigen::VectorXd::Zero(first.length() + static_cast<Eigen::Index>(step) * 2 * second.half);
  for (Eigen::Index i = 0; i < second.value.size(); ++i)
    weights.segment(i * step, first.value.size()) += second.value[i] * first.value;
  return weights.norm();
}

/// Returns the number of values per sample: positions and torques, and velocities if the log has them.
Eigen::Index channels(const RobotModel& model, const LogFile& log) {
  return (log.has_velocities() ? 3 : 2) * static_cast<Eigen::Index>(model.n());
}

/// Returns the number of values that pass through the second filter: every joint's row of the regression, and
/// its motion.
Eigen::Index window_size(const RobotModel& model, const BaseParameters& base) {
  return static_cast<Eigen::Index>(model.n()) * (base.rank() + 1 + kMotion);
}

}  // namespace

RowStream::RowStream(const RobotModel& model, const BaseParameters& base, LogFile& log,
                     const RowOptions& options, LogInstants& instants)
    : model_(model),
      base_(base),
      log_(log),
      instants_(instants),
      period_(log.period()),
      motion_filter_(low_pass(checked(options, log), period_)),
      torque_filter_(low_pass(checked(options, log), period_, options.torque_delay)),
      motion_step_(decimation(checked(options, log), period_)),
      row_filter_(low_pass(options.cutoff, period_ * motion_step_)),
      row_step_(decimation(options.cutoff, period_ * motion_step_)),
      motion_(channels(model, log), motion_filter_.length(), motion_step_),
      rows_(window_size(model, base), row_filter_.length(), row_step_),
      velocity_products_(JointVector::Zero(model.n())),
      velocity_squares_(JointVector::Zero(model.n())) {
  const double longest = 0.1 * low_pass_half_length(checked(options, log));
  if (!(std::abs(options.torque_delay) <= longest)) {
    throw InputError(
        InputPlace{.key = "--torque-delay"},
        fmt::format("the delay is {} s; with this --cutoff it must lie between -{:.3g} and {:.3g} s",
                    options.torque_delay, longest, longest))
        .with_value(fmt::to_string(options.torque_delay),
                    fmt::format("-{:.3g} to {:.3g} s", longest, longest));
  }
  instants_.begin_log(norm_of_both(torque_filter_, row_filter_, motion_step_));
}

Eigen::VectorXd RowStream::regressor_rows() {
  const int n = model_.n();
  const JointVector q = motion_.sum(motion_filter_.value, 0, n);
  const JointVector qd = motion_.sum(motion_filter_.first, 0, n);
  const JointVector qdd = motion_.sum(motion_filter_.second, 0, n);
  const Eigen::VectorXd tau = motion_.sum(torque_filter_.value, n, n);
  if (log_.has_velocities()) compare_velocities(qd);
  forward_kinematics(model_.chain, q, poses_);
  slotine_li_forward(model_.chain, poses_, qd, qd, qdd, slotine_li_);
  slotine_li_regressor(model_.chain, poses_, slotine_li_, Y_);
  Eigen::MatrixXd rows(n, base_.rank() + 1 + kMotion);
  for (int b = 0; b < base_.rank(); ++b) rows.col(b) = Y_.col(base_.independent[static_cast<std::size_t>(b)]);
  rows.rightCols<1 + kMotion>() << tau, q, qd, qdd;
  return rows.reshaped();
}

void RowStream::compare_velocities(const JointVector& qd) {
  const int n = model_.n();
  const JointVector logged = motion_.sum(motion_filter_.value, 2 * static_cast<Eigen::Index>(n), n);
  velocity_products_ += logged.cwiseProduct(qd);
  velocity_squares_ += qd.cwiseAbs2();
  ++compared_;
}

void RowStream::check_velocities() const {
  for (int i = 0; i < model_.n() && compared_ > 0; ++i) {
    const double squares = velocity_squares_[i];
    if (squares < kSlow * kSlow * static_cast<double>(compared_)) continue;
    const double slope = velocity_products_[i] / squares;
    if (std::abs(slope - 1.0) < kVelocityMismatch) continue;
    const std::string& joint = model_.joints[static_cast<std::size_t>(i)].name;
    throw InputError(
        InputPlace{log_.path(), 0, joint + "/velocity"},
        fmt::format(
            "the velocity of {} is {:.3g} times the derivative of its position; check units, signs and "
            "columns, or leave the velocities out of the column map (--columns FILE)",
            joint, slope))
        .with_value(fmt::format("{:.3g}", slope), "1 times the derivative of the position");
  }
}

bool RowStream::next(Eigen::MatrixXd& rows) {
  const int n = model_.n();
  Eigen::VectorXd sample(channels(model_, log_));
  while (const auto logged = log_.next()) {
    ++samples_;
    instants_.add_logged_torque(logged->torque);
    sample << logged->q, logged->torque, logged->qd;
    if (!motion_.push(sample)) continue;
    if (!rows_.push(regressor_rows())) continue;
    const Eigen::MatrixXd all =
        rows_.sum(row_filter_.value, 0, window_size(model_, base_)).reshaped(n, base_.rank() + 1 + kMotion);
    rows = all.leftCols(base_.rank() + 1);
    const auto motion = all.rightCols<kMotion>();
    instants_.add({motion.col(0), motion.col(1), motion.col(2), rows.rightCols<1>()});
    return true;
  }
  return false;
}

}  // namespace armtune::internal

#include "tuner/identification/row_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

/// Largest deviation from 1 of the regression of logged on differentiated velocity. The velocities of real
/// drives and sensors agree within a few percent. Those in degrees, with a wrong sign or from a wrong column
/// do not.
constexpr double kVelocityMismatch = 0.2;
/// The velocities of a joint slower than this [rad/s, m/s] (RMS) are not checked, because the differentiated
/// noise of the positions would affect the comparison.
constexpr double kSlow = 0.1;
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

/// Returns the cutoff of the second filter [Hz]. Throws InputError if the options do not fit the log.
double checked(const RowOptions& options, const LogFile& log) {
  if (!(options.cutoff > 0.0))
    throw InputError(InputPlace{.key = "--cutoff"},
                     {.problem = fmt::format("the cutoff is {} Hz", options.cutoff),
                      .value = fmt::to_string(options.cutoff),
                      .limit = "above zero"});
  const double rate = 1.0 / log.period();
  if (options.cutoff > ParallelFilter::kHighestCutoff * rate) {
    throw InputError(
        InputPlace{log.path()},
        fmt::format(
            "{:.4g} samples per second are too few for a cutoff of {} Hz; the cutoff may be at most {:.3g} "
            "Hz{}",
            rate, options.cutoff, ParallelFilter::kHighestCutoff * rate, time_unit_hint(log.period())))
        .with_value(fmt::to_string(options.cutoff),
                    fmt::format("a cutoff of at most {:.3g} Hz", ParallelFilter::kHighestCutoff * rate));
  }
  const double longest = ParallelFilter::longest_delay(options.cutoff, log.period());
  if (!(std::abs(options.torque_delay) <= longest)) {
    throw InputError(
        InputPlace{.key = "--torque-delay"},
        fmt::format("the delay is {} s; with this --cutoff it must lie between -{:.3g} and {:.3g} s",
                    options.torque_delay, longest, longest))
        .with_value(fmt::to_string(options.torque_delay),
                    fmt::format("-{:.3g} to {:.3g} s", longest, longest));
  }
  return options.cutoff;
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
      filter_(model.n(), log.has_velocities(), log.period(), checked(options, log), options.torque_delay,
              window_size(model, base)),
      velocity_products_(JointVector::Zero(model.n())),
      velocity_squares_(JointVector::Zero(model.n())) {
  instants_.begin_log(filter_.torque_norm());
}

Eigen::VectorXd RowStream::regressor_rows() {
  const int n = model_.n();
  const FilteredMotion at = filter_.motion();
  if (log_.has_velocities()) compare_velocities(at);
  forward_kinematics(model_.chain, at.q, poses_);
  slotine_li_forward(model_.chain, poses_, at.qd, at.qd, at.qdd, slotine_li_);
  slotine_li_regressor(model_.chain, poses_, slotine_li_, Y_);
  Eigen::MatrixXd rows(n, base_.rank() + 1 + kMotion);
  for (int b = 0; b < base_.rank(); ++b) rows.col(b) = Y_.col(base_.independent[static_cast<std::size_t>(b)]);
  rows.rightCols<1 + kMotion>() << at.torque, at.q, at.qd, at.qdd;
  return rows.reshaped();
}

void RowStream::compare_velocities(const FilteredMotion& motion) {
  velocity_products_ += motion.logged_velocity.cwiseProduct(motion.qd);
  velocity_squares_ += motion.qd.cwiseAbs2();
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
  while (const auto logged = log_.next()) {
    ++samples_;
    instants_.add_logged_torque(logged->torque);
    if (!filter_.push(logged->q, logged->qd, logged->torque)) continue;
    if (!filter_.push_columns(regressor_rows())) continue;
    const Eigen::MatrixXd all = filter_.columns().reshaped(n, base_.rank() + 1 + kMotion);
    rows = all.leftCols(base_.rank() + 1);
    const auto motion = all.rightCols<kMotion>();
    instants_.add({motion.col(0), motion.col(1), motion.col(2), rows.rightCols<1>()});
    return true;
  }
  return false;
}

}  // namespace armtune::internal

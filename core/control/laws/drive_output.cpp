#include "core/control/laws/drive_output.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Rounding must not turn a whole number of periods into a part of one.
constexpr double kRounding = 1e-9;

}  // namespace

DriveOutput::DriveOutput(const RobotModel& model, double period) : effort_(model.effort_limits()) {
  if (model.drive_torque_rate.size() > 0) change_ = period * model.drive_torque_rate;
  if (model.drive_delay.size() == 0) return;
  part_ = JointVector::Zero(model.n());
  std::size_t longest = 0;
  for (int i = 0; i < model.n(); ++i) {
    const double periods = model.drive_delay[i] / period;
    const double whole = std::floor(periods + kRounding);
    if (periods - whole > kRounding) part_[i] = periods - whole;
    whole_[static_cast<std::size_t>(i)] = static_cast<std::size_t>(whole);
    longest = std::max(longest, static_cast<std::size_t>(whole));
  }
  line_.assign(longest + 2, JointVector::Zero(model.n()));
}

void DriveOutput::start(const JointVector& tau) {
  last_ = tau;
  std::fill(line_.begin(), line_.end(), tau);
}

void DriveOutput::pass(JointVector& tau) {
  if (change_.size() > 0) {
    last_ = last_.cwiseMax(-effort_).cwiseMin(effort_);
    tau = tau.cwiseMax(last_ - change_).cwiseMin(last_ + change_);
    last_ = tau;
  }
  if (line_.empty()) return;
  line_[next_] = tau;
  for (Eigen::Index i = 0; i < tau.size(); ++i) {
    const std::size_t newer = (next_ + line_.size() - whole_[static_cast<std::size_t>(i)]) % line_.size();
    const std::size_t older = (newer + line_.size() - 1) % line_.size();
    tau[i] = (1.0 - part_[i]) * line_[newer][i] + part_[i] * line_[older][i];
  }
  next_ = (next_ + 1) % line_.size();
}

}  // namespace armtune::internal

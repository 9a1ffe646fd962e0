#include "tuner/calibration/command_signal.hpp"

#include <algorithm>
#include <cmath>

#include "tuner/validation/motion_windows.hpp"

namespace armtune::internal {

CommandSignal::CommandSignal(const MotionCommands& commands) : period_(median_step(commands.time)) {
  std::vector<Eigen::RowVectorXd> rows;
  for (std::size_t i = 0; i < commands.time.size(); ++i) {
    const double t = commands.time[i];
    const Eigen::RowVectorXd row = commands.value.row(static_cast<Eigen::Index>(i));
    if (i > 0) {
      const double last = commands.time[i - 1];
      const Eigen::RowVectorXd before = commands.value.row(static_cast<Eigen::Index>(i - 1));
      const int parts = static_cast<int>(std::lround(std::min((t - last) / period_, 1e6)));
      for (int k = 1; k < parts && parts - 1 <= kMostLost; ++k) {
        const double share = static_cast<double>(k) / parts;
        time_.push_back(last + share * (t - last));
        rows.emplace_back((1.0 - share) * before + share * row);
      }
    }
    time_.push_back(t);
    rows.push_back(row);
  }
  command_.resize(static_cast<Eigen::Index>(rows.size()), commands.value.cols());
  integral_.setZero(command_.rows(), command_.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    command_.row(k) = rows[i];
    if (i > 0) integral_.row(k) = integral_.row(k - 1) + (time_[i] - time_[i - 1]) * command_.row(k - 1);
  }
}

/// Returns the index of the last command up to t; 0 before the first one.
std::size_t CommandSignal::index_at(double t) const {
  const auto next = std::upper_bound(time_.begin(), time_.end(), t);
  return next == time_.begin() ? 0 : static_cast<std::size_t>(next - time_.begin()) - 1;
}

Eigen::MatrixXd CommandSignal::means(double begin, double step, Eigen::Index steps, double delay) const {
  Eigen::MatrixXd means(steps, command_.cols());
  const double start = begin - delay;
  std::size_t at = index_at(start);
  const auto integral = [&](double t) -> Eigen::RowVectorXd {
    while (at + 1 < time_.size() && time_[at + 1] <= t) ++at;
    const auto k = static_cast<Eigen::Index>(at);
    return integral_.row(k) + (t - time_[at]) * command_.row(k);
  };
  Eigen::RowVectorXd last = integral(start);
  for (Eigen::Index i = 0; i < steps; ++i) {
    const Eigen::RowVectorXd next = integral(start + step * static_cast<double>(i + 1));
    means.row(i) = (next - last) / step;
    last = next;
  }
  return means;
}

Eigen::MatrixXd CommandSignal::interpolated(double begin, double step, Eigen::Index steps,
                                            double delay) const {
  Eigen::MatrixXd values(steps, command_.cols());
  for (Eigen::Index i = 0; i < steps; ++i) {
    const double t = begin - delay + step * static_cast<double>(i);
    const std::size_t at = std::min(index_at(t), time_.size() - 2);
    const auto k = static_cast<Eigen::Index>(at);
    const double share = std::clamp((t - time_[at]) / (time_[at + 1] - time_[at]), 0.0, 1.0);
    values.row(i) = (1.0 - share) * command_.row(k) + share * command_.row(k + 1);
  }
  return values;
}

}  // namespace armtune::internal

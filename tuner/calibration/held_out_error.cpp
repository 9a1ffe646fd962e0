#include "tuner/calibration/held_out_error.hpp"

#include <cmath>

namespace armtune::internal {
namespace {

/// Samples within this time of a horizon count for it [s].
constexpr double kNearHorizon = 0.02;

Eigen::Index samples_before(const ShotWindow& window, double time) {
  Eigen::Index count = 0;
  const auto since = [&](Eigen::Index i) {
    const std::size_t first = static_cast<std::size_t>(window.samples.first);
    return window.log->time[first + static_cast<std::size_t>(i)] - window.log->time[first];
  };
  while (count < window.samples.count && since(count) < time) ++count;
  return count;
}

/// Sums of squared errors at the horizons.
class ErrorSums {
 public:
  explicit ErrorSums(Eigen::Index n) {
    error_.rms.setZero(static_cast<Eigen::Index>(kReportedHorizons.size()), n);
  }

  void add(const ShotWindow& window, const Eigen::VectorXd& residual) {
    const Eigen::Index n = error_.rms.cols();
    for (std::size_t h = 0; h < kReportedHorizons.size(); ++h) {
      const double at = kStartTime + kReportedHorizons[h];
      const Eigen::Index first = samples_before(window, at - kNearHorizon);
      const Eigen::Index last = samples_before(window, at + kNearHorizon);
      if (last == first) continue;
      ++error_.windows[h];
      samples_[h] += static_cast<double>(last - first);
      for (Eigen::Index i = first; i < last; ++i)
        error_.rms.row(static_cast<Eigen::Index>(h)) += residual.segment(i * n, n).cwiseAbs2().transpose();
    }
  }

  HeldOutError error() const {
    HeldOutError found = error_;
    for (std::size_t h = 0; h < samples_.size(); ++h) {
      const auto row = static_cast<Eigen::Index>(h);
      found.rms.row(row) = (error_.rms.row(row) / samples_[h]).cwiseSqrt();
    }
    return found;
  }

 private:
  HeldOutError error_;
  std::array<double, kReportedHorizons.size()> samples_{};
};

}  // namespace

double HeldOutError::ratio_to(const HeldOutError& other, std::size_t horizon) const {
  const auto row = static_cast<Eigen::Index>(horizon);
  return std::sqrt(rms.row(row).cwiseQuotient(other.rms.row(row)).squaredNorm() /
                   static_cast<double>(rms.cols()));
}

HeldOutError horizon_error(const RobotModel& model, const ShootingArm& arm,
                           std::span<const CommandedLog> logs, const Eigen::VectorXd& noise,
                           HorizonPart part) {
  ErrorSums sums(model.n());
  for (const auto& [log, commands] : logs) {
    const CommandSignal signal(commands);
    WindowModel windows(model, arm, commands, {}, start_deviations(model, noise));
    WindowLengths lengths;
    lengths.fitted = lengths.block;
    const WindowPlan plan = window_plan(log, known_commands(commands), lengths);
    std::vector<LogWindow> places = plan.held_out;
    if (part == HorizonPart::kWhole) places.insert(places.end(), plan.fitted.begin(), plan.fitted.end());
    for (const LogWindow& place : places) {
      ShotWindow window = windows.window(log, signal, place, {}, true);
      fit_start(windows, window, samples_before(window, kStartTime), noise, {});
      sums.add(window, windows.residual(window, {}));
    }
  }
  return sums.error();
}

}  // namespace armtune::internal

#include "tuner/planning/transcription/trajectory.hpp"

#include <algorithm>
#include <utility>

#include "core/trajectory/linear_acceleration.hpp"

namespace armtune::internal {

TrajectoryPoint point_at(const Trajectory& trajectory, double t) {
  const auto& time = trajectory.time;
  t = std::clamp(t, time.front(), time.back());
  auto next = std::upper_bound(time.begin() + 1, time.end() - 1, t);
  const auto k = static_cast<Eigen::Index>(next - time.begin()) - 1;
  const double h = time[static_cast<std::size_t>(k) + 1] - time[static_cast<std::size_t>(k)];
  const double s = t - time[static_cast<std::size_t>(k)];
  const MotionPoint<Eigen::VectorXd> start{trajectory.position.col(k), trajectory.velocity.col(k),
                                           trajectory.acceleration.col(k)};
  const Eigen::VectorXd end_acceleration = trajectory.acceleration.col(k + 1);
  MotionPoint<Eigen::VectorXd> point = linear_acceleration(start, end_acceleration, h, s);
  return {std::move(point.position), std::move(point.velocity), std::move(point.acceleration)};
}

Trajectory on_grid(const Trajectory& trajectory, const TimeGrid& grid) {
  Trajectory fine;
  fine.durations = trajectory.durations;
  const Eigen::Index m = trajectory.position.rows();
  const Eigen::Index knots = grid.knots();
  fine.position.resize(m, knots);
  fine.velocity.resize(m, knots);
  fine.acceleration.resize(m, knots);
  double start = trajectory.time.front();
  Eigen::Index k = 0;
  for (std::size_t p = 0; p < grid.phases.size(); ++p) {
    const int intervals = grid.phases[p].intervals;
    for (int i = p == 0 ? 0 : 1; i <= intervals; ++i, ++k) {
      fine.time.push_back(start + fine.durations[p] * i / intervals);
      const TrajectoryPoint point = point_at(trajectory, fine.time.back());
      fine.position.col(k) = point.position;
      fine.velocity.col(k) = point.velocity;
      fine.acceleration.col(k) = point.acceleration;
    }
    start += fine.durations[p];
  }
  return fine;
}

Trajectory in_durations_of(const TimeGrid& grid, Trajectory trajectory) {
  const std::vector<double> was = trajectory.durations;
  trajectory.durations.clear();
  trajectory.time = {grid.start};
  double start = grid.start;
  Eigen::Index k = 0;
  for (std::size_t p = 0; p < grid.phases.size(); ++p) {
    const Phase& phase = grid.phases[p];
    const double slower = phase.duration / was[p];
    trajectory.durations.push_back(phase.duration);
    for (int i = 1; i <= phase.intervals; ++i) {
      trajectory.time.push_back(start + phase.duration * i / phase.intervals);
      trajectory.velocity.col(++k) /= slower;
      trajectory.acceleration.col(k) /= slower * slower;
    }
    start += phase.duration;
  }
  return trajectory;
}

void make_continuous(Trajectory& motion) {
  const Eigen::Index last = motion.position.cols() - 1;
  const Eigen::MatrixXd& q = motion.position;
  Eigen::MatrixXd& a = motion.acceleration;
  const auto h = [&](Eigen::Index k) {
    return motion.time[static_cast<std::size_t>(k) + 1] - motion.time[static_cast<std::size_t>(k)];
  };
  const auto slope = [&](Eigen::Index k) -> Eigen::VectorXd { return (q.col(k + 1) - q.col(k)) / h(k); };
  // The velocity is continuous at every knot: h- a-/6 + (h- + h) a/3 + h a+/6 = slope - slope-. The Thomas
  // algorithm solves these equations. Until then, `a` contains their right-hand sides.
  Eigen::VectorXd diagonal(last + 1);
  diagonal[0] = h(0) / 3.0;
  a.col(0) = slope(0) - motion.velocity.col(0);
  for (Eigen::Index k = 1; k <= last; ++k) {
    const double before = h(k - 1) / 6.0;
    const double factor = before / diagonal[k - 1];
    diagonal[k] = h(k - 1) / 3.0 + (k < last ? h(k) / 3.0 : 0.0) - factor * before;
    a.col(k) = (k < last ? slope(k) : Eigen::VectorXd(motion.velocity.col(k))) - slope(k - 1) -
               factor * a.col(k - 1);
  }
  a.col(last) /= diagonal[last];
  for (Eigen::Index k = last - 1; k >= 0; --k)
    a.col(k) = (a.col(k) - h(k) / 6.0 * a.col(k + 1)) / diagonal[k];
  for (Eigen::Index k = 0; k < last; ++k)
    motion.velocity.col(k + 1) = motion.velocity.col(k) + h(k) * (a.col(k) + a.col(k + 1)) / 2.0;
}

}  // namespace armtune::internal

#include "sim/metrics/goal_watch.hpp"

#include <algorithm>

namespace armtune::internal {
namespace {

constexpr int kInstants = 1000;  // at which the direction of the last way to the goal is looked for

}  // namespace

GoalWatch::GoalWatch(const JointSpline& plan, double tolerance)
    : goal_time_(plan.end()),
      goal_(plan.at(plan.end()).position),
      direction_(JointVector::Zero(goal_.size())),
      tolerance_(tolerance),
      settled_(plan.end()) {
  const double length = plan.end() - plan.begin();
  for (int k = kInstants; k >= 0 && (direction_.array() == 0.0).any(); --k) {
    const JointVector way = goal_ - plan.at(plan.begin() + length * k / kInstants).position;
    for (Eigen::Index i = 0; i < way.size(); ++i) {
      if (direction_[i] == 0.0 && std::abs(way[i]) > tolerance_) direction_[i] = way[i] > 0.0 ? 1.0 : -1.0;
    }
  }
}

void GoalWatch::add(double t, const JointVector& q) {
  if (t < goal_time_) return;
  const JointVector away = q - goal_;
  const bool outside = !(away.cwiseAbs().maxCoeff() <= tolerance_);
  if (outside_ && !outside) settled_ = t;
  outside_ = outside;
  seen_ = true;
  overshoot_ = std::max(overshoot_, away.cwiseProduct(direction_).maxCoeff());
}

void GoalWatch::write(double end, Metrics& m) const {
  if (!seen_) return;
  m[Metric::kGoalSettlingTime] = (outside_ ? end : settled_) - goal_time_;
  m[Metric::kGoalOvershoot] = overshoot_;
}

}  // namespace armtune::internal

#include "sim/rollout/limit_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Returns the unit of a joint's limit. turning: true for a revolute joint.
const char* unit(JointLimit limit, bool turning) {
  switch (limit) {
    case JointLimit::kVelocity:
      return turning ? "rad/s" : "m/s";
    case JointLimit::kPosition:
      return turning ? "rad" : "m";
    case JointLimit::kEffort:
      return turning ? "N m" : "N";
    case JointLimit::kAcceleration:
      return turning ? "rad/s^2" : "m/s^2";
  }
  return "";
}

}  // namespace

LimitWatch::LimitWatch(const RobotModel& model, double share)
    : joints_(joint_names(model)),
      share_(share),
      velocity_(share * model.velocity_limits()),
      lower_(model.lower_limits()),
      upper_(model.upper_limits()),
      effort_(share * model.effort_limits()),
      acceleration_(share * model.acceleration_limits()),
      last_velocity_(JointVector::Zero(model.n())) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    turning_.push_back(model.chain.motion[i] == JointMotion::kRevolute);
  }
}

void LimitWatch::note(JointLimit limit, Eigen::Index joint, double time, double value, double bound) {
  Found& found = found_[static_cast<std::size_t>(limit)];
  if (found.joint < 0) found = {static_cast<int>(joint), time, value, bound};
}

void LimitWatch::look(const Observation& o) {
  o.each_instant([this](double time, const JointVector& q, const JointVector& qd, const JointVector& effort,
                        const JointVector&) { look(time, q, qd, effort); });
}

void LimitWatch::look(double time, const JointVector& q, const JointVector& qd, const JointVector& effort) {
  const double rate = first_ ? 0.0 : 1.0 / (time - last_time_);
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (std::abs(qd[i]) > velocity_[i]) {
      note(JointLimit::kVelocity, i, time, qd[i], std::copysign(velocity_[i], qd[i]));
    }
    if (q[i] > upper_[i]) note(JointLimit::kPosition, i, time, q[i], upper_[i]);
    if (q[i] < lower_[i]) note(JointLimit::kPosition, i, time, q[i], lower_[i]);
    if (std::abs(effort[i]) > effort_[i]) {
      note(JointLimit::kEffort, i, time, effort[i], std::copysign(effort_[i], effort[i]));
    }
    const double acceleration = (qd[i] - last_velocity_[i]) * rate;
    if (std::abs(acceleration) > acceleration_[i]) {
      note(JointLimit::kAcceleration, i, time, acceleration, std::copysign(acceleration_[i], acceleration));
    }
    last_velocity_[i] = qd[i];
  }
  last_time_ = time;
  first_ = false;
}

std::vector<BrokenLimit> LimitWatch::broken() const {
  std::vector<BrokenLimit> all;
  for (const JointLimit limit : kJointLimits) {
    const Found& found = found_[static_cast<std::size_t>(limit)];
    if (found.joint < 0) continue;
    const auto joint = static_cast<std::size_t>(found.joint);
    all.push_back({limit, joints_[joint], found.time, found.value, found.bound, unit(limit, turning_[joint]),
                   limit == JointLimit::kPosition ? 1.0 : share_});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const BrokenLimit& a, const BrokenLimit& b) { return a.time < b.time; });
  return all;
}

std::string to_string(const BrokenLimit& broken) {
  const char* what = broken.limit == JointLimit::kVelocity       ? "moves at"
                     : broken.limit == JointLimit::kPosition     ? "is at"
                     : broken.limit == JointLimit::kAcceleration ? "accelerates at"
                                                                 : "is commanded";
  const std::string part = broken.share < 1.0 ? fmt::format("{:.2g} of ", broken.share) : std::string();
  return fmt::format("{} {} {:.4g} {}, beyond {}its {} of {:.4g}, at {:.3f} s", broken.joint, what,
                     broken.value, broken.unit, part, name(broken.limit), broken.bound / broken.share,
                     broken.time);
}

}  // namespace armtune::internal

#pragma once
// Checks in every control period whether a joint exceeds a velocity, position, effort or acceleration limit.
// For each kind of limit it records the first time, the joint and the value.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/metrics/observation.hpp"

namespace armtune::internal {

/// The kinds of limits of a joint. A URDF gives all of them except the acceleration limit, which only a robot
/// YAML can give.
enum class JointLimit : std::size_t { kVelocity, kPosition, kEffort, kAcceleration };
inline constexpr std::array kJointLimits = {JointLimit::kVelocity, JointLimit::kPosition, JointLimit::kEffort,
                                            JointLimit::kAcceleration};

constexpr const char* name(JointLimit limit) {
  switch (limit) {
    case JointLimit::kVelocity:
      return "velocity limit";
    case JointLimit::kPosition:
      return "position limit";
    case JointLimit::kEffort:
      return "effort limit";
    case JointLimit::kAcceleration:
      return "acceleration limit";
  }
  return "";
}

/// The first period in which a joint exceeded a limit of one kind.
struct BrokenLimit {
  JointLimit limit = JointLimit::kVelocity;
  std::string joint;
  double time = 0.0;      ///< [s]
  double value = 0.0;     ///< true velocity, position or acceleration, or commanded effort, in `unit`
  double bound = 0.0;     ///< limit times share, with the sign of the side that was exceeded
  std::string unit = {};  ///< of value and bound
  double share = 1.0;     ///< allowed fraction of the limit
};

class LimitWatch {
 public:
  /// model: the arm that is observed; no reference to it is kept. share: the velocity, effort and
  /// acceleration limits count as exceeded above this fraction of them. It does not apply to position limits.
  explicit LimitWatch(const RobotModel& model, double share = 1.0);

  /// Checks one control period. Call it once per period. Allocates nothing.
  void look(const Observation& o);

  /// Returns true if any limit has been exceeded.
  bool any() const {
    return std::any_of(found_.begin(), found_.end(), [](const Found& found) { return found.joint >= 0; });
  }
  /// Returns the limits that were exceeded, the earliest first.
  std::vector<BrokenLimit> broken() const;

 private:
  void look(double time, const JointVector& q, const JointVector& qd, const JointVector& effort);

  struct Found {
    int joint = -1;
    double time = 0.0;
    double value = 0.0;
    double bound = 0.0;
  };
  void note(JointLimit limit, Eigen::Index joint, double time, double value, double bound);

  std::vector<std::string> joints_;
  std::vector<bool> turning_;  ///< true for revolute joints, false for prismatic ones
  double share_;
  JointVector velocity_, lower_, upper_, effort_, acceleration_;
  JointVector last_velocity_;
  double last_time_ = 0.0;
  bool first_ = true;
  std::array<Found, kJointLimits.size()> found_;
};

/// Returns, for example, "wrist_1_joint is commanded 94.1 N m, beyond its effort limit of 56, at 527.300 s".
std::string to_string(const BrokenLimit& broken);

}  // namespace armtune::internal

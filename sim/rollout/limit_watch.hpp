#pragma once
// Watches the joints of a rollout and remembers when each of the arm's own limits was passed first.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/metrics/observation.hpp"

namespace armtune::internal {

/// The limits that a URDF gives a joint.
enum class JointLimit : std::size_t { kVelocity, kPosition, kEffort };
inline constexpr std::array kJointLimits = {JointLimit::kVelocity, JointLimit::kPosition,
                                            JointLimit::kEffort};

constexpr const char* name(JointLimit limit) {
  switch (limit) {
    case JointLimit::kVelocity:
      return "velocity limit";
    case JointLimit::kPosition:
      return "position limit";
    case JointLimit::kEffort:
      return "effort limit";
  }
  return "";
}

/// The first period in which a joint passed one of its limits.
struct BrokenLimit {
  JointLimit limit = JointLimit::kVelocity;
  std::string joint;
  double time = 0.0;   ///< [s]
  double value = 0.0;  ///< what passed it: true velocity or position, commanded effort, in the URDF's units
  double bound = 0.0;  ///< the limit, or its share, with the sign of the side that was passed
  std::string unit = {};  ///< of both
  double share = 1.0;     ///< of the limit, that was asked to be kept
};

class LimitWatch {
 public:
  /// model: of the arm that is observed; it is not referred to afterwards. share: of the velocity and effort
  /// limits, beyond which they count as passed; position limits count whole.
  explicit LimitWatch(const RobotModel& model, double share = 1.0);

  /// To be called once per control period. Allocates nothing.
  void look(const Observation& o);

  /// True once any limit was passed.
  bool any() const { return found_[0].joint >= 0 || found_[1].joint >= 0 || found_[2].joint >= 0; }
  /// Every limit that was passed, the earliest first.
  std::vector<BrokenLimit> broken() const;

 private:
  struct Found {
    int joint = -1;
    double time = 0.0;
    double value = 0.0;
    double bound = 0.0;
  };
  void note(JointLimit limit, Eigen::Index joint, double time, double value, double bound);

  std::vector<std::string> joints_;
  std::vector<bool> turning_;  ///< revolute joints, not prismatic ones
  double share_;
  JointVector velocity_, lower_, upper_, effort_;
  std::array<Found, kJointLimits.size()> found_;
};

/// Returns, for example, "wrist_1_joint is commanded 94.1 N m, beyond its effort limit of 56, at 527.300 s".
std::string to_string(const BrokenLimit& broken);

}  // namespace armtune::internal

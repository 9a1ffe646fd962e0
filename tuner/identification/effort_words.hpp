#pragma once
// Gives the name and the units of a joint's effort for messages. The effort of a revolute joint is a torque,
// that of a sliding joint is a force.

#include <algorithm>
#include <cstddef>
#include <string>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

struct EffortWords {
  const char* name = "torque";
  const char* unit = "N m";
  const char* thousandth = "N mm";  ///< a thousandth of the unit
  const char* thousandfold = "kN m";
};

/// The words of a sliding joint.
constexpr EffortWords kForceWords = {"force", "N", "mN", "kN"};

/// Returns the words for one joint.
inline EffortWords effort_words(const RobotModel& model, int joint) {
  const bool turns = model.chain.motion[static_cast<std::size_t>(joint)] == JointMotion::kRevolute;
  return turns ? EffortWords() : kForceWords;
}

/// Returns a word for all joints of the arm together: "torque", "force", or "torque or force".
inline std::string effort_word_of_all(const RobotModel& model, const char* EffortWords::*word) {
  const auto& motion = model.chain.motion;
  const auto turning = std::count(motion.begin(), motion.end(), JointMotion::kRevolute);
  if (turning == 0) return kForceWords.*word;
  if (turning == static_cast<std::ptrdiff_t>(motion.size())) return EffortWords().*word;
  return std::string(EffortWords().*word) + " or " + kForceWords.*word;
}

}  // namespace armtune::internal

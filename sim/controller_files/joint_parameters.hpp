#pragma once
// Where a joint trajectory controller's parameter file has what belongs to a joint.

#include <array>
#include <string>

#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {

/// What a file calls the gains of a joint, within its map. Ours are jtc_name of these.
inline constexpr std::array kGainNames = {"p", "i", "d"};

class JointParameters {
 public:
  /// Both outlive it.
  JointParameters(const RosController& controller, const std::string& file)
      : controller_(controller), file_(file) {}

  const RosController& controller() const { return controller_; }

  /// Throws InputError "FILE:LINE: CONTROLLER: what".
  [[noreturn]] void fail(int line, const std::string& what) const;

  /// What the file has of a joint, at `key`; null: nothing.
  const yaml::PlacedValue* of_joint(const std::string& joint, const char* key) const;

  /// The factor on the desired velocity, which ROS 1 has in a map of its own; null: none.
  const yaml::PlacedValue* feed_forward(const std::string& joint) const;

 private:
  const RosController& controller_;
  const std::string& file_;
};

}  // namespace armtune::internal

#pragma once
// A robot arm: its links, joints and limits.

#include <memory>
#include <string>
#include <vector>

namespace armtune {

namespace internal {
struct RobotModel;
}

/// A serial arm of n joints. Copies share one immutable model.
class Robot {
 public:
  /// Reads a bundled robot by name, or a robot file (YAML) or URDF by path. Throws InputError.
  static Robot load(const std::string& name_or_path);

  const std::string& name() const;
  /// Returns the names of the n joints, from the base to the tool. Every joint vector has this order.
  std::vector<std::string> joints() const;
  /// Returns the limits of the n joints. Position limits of joints that turn endlessly are infinite.
  std::vector<double> velocity_limits() const;        ///< [rad/s, m/s]
  std::vector<double> effort_limits() const;          ///< [N m, N]
  std::vector<double> lower_position_limits() const;  ///< [rad, m]
  std::vector<double> upper_position_limits() const;  ///< [rad, m]

  /// For armtune's own code.
  explicit Robot(std::shared_ptr<const internal::RobotModel> model) : model_(std::move(model)) {}
  const std::shared_ptr<const internal::RobotModel>& model() const { return model_; }

 private:
  std::shared_ptr<const internal::RobotModel> model_;
};

}  // namespace armtune

#pragma once
// An arm: links, joints and limits.

#include <memory>
#include <string>
#include <vector>

namespace armtune {

namespace internal {
struct RobotModel;
}

/// A serial arm of n joints. Copies share one model that never changes.
class Robot {
 public:
  /// Reads a bundled robot by name, or a robot file (YAML) or URDF by path. Throws InputError.
  static Robot load(const std::string& name_or_path);

  const std::string& name() const;
  /// Names of the n joints, from the base to the tool: the order of every joint vector.
  std::vector<std::string> joints() const;
  /// Limits of the n joints. Those of positions are infinite for joints that turn without end.
  std::vector<double> velocity_limits() const;        ///< [rad/s, m/s]
  std::vector<double> effort_limits() const;          ///< [N m, N]
  std::vector<double> lower_position_limits() const;  ///< [rad, m]
  std::vector<double> upper_position_limits() const;  ///< [rad, m]

  /// For armtune itself.
  explicit Robot(std::shared_ptr<const internal::RobotModel> model) : model_(std::move(model)) {}
  const std::shared_ptr<const internal::RobotModel>& model() const { return model_; }

 private:
  std::shared_ptr<const internal::RobotModel> model_;
};

}  // namespace armtune

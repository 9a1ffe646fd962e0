#include <algorithm>
#include <limits>
#include <optional>

#include "core/control/laws/controller.hpp"
#include "core/robot/theta.hpp"
#include "tuner/validation/command_follower.hpp"
#include "tuner/validation/motion_windows.hpp"

namespace armtune::internal {
namespace {

class ControllerFollower final : public CommandFollower {
 public:
  ControllerFollower(const RobotModel& model, const MotionCommands& commands)
      : model_(std::make_shared<RobotModel>(model)),
        theta_(theta_of(model.chain)),
        commands_(commands),
        period_(commands.control_period > 0.0 ? commands.control_period : median_step(commands.time)),
        timing_{drive_frequency(model, 0.0), 0} {
    scene_.holds_plan = true;
    make_controller();
    drive_steps_ = controller_->drive_steps();
    held_ = steps_in(period_ / drive_steps_, kDriveFrequency);
  }

  double step() const override { return period_ / (drive_steps_ * held_); }

  void start(const ArmStart& from) override {
    plan_.emplace(reference_from(from.time));
    scene_.plan = &*plan_;
    make_controller();
  }

  void torque(long k, const JointVector& q, const JointVector& qd, JointVector& tau) override {
    const long drive_period = k / held_;
    if (k % held_ == 0) {
      measured_ = {q, qd};
      if (drive_period % drive_steps_ == 0) {
        const double time = static_cast<double>(drive_period / drive_steps_) * period_;
        torque_ = controller_->update(measured_, scene_, time).torque;
      } else {
        controller_->drive(measured_, before_limits_, torque_);
      }
    }
    tau = torque_;
  }

 private:
  void make_controller() {
    controller_.emplace(model_, *commands_.gains, theta_, period_, TaskMask::kPose, timing_);
  }

  /// Returns the reference from the last sample at or before `begin` to the end of the longest window, over
  /// time since begin. Its points are connected as the trajectories of ROS.
  JointSpline reference_from(double begin) const {
    const std::vector<double>& all = commands_.time;
    const auto next = std::upper_bound(all.begin(), all.end(), begin);
    const auto first = static_cast<Eigen::Index>(next - all.begin()) - (next == all.begin() ? 0 : 1);
    const bool fast = commands_.velocity.size() > 0;
    std::vector<double> time;
    std::vector<MotionPoint<JointVector>> points;
    for (auto i = first; i < static_cast<Eigen::Index>(all.size()); ++i) {
      time.push_back(all[static_cast<std::size_t>(i)] - begin);
      const JointVector rate = fast ? JointVector(commands_.velocity.row(i)) : JointVector::Zero(model_->n());
      points.push_back({commands_.value.row(i).transpose(), rate, JointVector::Zero(model_->n())});
      if (time.size() > 1 && time.back() > kLongestWindow) break;
    }
    if (time.size() < 2) {  // the window begins at the last reference, which is held
      time.push_back(time.back() + kLongestWindow);
      points.push_back(points.back());
    }
    return {std::move(time), std::move(points), fast ? PointsGive::kVelocities : PointsGive::kPositions};
  }

  std::shared_ptr<const RobotModel> model_;
  ParameterVector theta_;
  const MotionCommands& commands_;
  double period_;
  DriveTiming timing_;
  int drive_steps_ = 1;
  int held_ = 1;  ///< steps for which a torque is held
  std::optional<JointSpline> plan_;
  Scene scene_;
  std::optional<Controller> controller_;
  JointState measured_;
  JointVector before_limits_, torque_;
};

}  // namespace

std::unique_ptr<CommandFollower> make_controller_follower(const RobotModel& model,
                                                          const MotionCommands& commands) {
  return std::make_unique<ControllerFollower>(model, commands);
}

}  // namespace armtune::internal

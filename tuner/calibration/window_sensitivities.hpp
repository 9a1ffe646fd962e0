#pragma once
// The residuals of a window, and their derivatives by the parameters of the arm and by the state at the
// window's start. Parameters and states are standardised: under their priors, each has mean 0 and standard
// deviation 1.

#include "tuner/calibration/calibration_parameters.hpp"
#include "tuner/calibration/start_states.hpp"

namespace armtune::internal {

/// A window of a log, and the state at its start. Log and signal must outlive it.
struct ShotWindow {
  const JointLog* log = nullptr;
  const CommandSignal* signal = nullptr;
  LogWindow samples;
  StartState start;  ///< as the log shows it
  Eigen::VectorXd
      deviation;  ///< of the fitted state from it, standardised: q, q' and, with drives, the integrals
};

struct Sensitivities {
  Eigen::VectorXd residual;       ///< predicted minus logged positions, sample by sample [rad, m]
  Eigen::MatrixXd by_parameters;  ///< as many columns as parameters; empty if they were not asked for
  Eigen::MatrixXd by_start;       ///< as many columns as entries of the state
};

class WindowModel {
 public:
  /// model: the robot file, whose weight the robot itself may hold. arm: has the values of what is not a
  /// parameter.
  WindowModel(const RobotModel& model, const ShootingArm& arm, const MotionCommands& commands,
              std::vector<CalibrationParameter> parameters, const StartState& deviations);

  const std::vector<CalibrationParameter>& parameters() const { return parameters_; }
  int joints() const { return nominal_.model.n(); }
  /// Number of entries of the state at a window's start.
  int start_size() const { return start_size_; }

  /// Returns the window with the state that the log shows at its start; see logged_start().
  ShotWindow window(const JointLog& log, const CommandSignal& signal, const LogWindow& samples,
                    const Eigen::VectorXd& z, bool only_after) const;

  /// Returns the residuals of an arm with the parameters z.
  Eigen::VectorXd residual(const ShotWindow& window, const Eigen::VectorXd& z);
  /// Returns the residuals and their derivatives by the start state and, if wanted, by the parameters.
  Sensitivities sensitivities(const ShotWindow& window, const Eigen::VectorXd& z, bool by_parameters);

 private:
  StartState start_of(const ShotWindow& window, const Eigen::VectorXd& deviation) const;

  CommandKind kind_;
  ShootingArm nominal_;
  std::vector<CalibrationParameter> parameters_;
  StartState deviations_;
  int start_size_;
  Shooting shooting_;
};

}  // namespace armtune::internal

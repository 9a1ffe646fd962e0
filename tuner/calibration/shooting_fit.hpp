#pragma once
// Fits the parameters of an arm to windows of logs by multiple shooting: parameters and the states at the
// windows' starts are free, and the positions that the arm reaches in each window are compared with the
// encoders. It is a Gauss-Newton method with the damping of Levenberg and Marquardt. The states are
// eliminated window by window (Schur complement). Bock, Randwertproblemmethoden zur Parameteridentifizierung,
// 1987. Outliers are weighted down (Huber).

#include <atomic>
#include <functional>

#include "tuner/calibration/window_sensitivities.hpp"

namespace armtune::internal {

struct ShootingFit {
  Eigen::VectorXd z;           ///< fitted parameters, standardised
  Eigen::MatrixXd covariance;  ///< of z (window_covariance.hpp)
  Eigen::VectorXd scale;       ///< of the residuals of each joint, relative to the encoder noise (n)
  double objective = 0.0;
  int iterations = 0;
  bool converged = false;
};

struct ShootingFitOptions {
  int most_iterations = 40;
  /// Decrease of the objective below which the fit ends. The objective is a negative log-likelihood, so that
  /// a decrease of 0.5 belongs to a step of one standard deviation.
  double tolerance = 0.005;
  bool with_covariance = true;
  std::function<void(int iteration, double objective)> progress;
  const std::atomic<bool>* stop = nullptr;  ///< true: the fit ends soon and has not converged
};

/// Fits parameters from z on, and the states of the windows. noise (n): of the encoders [rad, m].
ShootingFit fit_windows(WindowModel& model, std::vector<ShotWindow>& windows, const Eigen::VectorXd& noise,
                        const Eigen::VectorXd& z, const ShootingFitOptions& options);

/// Fits only the state at the start of a window, to its first `count` samples. The parameters keep the values
/// z.
void fit_start(WindowModel& model, ShotWindow& window, Eigen::Index count, const Eigen::VectorXd& noise,
               const Eigen::VectorXd& z);

}  // namespace armtune::internal

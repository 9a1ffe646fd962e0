#include "tuner/calibration/shooting_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "tuner/calibration/window_covariance.hpp"

namespace armtune::internal {
namespace {

/// Residuals of more than this many standard deviations count as outliers (Huber, with 95 % efficiency).
constexpr double kHuber = 1.345;
constexpr double kDeviationPerMedian = 1.4826;

/// Returns a column of standard deviations for the residuals of a window, sample by sample.
Eigen::VectorXd repeated(const Eigen::VectorXd& of_joint, Eigen::Index samples) {
  return of_joint.replicate(samples, 1);
}

double huber_loss(const Eigen::VectorXd& u) {
  const Eigen::ArrayXd size = u.array().abs();
  return (size <= kHuber).select(0.5 * size.square(), kHuber * (size - 0.5 * kHuber)).sum();
}

/// Returns the square roots of Huber's weights.
Eigen::VectorXd root_weights(const Eigen::VectorXd& u) {
  return (kHuber / u.array().abs().max(kHuber)).sqrt();
}

/// The normal equations of one window.
struct WindowEquations {
  Eigen::LLT<Eigen::MatrixXd> of_start;
  Eigen::MatrixXd cross;  ///< start x parameters
  Eigen::VectorXd start_gradient;
  WindowInformation parameters;  ///< after the state is eliminated
};

class ShootingProblem {
 public:
  ShootingProblem(WindowModel& model, std::vector<ShotWindow>& windows, const Eigen::VectorXd& noise,
                  const std::atomic<bool>* stop)
      : model_(model), windows_(windows), noise_(noise), equations_(windows.size()), stop_(stop) {
    scale_ = Eigen::VectorXd::Ones(model.joints());
  }

  const Eigen::VectorXd& scale() const { return scale_; }
  bool stopped() const { return stop_ != nullptr && *stop_; }

  /// Returns the robust scale of the residuals of each joint, relative to the noise, at least 1.
  void rescale(const std::vector<Eigen::VectorXd>& residuals) {
    const Eigen::Index n = model_.joints();
    for (Eigen::Index j = 0; j < n; ++j) {
      std::vector<double> sizes;
      for (const Eigen::VectorXd& r : residuals)
        for (Eigen::Index i = j; i < r.size(); i += n) sizes.push_back(std::abs(r[i]) / noise_[j]);
      const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
      std::nth_element(sizes.begin(), middle, sizes.end());
      scale_[j] = std::max(1.0, kDeviationPerMedian * *middle);
    }
  }

  std::vector<Eigen::VectorXd> residuals(const Eigen::VectorXd& z) const {
    std::vector<Eigen::VectorXd> all;
    for (const ShotWindow& window : windows_) all.push_back(model_.residual(window, z));
    return all;
  }

  double objective(const std::vector<Eigen::VectorXd>& residuals, const Eigen::VectorXd& z) const {
    double sum = 0.5 * z.squaredNorm();
    for (std::size_t w = 0; w < windows_.size(); ++w)
      sum += huber_loss(standardised(residuals[w])) + 0.5 * windows_[w].deviation.squaredNorm();
    return sum;
  }

  /// Computes the normal equations at z: H dz = -g after the states are eliminated. The priors are included.
  /// The equations are not complete if the fit is stopped.
  void linearise(const Eigen::VectorXd& z, Eigen::MatrixXd& H, Eigen::VectorXd& g) {
    H.setIdentity(z.size(), z.size());
    g = z;
    for (std::size_t w = 0; w < windows_.size() && !stopped(); ++w) {
      const Sensitivities s = model_.sensitivities(windows_[w], z, true);
      Eigen::VectorXd u;
      Eigen::MatrixXd J;
      Eigen::MatrixXd K;
      weigh(s, u, J, K);
      WindowEquations& e = equations_[w];
      Eigen::MatrixXd start = K.transpose() * K;
      start.diagonal().array() += 1.0;
      e.of_start.compute(start);
      e.cross = K.transpose() * J;
      e.start_gradient = K.transpose() * u + windows_[w].deviation;
      e.parameters.information = J.transpose() * J - e.cross.transpose() * e.of_start.solve(e.cross);
      e.parameters.score = J.transpose() * u - e.cross.transpose() * e.of_start.solve(e.start_gradient);
      H += e.parameters.information;
      g += e.parameters.score;
    }
  }

  /// Returns the covariance of z at the solution.
  Eigen::MatrixXd covariance(const Eigen::VectorXd& z) {
    Eigen::MatrixXd H;
    Eigen::VectorXd g;
    linearise(z, H, g);
    std::vector<WindowInformation> parts;
    for (const WindowEquations& e : equations_) parts.push_back(e.parameters);
    return window_covariance(parts);
  }

  /// Moves the states of the windows along with the parameters.
  void move_starts(const Eigen::VectorXd& dz) {
    for (std::size_t w = 0; w < windows_.size(); ++w) {
      const WindowEquations& e = equations_[w];
      windows_[w].deviation -= e.of_start.solve(e.start_gradient + e.cross * dz);
    }
  }

  std::vector<Eigen::VectorXd> starts() const {
    std::vector<Eigen::VectorXd> all;
    for (const ShotWindow& window : windows_) all.push_back(window.deviation);
    return all;
  }
  void restore(const std::vector<Eigen::VectorXd>& starts) {
    for (std::size_t w = 0; w < windows_.size(); ++w) windows_[w].deviation = starts[w];
  }

 private:
  Eigen::VectorXd standardised(const Eigen::VectorXd& residual) const {
    return residual.cwiseQuotient(repeated(noise_.cwiseProduct(scale_), residual.size() / noise_.size()));
  }

  void weigh(const Sensitivities& s, Eigen::VectorXd& u, Eigen::MatrixXd& J, Eigen::MatrixXd& K) const {
    u = standardised(s.residual);
    const Eigen::VectorXd root = root_weights(u);
    const Eigen::VectorXd factor =
        root.cwiseQuotient(repeated(noise_.cwiseProduct(scale_), u.size() / noise_.size()));
    u = u.cwiseProduct(root);
    J = factor.asDiagonal() * s.by_parameters;
    K = factor.asDiagonal() * s.by_start;
  }

  WindowModel& model_;
  std::vector<ShotWindow>& windows_;
  Eigen::VectorXd noise_;
  Eigen::VectorXd scale_;
  std::vector<WindowEquations> equations_;
  const std::atomic<bool>* stop_;
};

}  // namespace

ShootingFit fit_windows(WindowModel& model, std::vector<ShotWindow>& windows, const Eigen::VectorXd& noise,
                        const Eigen::VectorXd& z, const ShootingFitOptions& options) {
  ShootingProblem problem(model, windows, noise, options.stop);
  ShootingFit fit;
  fit.z = z;
  std::vector<Eigen::VectorXd> residuals = problem.residuals(fit.z);
  problem.rescale(residuals);
  double damping = 1e-3;
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
  while (fit.iterations < options.most_iterations && !fit.converged) {
    const double before = problem.objective(residuals, fit.z);
    problem.linearise(fit.z, H, g);
    if (problem.stopped()) break;
    const std::vector<Eigen::VectorXd> starts = problem.starts();
    bool better = false;
    for (int attempt = 0; attempt < 8 && !better; ++attempt) {
      Eigen::MatrixXd damped = H;
      damped.diagonal() *= 1.0 + damping;
      const Eigen::VectorXd dz = -damped.llt().solve(g);
      problem.move_starts(dz);
      const std::vector<Eigen::VectorXd> tried = problem.residuals(fit.z + dz);
      fit.objective = problem.objective(tried, fit.z + dz);
      better = fit.objective < before;
      if (better) {
        fit.z += dz;
        residuals = tried;
        damping = std::max(1e-9, 0.1 * damping);
      } else {
        problem.restore(starts);
        damping *= 10.0;
      }
    }
    ++fit.iterations;
    const Eigen::VectorXd scale = problem.scale();
    fit.converged = !better || before - fit.objective < options.tolerance;
    problem.rescale(residuals);
    // A smaller scale gives the residuals more weight, so the fit continues.
    if (better && ((scale - problem.scale()).array() > 0.02 * scale.array()).any()) fit.converged = false;
    if (options.progress) options.progress(fit.iterations, fit.objective);
  }
  fit.scale = problem.scale();
  if (options.with_covariance && !problem.stopped()) fit.covariance = problem.covariance(fit.z);
  return fit;
}

void fit_start(WindowModel& model, ShotWindow& window, Eigen::Index count, const Eigen::VectorXd& noise,
               const Eigen::VectorXd& z) {
  ShotWindow beginning = window;
  beginning.samples.count = count;
  const Eigen::VectorXd deviation = repeated(noise, count);
  for (int iteration = 0; iteration < 4; ++iteration) {
    const Sensitivities s = model.sensitivities(beginning, z, false);
    Eigen::VectorXd u = s.residual.cwiseQuotient(deviation);
    const Eigen::VectorXd root = root_weights(u);
    u = u.cwiseProduct(root);
    const Eigen::MatrixXd K = root.cwiseQuotient(deviation).asDiagonal() * s.by_start;
    Eigen::MatrixXd H = K.transpose() * K;
    H.diagonal().array() += 1.0;
    beginning.deviation -= H.llt().solve(K.transpose() * u + beginning.deviation);
  }
  window.deviation = beginning.deviation;
}

}  // namespace armtune::internal

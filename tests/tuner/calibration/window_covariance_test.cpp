#include "tuner/calibration/window_covariance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

namespace armtune::internal::window_covariance_test {
namespace {

constexpr int kWindows = 30;
constexpr int kSamples = 20;

/// Windows of a linear fit of two parameters, whose true values are zero. The residuals of a window have a
/// common part.
struct LinearFit {
  std::vector<WindowInformation> windows;
  Eigen::Vector2d solution;

  LinearFit(unsigned seed, double common) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    std::vector<Eigen::MatrixXd> J;
    std::vector<Eigen::VectorXd> u;
    Eigen::Matrix2d H = Eigen::Matrix2d::Identity();
    Eigen::Vector2d g = Eigen::Vector2d::Zero();
    for (int w = 0; w < kWindows; ++w) {
      J.emplace_back(kSamples, 2);
      u.emplace_back(kSamples);
      const double shared = common * normal(generator);
      const double slope = 1.0 + 0.3 * normal(generator);
      for (int i = 0; i < kSamples; ++i) {
        J.back().row(i) << slope, normal(generator);
        u.back()[i] = shared + normal(generator);
      }
      H += J.back().transpose() * J.back();
      g += J.back().transpose() * u.back();
    }
    solution = -H.llt().solve(g);
    for (std::size_t w = 0; w < J.size(); ++w)
      windows.push_back({J[w].transpose() * J[w], J[w].transpose() * (J[w] * solution + u[w])});
  }
};

/// Returns the share of 400 fits whose 95 % interval of a parameter holds its true value.
double coverage(double common, int parameter) {
  int held = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const LinearFit fit(seed, common);
    const Eigen::MatrixXd covariance = window_covariance(fit.windows);
    if (std::abs(fit.solution[parameter]) <= 1.96 * std::sqrt(covariance(parameter, parameter))) ++held;
  }
  return held / 400.0;
}

// The standard error of a share of 0.95 in 400 fits is 0.011.

TEST(WindowCovariance, IntervalsHoldWithResidualsThatAreCorrelatedWithinWindows) {
  for (const int parameter : {0, 1}) {
    EXPECT_GT(coverage(3.0, parameter), 0.91) << parameter;
    EXPECT_LT(coverage(3.0, parameter), 0.985) << parameter;
  }
}

TEST(WindowCovariance, IntervalsHoldWithWhiteResiduals) {
  for (const int parameter : {0, 1}) {
    EXPECT_GT(coverage(0.0, parameter), 0.92) << parameter;
    EXPECT_LT(coverage(0.0, parameter), 0.995) << parameter;
  }
}

TEST(WindowCovariance, WithoutInformationThePriorRemains) {
  const std::vector<WindowInformation> nothing(5, {Eigen::MatrixXd::Zero(3, 3), Eigen::VectorXd::Zero(3)});
  EXPECT_TRUE(window_covariance(nothing).isApprox(Eigen::MatrixXd::Identity(3, 3)));
}

}  // namespace
}  // namespace armtune::internal::window_covariance_test

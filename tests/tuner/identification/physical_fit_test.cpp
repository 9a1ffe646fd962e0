#include "tuner/identification/physical_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "armtune/error.hpp"
#include "core/robot/physical_theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace physical_fit_test {

/// Estimate of a theta's base parameters, each known within a share of its size.
Estimate estimate_of(const BaseParameters& base, const Eigen::VectorXd& theta, double share) {
  Estimate e;
  e.theta = base.map * theta;
  const Eigen::VectorXd size =
      base.map.cwiseAbs() * theta.cwiseAbs() + Eigen::VectorXd::Constant(base.rank(), 1e-4);
  e.covariance = (share * size).cwiseAbs2().asDiagonal();
  return e;
}

double distance(const BaseParameters& base, const Estimate& e, const Eigen::VectorXd& theta) {
  return (base.map * theta - e.theta).cwiseQuotient(e.deviation()).norm();
}

void expect_physical(const ParameterVector& theta) {
  const auto n = theta.size() / (kLinkParameters + kJointParameters);
  for (Eigen::Index i = 0; i < n; ++i) {
    const PseudoInertia P = pseudo_inertia(theta.segment<kLinkParameters>(i * kLinkParameters));
    const Eigen::VectorXd eigen = Eigen::SelfAdjointEigenSolver<PseudoInertia>(P).eigenvalues();
    EXPECT_GE(eigen[0], -1e-9 * P.trace()) << "link " << i;
  }
  EXPECT_GE(theta.tail(n * kJointParameters).minCoeff(), 0.0);
}

TEST(PhysicalFit, KeepsAnEstimateThatSomeArmCouldHave) {
  for (const RobotModel& arm : {test::ur10(), test::seven_joint_arm()}) {
    const BaseParameters base = base_parameters(arm);
    const ParameterVector prior = theta_of(arm.chain);
    RobotModel heavier = arm;
    for (int i = 0; i < arm.n(); ++i) {
      LinkInertia& link = heavier.chain.link[static_cast<std::size_t>(i)];
      const double factor = 1.0 + 0.05 * i;
      link.mass *= factor;
      link.first_moment *= factor;
      link.inertia *= factor;
    }
    heavier.chain.viscous_friction.setConstant(1.0);
    heavier.chain.coulomb_friction.setConstant(2.0);
    const ParameterVector truth = theta_of(heavier.chain);
    const Estimate e = estimate_of(base, truth, 0.001);
    const PhysicalMinimum fit = physical_fit(base, e, prior);
    // The prior, known within 100 %, pulls by a millionth of what the estimate holds against it.
    EXPECT_LT(distance(base, e, fit.theta), 0.1) << arm.name;
    expect_physical(fit.theta);
  }
}

TEST(PhysicalFit, OfAnImpossibleEstimateIsThePhysicalThetaNearestToIt) {
  const RobotModel arm = test::ur10();
  const BaseParameters base = base_parameters(arm);
  const ParameterVector prior = theta_of(arm.chain);
  ParameterVector impossible = prior;
  impossible[joint_parameter_index(arm.n(), 2) + 1] = -0.5;  // viscous friction of the elbow
  impossible[3 * kLinkParameters + 9] -= 0.3;                // izz of the first wrist, its rotor not counted
  const Estimate e = estimate_of(base, impossible, 0.02);
  const PhysicalMinimum fit = physical_fit(base, e, prior);
  EXPECT_TRUE(fit.changed);
  expect_physical(fit.theta);
  const double found = distance(base, e, fit.theta);
  EXPECT_GT(found, 1.0) << "or the estimate was not impossible";

  // First-order optimality over a convex set: no step towards another physical theta comes nearer.
  std::mt19937 generator(831);
  for (int sample = 0; sample < 200; ++sample) {
    ParameterVector other = prior;
    for (double& x : other) x *= 1.0 + test::random_number(generator, -0.9, 0.9);
    for (double& x : other.tail(arm.n() * kJointParameters)) x += test::random_number(generator, 0.0, 0.3);
    project_to_physical(other);
    for (const double step : {1e-3, 1e-2, 0.1}) {
      const ParameterVector nearer = fit.theta + step * (other - fit.theta);
      // The prior's own pull: known within 100 %, it is worth at most a few units of distance squared.
      EXPECT_GT(distance(base, e, nearer), found - 0.02 * step * found - 1e-3) << sample;
    }
  }
}

TEST(PhysicalFit, AnEstimateThatIsValidAtTheEdgeIsNotCalledChanged) {
  RobotModel arm = test::ur10();
  const BaseParameters base = base_parameters(arm);
  arm.chain.link[2].inertia =
      in_frame({1.0, Vec3::Zero(), Mat3::Zero()}, Mat3::Identity(), Vec3(0.1, 0.2, 0.3)).inertia;
  arm.chain.link[2].first_moment = Vec3(0.1, 0.2, 0.3);
  arm.chain.link[2].mass = 1.0;  // a point mass: its pseudo-inertia has rank one
  const ParameterVector truth = theta_of(arm.chain);
  const PhysicalMinimum fit = physical_fit(base, estimate_of(base, truth, 1e-3), truth);
  EXPECT_FALSE(fit.changed);
  // Yet what comes out can be divided by.
  const PseudoInertia P = pseudo_inertia(fit.theta.segment<kLinkParameters>(2 * kLinkParameters));
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<PseudoInertia>(P).eigenvalues()[0], 0.0);
}

TEST(PhysicalFit, ACovarianceThatIsNoneIsRefused) {
  const RobotModel arm = test::ur10();
  const BaseParameters base = base_parameters(arm);
  const ParameterVector prior = theta_of(arm.chain);
  Estimate e = estimate_of(base, prior, 0.01);
  e.covariance(0, 1) = e.covariance(1, 0) = 10.0 * std::sqrt(e.covariance(0, 0) * e.covariance(1, 1));
  EXPECT_THROW(physical_fit(base, e, prior), InputError);
}

}  // namespace physical_fit_test
}  // namespace armtune::internal

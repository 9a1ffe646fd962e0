#include "tuner/identification/identification_files.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/sim/support/read_back.hpp"

namespace armtune::internal {
namespace identification_files_test {

constexpr Eigen::Index kGroups = 9;

/// Every group is one entry of theta: masses, then rotor inertias.
Eigen::Index entry(const RobotModel& arm, Eigen::Index group) {
  const auto i = static_cast<int>(group);
  return i < arm.n() ? i * kLinkParameters : joint_parameter_index(arm.n(), i - arm.n());
}

/// The map's other entries are zero, and what they add leaves -0 no sign.
double through_zeros(double value) {
  return value + 0.0;
}

struct Awkward {
  RobotModel arm = test::ur10();
  Identification found;
  std::vector<double> in_file, physical;  ///< of the groups
  std::vector<std::string> status;

  Awkward() : status(kGroups, "estimated") {
    found.base.map.setZero(kGroups, parameter_count(arm.chain));
    found.theta.setZero(parameter_count(arm.chain));
    found.estimate.theta.setZero(kGroups);
    found.estimate.covariance.setZero(kGroups, kGroups);
    for (Eigen::Index g = 0; g < kGroups; ++g) {
      const auto k = static_cast<std::size_t>(g);
      found.base.independent.push_back(static_cast<int>(entry(arm, g)));
      found.base.names.push_back(k == 0   ? test::kAwkwardText
                                 : k == 1 ? test::kFormula
                                          : "group " + std::to_string(k));
      found.base.map(g, entry(arm, g)) = 1.0;
      in_file.push_back(test::awkward(k + 1));
      if (g < arm.n()) {
        arm.chain.link[k].mass = in_file.back();
      } else {
        arm.chain.rotor_inertia[g - arm.n()] = in_file.back();
      }
      physical.push_back(test::awkward(k + 2));
      found.theta[entry(arm, g)] = physical.back();
      found.estimate.theta[g] = test::awkward(k);
      found.estimate.covariance(g, g) = std::abs(test::awkward(k + 4));
    }
    found.estimate.covariance(2, 2) = INFINITY;
    found.estimate.not_excited = {2};
    status[2] = "not excited";
    found.estimate.covariance(3, 3) = NAN;
    status[3] = "no standard deviation";
    found.estimate.covariance(4, 4) = INFINITY;
    status[4] = "no standard deviation";
    found.estimate.theta[5] = NAN;
    status[5] = "no estimate";
    found.estimate.theta[6] = -INFINITY;
    found.estimate.covariance(6, 6) = NAN;
    status[6] = "no estimate";
    found.estimate.covariance(7, 7) = -5e-324;  // of rounding: no variance is below zero
  }
};

void expect_same(const Awkward& a) {
  test::ReadBack read(base_parameters_csv(a.arm, a.found));
  for (std::size_t row = 0; row < static_cast<std::size_t>(kGroups); ++row) {
    const auto g = static_cast<Eigen::Index>(row);
    const double variance = a.found.estimate.covariance(g, g);
    read.text(row, "group", a.found.base.names[row]);
    read.number(row, "estimate", a.found.estimate.theta[g]);
    read.number(row, "standard_deviation", std::sqrt(variance < 0.0 ? 0.0 : variance));
    read.number(row, "robot_file", through_zeros(a.in_file[row]));
    read.number(row, "physical", through_zeros(a.physical[row]));
    read.text(row, "status", a.status[row]);
  }
  read.expect_all_seen(static_cast<std::size_t>(kGroups));
}

TEST(BaseParametersCsv, ReadsBackToTheBitAndIsEmptyWithItsStatus) {
  expect_same(Awkward());
}

TEST(BaseParametersCsv, IsEmptyForAThetaThatIsNone) {
  for (const double none : test::no_figures()) {
    Awkward a;
    // One entry of the groups' sums is enough: nothing times no figure is none either.
    a.found.theta[entry(a.arm, 0)] = none;
    a.physical.assign(static_cast<std::size_t>(kGroups), NAN);
    expect_same(a);
  }
}

}  // namespace identification_files_test
}  // namespace armtune::internal

// Joint impedance against test vectors that were derived from the source of Franka's example controllers by
// someone who had not seen this code. Each case of data/joint_impedance.txt says how.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "core/robot/dynamics.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/one_joint.hpp"
#include "tests/core/support/source_dir.hpp"

namespace armtune::internal {
namespace joint_impedance_vectors_test {

struct Vector {
  double q, qd, desired, desired_velocity, torque;
};
struct Case {
  std::string name, type;
  double k = 0.0, d = 0.0, rate = 0.0;  ///< rate: change of the torque in a period [N m]; 0: not limited
  std::vector<Vector> periods;
};

std::vector<Case> cases() {
  std::ifstream file(test::source_dir() + "/tests/core/control/laws/data/joint_impedance.txt");
  std::vector<Case> all;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word[0] == '#') continue;
    if (word == "case") {
      all.emplace_back();
      words >> all.back().name;
    } else if (word == "type") {
      words >> all.back().type;
    } else if (word == "period") {
      Vector v{};
      words >> v.q >> v.qd >> v.desired >> v.desired_velocity >> v.torque;
      all.back().periods.push_back(v);
    } else {
      double& value = word == "k" ? all.back().k : word == "d" ? all.back().d : all.back().rate;
      words >> value;
    }
    EXPECT_FALSE(words.fail()) << line;
  }
  return all;
}

TEST(JointImpedanceVectors, AreThoseOfFrankasExampleControllers) {
  constexpr double kPeriod = 0.001, kFilter = 0.01;
  const RobotModel arm = test::pendulum();
  const std::vector<Case> all = cases();
  ASSERT_GE(all.size(), 6U);
  for (const Case& one : all) {
    ASSERT_GE(one.periods.size(), 8U) << one.name;
    Gains gains = test::one_joint_gains("joint_impedance");
    own(gains, "joint_impedance_k")[0] = one.k;
    own(gains, "joint_impedance_d")[0] = one.d;
    own(gains, "joint_impedance_filter")[0] = kFilter;
    own(gains, "joint_impedance_velocity_factor")[0] = one.type == "ros1" ? 1.0 : 0.0;
    own(gains, "joint_impedance_torque_rate")[0] = one.rate / kPeriod;
    const auto law = controller_kind("joint_impedance")
                         .make({arm, gains, theta_of(arm.chain), kPeriod, TaskMask::kPosition});
    for (std::size_t k = 0; k < one.periods.size(); ++k) {
      const Vector& v = one.periods[k];
      const auto vector = [](double x) { return JointVector(JointVector::Constant(1, x)); };
      MeasuredArm measured;
      const JointState state{vector(v.q), vector(v.qd)};
      measured.measure(arm.chain, state.q, state.qd, {0.0, 0.05, 0.0}, TaskMask::kPosition);
      ControlOutput control;
      control.state = ControlState::kFollowPlan;
      control.planned = {vector(v.desired), vector(v.desired_velocity), vector(0.0)};
      control.reference = {vector(v.desired_velocity), vector(0.0)};
      control.S = state.qd - control.reference.velocity;
      Scene scene;
      const JointVector zero = vector(0.0);
      JointVector tau, weight;
      law->torque({state, measured, control, zero, scene, static_cast<double>(k) * kPeriod}, tau);
      gravity_torque(arm.chain, measured.poses, weight);
      EXPECT_NEAR(tau[0] - weight[0], v.torque, 1e-9 * (1.0 + std::abs(v.torque)))
          << one.name << ", period " << k;
    }
  }
}

}  // namespace joint_impedance_vectors_test
}  // namespace armtune::internal

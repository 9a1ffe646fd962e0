#pragma once
// URDFs of random trees of links, and options that select an arm in them.

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/core/support/states.hpp"
#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal::test {

inline UrdfOptions with_tip(const std::string& tip) {
  UrdfOptions options;
  options.tip_link = tip;
  return options;
}
inline UrdfOptions with_base(const std::string& base, const std::string& tip = "") {
  UrdfOptions options = with_tip(tip);
  options.base_link = base;
  return options;
}
inline UrdfOptions with_held(const std::string& joint, double value) {
  UrdfOptions options;
  options.held[joint] = value;
  return options;
}

/// A fixture that makes URDFs of random links and compares arms.
class UrdfTrees : public UrdfFiles {
 protected:
  UrdfTrees() : generator_(77) {}

  /// A body that is unlike any other.
  std::string body() {
    const auto number = [this](double lower, double upper) {
      return random_number(generator_, lower, upper);
    };
    const double a = number(0.02, 0.03), b = number(0.02, 0.03), c = number(0.02, 0.03);
    return fmt::format(
        "<inertial><origin xyz='{} {} {}' rpy='{} {} {}'/><mass value='{}'/>"
        "<inertia ixx='{}' iyy='{}' izz='{}' ixy='0.001' ixz='0.002' iyz='-0.001'/></inertial>",
        number(-0.1, 0.1), number(-0.1, 0.1), number(-0.1, 0.1), number(-1, 1), number(-1, 1), number(-1, 1),
        number(1, 3), a, b, c);
  }
  std::string placed(const std::string& axis = "0 0.6 0.8") {
    const auto number = [this] { return random_number(generator_, -0.4, 0.4); };
    return fmt::format("<origin xyz='{} {} {}' rpy='{} {} {}'/><axis xyz='{}'/>{}", number(), number(),
                       number(), number(), number(), number(), axis, kLimit);
  }
  /// `count` moving joints on `base`, with links `prefix`1, 2, ...
  std::string chain(const std::string& prefix, const std::string& base, int count) {
    std::string text;
    std::string before = base;
    for (int i = 1; i <= count; ++i) {
      const std::string name = prefix + std::to_string(i);
      text += link(name, body()) +
              joint(name + "_joint", i == 2 ? "prismatic" : "revolute", before, name, placed());
      before = name;
    }
    return text;
  }

  void expect_same_arm(const RobotModel& a, const RobotModel& b) {
    ASSERT_EQ(a.n(), b.n());
    EXPECT_EQ(joint_names(a), joint_names(b));
    for (int sample = 0; sample < 10; ++sample) {
      const JointVector q = random_configuration(generator_, a);
      const JointVector qd = random_vector(generator_, a.n(), 1.0);
      const JointVector qdd = random_vector(generator_, a.n(), 1.0);
      const JointVector torque = inverse_dynamics_at(a.chain, q, qd, qdd);
      EXPECT_LT((torque - inverse_dynamics_at(b.chain, q, qd, qdd)).norm(), 1e-12 * torque.norm());
      EXPECT_LT((poses_at(a.chain, q).p_0T - poses_at(b.chain, q).p_0T).norm(), 1e-12);
      EXPECT_LT((poses_at(a.chain, q).R_0T - poses_at(b.chain, q).R_0T).norm(), 1e-12);
    }
  }

  std::mt19937 generator_;
};

}  // namespace armtune::internal::test

#include "tests/core/support/arms.hpp"

#include <Eigen/Geometry>
#include <array>
#include <numbers>
#include <random>
#include <string>

#include "core/robot/rotor_estimate.hpp"
#include "core/robot/urdf_reader.hpp"
#include "tests/core/support/source_dir.hpp"

namespace armtune::internal::test {
namespace {

constexpr double kPi = std::numbers::pi;

class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}

  double between(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(generator_);
  }
  Vec3 vector(double bound) {
    const double x = between(-bound, bound);
    const double y = between(-bound, bound);
    return {x, y, between(-bound, bound)};
  }
  Mat3 rotation() {
    const Vec3 axis = vector(1.0) + Vec3(0.0, 0.0, 1e-3);
    return Eigen::AngleAxisd(between(-kPi, kPi), axis.normalized()).toRotationMatrix();
  }

 private:
  std::mt19937 generator_;
};

/// A body whose mass is spread with standard deviations `spread` along the principal axes R_BP: valid by
/// construction, since its moments are sums of two variances each.
LinkInertia body(double mass, const Vec3& center, const Mat3& R_BP, const Vec3& spread) {
  const Vec3 s = spread.cwiseAbs2();
  LinkInertia principal;
  principal.mass = mass;
  principal.inertia = mass * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()).asDiagonal();
  return in_frame(principal, R_BP, center);
}

void resize(Chain& chain, int n) {
  chain.n = n;
  chain.rotor_inertia.setZero(n);
  chain.viscous_friction.setZero(n);
  chain.coulomb_friction.setZero(n);
}

}  // namespace

RobotModel ur10() {
  UrdfOptions options;
  options.tip_link = "tool0";
  options.p_tip_T = Vec3(0.0, 0.0, 0.14);
  RobotModel model = read_urdf(test::source_dir() + "/sim/robots/ur10.urdf", options);
  model.chain.rotor_inertia.setConstant(0.1);
  validate(model);
  return model;
}

void fit_rotors(RobotModel& arm) {
  arm.chain.rotor_inertia.setZero();
  estimate_rotors(arm);
  arm.estimated_rotors.clear();
}

RobotModel seven_joint_arm() {
  struct Joint {
    double along_y, along_z;  // origin in the previous body
    Vec3 rpy;
    double mass;
    Vec3 center, spread;
    double range, velocity, effort;
  };
  const double h = kPi / 2.0;
  const std::array<Joint, 7> joints = {{
      {0.0, 0.1575, {0, 0, 0}, 4.0, {0, -0.03, 0.12}, {0.05, 0.06, 0.14}, 2.97, 1.48, 320.0},
      {0.0, 0.2025, {h, 0, kPi}, 4.0, {0.0003, 0.059, 0.042}, {0.05, 0.10, 0.05}, 2.09, 1.48, 320.0},
      {0.2045, 0.0, {h, 0, kPi}, 3.0, {0, 0.03, 0.13}, {0.04, 0.05, 0.15}, 2.97, 1.75, 176.0},
      {0.0, 0.2155, {h, 0, 0}, 2.7, {0, 0.067, 0.034}, {0.04, 0.09, 0.05}, 2.09, 1.31, 176.0},
      {0.1845, 0.0, {-h, kPi, 0}, 1.7, {0.0001, 0.021, 0.076}, {0.03, 0.04, 0.10}, 2.97, 2.27, 110.0},
      {0.0, 0.2155, {h, 0, 0}, 1.8, {0, 0.0006, 0.0004}, {0.03, 0.04, 0.03}, 2.09, 2.36, 40.0},
      {0.081, 0.0, {-h, kPi, 0}, 0.3, {0, 0, 0.02}, {0.03, 0.03, 0.02}, 3.05, 2.36, 40.0},
  }};
  RobotModel model;
  model.name = "seven_joint_arm";
  model.source = "seven_joint_arm";
  model.base_link = "link_0";
  model.tip_link = "link_7";
  Chain& chain = model.chain;
  resize(chain, static_cast<int>(joints.size()));
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const Joint& joint = joints[k];
    const std::string number = std::to_string(k + 1);
    model.joints.push_back({"joint_" + number,
                            "link_" + number,
                            {true, -joint.range, joint.range, joint.velocity, joint.effort}});
    chain.R_PB0[k] =
        (Eigen::AngleAxisd(joint.rpy.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(joint.rpy.y(), Vec3::UnitY()) *
         Eigen::AngleAxisd(joint.rpy.x(), Vec3::UnitX()))
            .toRotationMatrix();
    chain.p_PB0[k] = Vec3(0.0, joint.along_y, joint.along_z);
    // Principal axes a little off the frame's, so that no product of inertia is zero.
    const Mat3 R_BP = Eigen::AngleAxisd(0.3, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
    chain.link[k] = body(joint.mass, joint.center, R_BP, joint.spread);
  }
  chain.rotor_inertia.setConstant(0.1);
  chain.viscous_friction.setConstant(0.5);
  chain.coulomb_friction.setConstant(0.4);
  chain.p_BT = Vec3(0.0, 0.0, 0.145);
  validate(model);
  return model;
}

RobotModel random_arm(int n, unsigned seed, bool with_prismatic) {
  Random random(seed);
  RobotModel model;
  model.name = "random_arm_" + std::to_string(n);
  model.source = model.name;
  model.base_link = "link_0";
  model.tip_link = "link_" + std::to_string(n);
  Chain& chain = model.chain;
  resize(chain, n);
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const std::string number = std::to_string(i + 1);
    const bool prismatic = with_prismatic && i % 3 == 1;
    chain.motion[k] = prismatic ? JointMotion::kPrismatic : JointMotion::kRevolute;
    JointLimits limits;
    limits.has_position = prismatic || i % 2 == 0;
    if (limits.has_position) {
      limits.lower = prismatic ? random.between(-0.3, 0.0) : random.between(-3.0, -1.0);
      limits.upper = prismatic ? random.between(0.1, 0.4) : random.between(1.0, 3.0);
    }
    limits.velocity = random.between(1.0, 3.0);
    limits.effort = random.between(50.0, 300.0);
    model.joints.push_back({"joint_" + number, "link_" + number, limits});
    chain.R_PB0[k] = random.rotation();
    chain.p_PB0[k] = random.vector(0.3);
    const double mass = random.between(0.5, 8.0);
    const Vec3 center = random.vector(0.1);
    const Mat3 R_BP = random.rotation();
    chain.link[k] = body(mass, center, R_BP, random.vector(0.1) + Vec3::Constant(0.12));
    chain.rotor_inertia[i] = random.between(0.02, 0.2);
    chain.viscous_friction[i] = random.between(0.1, 3.0);
    chain.coulomb_friction[i] = random.between(0.1, 3.0);
  }
  chain.R_BT = random.rotation();
  chain.p_BT = random.vector(0.2);
  validate(model);
  return model;
}

std::vector<RobotModel> all_arms() {
  return {ur10(),
          seven_joint_arm(),
          random_arm(6, 11, true),
          random_arm(7, 12, false),
          random_arm(3, 13, false),
          random_arm(12, 14, true)};
}

}  // namespace armtune::internal::test

// Frames and inertias that come out of a URDF, against independent sums and products of its numbers.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "core/robot/kinematics.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal {
namespace urdf_geometry_test {

using test::joint;
using test::kInertial;
using test::kLimit;
using test::kUr10;
using test::link;
using test::one_joint;
using test::robot;

constexpr double kPi = std::numbers::pi;

class UrdfGeometry : public test::UrdfFiles {};

// --- Kinematics against transforms multiplied straight from the URDF's numbers ---

using Transform = Eigen::Matrix4d;

Mat3 rodrigues(const Vec3& axis, double angle) {
  const Vec3 k = axis / std::sqrt(axis.dot(axis));
  Mat3 K;
  K << 0, -k.z(), k.y(), k.z(), 0, -k.x(), -k.y(), k.x(), 0;
  return Mat3::Identity() + std::sin(angle) * K + (1 - std::cos(angle)) * K * K;
}
Transform transform(const Mat3& R, const Vec3& p) {
  Transform X = Transform::Identity();
  X.topLeftCorner<3, 3>() = R;
  X.topRightCorner<3, 1>() = p;
  return X;
}
/// URDF's roll, pitch, yaw: about the fixed axes x, then y, then z.
Mat3 from_rpy(const Vec3& rpy) {
  return rodrigues(Vec3::UnitZ(), rpy.z()) * rodrigues(Vec3::UnitY(), rpy.y()) *
         rodrigues(Vec3::UnitX(), rpy.x());
}

struct UrdfJoint {
  std::string type;
  Vec3 xyz, rpy, axis;

  Transform at(double q) const {
    const Transform origin = transform(from_rpy(rpy), xyz);
    if (type == "fixed") return origin;
    if (type == "prismatic") return origin * transform(Mat3::Identity(), q * axis.normalized());
    return origin * transform(rodrigues(axis, q), Vec3::Zero());
  }
};

/// Joint origins, joint axes and the frame of the last link, from both sides.
void expect_same_poses(const RobotModel& arm, const std::vector<UrdfJoint>& joints, const JointVector& q) {
  Poses poses;
  forward_kinematics(arm.chain, q, poses);
  Transform X = Transform::Identity();
  int i = 0;
  for (const UrdfJoint& given : joints) {
    if (given.type == "fixed") {
      X = X * given.at(0.0);
      continue;
    }
    const auto k = static_cast<std::size_t>(i);
    X = X * given.at(q[i++]);
    const Mat3 R_0L = X.topLeftCorner<3, 3>();
    const Vec3 p_0L = X.topRightCorner<3, 1>();
    EXPECT_LT((poses.p_0B[k] - p_0L).norm(), 1e-12) << "joint " << k;
    EXPECT_LT((poses.R_0B[k].col(2) - R_0L * given.axis.normalized()).norm(), 1e-12) << "joint " << k;
  }
  EXPECT_LT((transform(poses.R_0T, poses.p_0T) - X).norm(), 1e-12);
}

TEST_F(UrdfGeometry, Ur10PosesEqualTheProductOfItsTransforms) {
  const double h = kPi / 2;
  std::vector<UrdfJoint> joints = {
      {"revolute", {0, 0, 0.1273}, {0, 0, 0}, Vec3::UnitZ()},
      {"revolute", {0, 0.220941, 0}, {0, h, 0}, Vec3::UnitY()},
      {"revolute", {0, -0.1719, 0.612}, {0, 0, 0}, Vec3::UnitY()},
      {"revolute", {0, 0, 0.5723}, {0, h, 0}, Vec3::UnitY()},
      {"revolute", {0, 0.1149, 0}, {0, 0, 0}, Vec3::UnitZ()},
      {"revolute", {0, 0, 0.1157}, {0, 0, 0}, Vec3::UnitY()},
      {"fixed", {0, 0.0922, 0}, {-h, 0, 0}, Vec3::Zero()},
  };
  JointVector q(6);
  q << 0.3, -1.2, 1.9, -0.4, 2.5, -3.0;
  expect_same_poses(read_urdf(kUr10), joints, q);

  joints.push_back({"fixed", {0, 0, 0.14}, {0, 0, 0}, Vec3::Zero()});
  expect_same_poses(test::ur10(), joints, q);

  joints.pop_back();
  joints.back() = {"fixed", {0, 0.0922, 0}, {0, 0, h}, Vec3::Zero()};
  UrdfOptions on_ee_link;
  on_ee_link.tip_link = "ee_link";
  expect_same_poses(read_urdf(kUr10, on_ee_link), joints, q);
}

// A link that is fixed to another one has a frame of its own in the same body.
TEST_F(UrdfGeometry, EveryLinkHasItsFrameInTheBodyThatMovesIt) {
  const std::string turns = "<origin xyz='0 0 1'/><axis xyz='0 1 0'/>" + kLimit;
  const RobotModel arm = read(robot(one_joint(kInertial, turns) + link("c") + link("d", "") +
                                    joint("to_c", "fixed", "b", "c", "<origin xyz='1 2 3' rpy='0 0 0.5'/>") +
                                    joint("to_d", "fixed", "a", "d", "<origin xyz='0 0 4'/>")));
  JointVector q(1);
  q << 0.7;
  Poses poses;
  forward_kinematics(arm.chain, q, poses);
  const Transform X_b = UrdfJoint{"revolute", {0, 0, 1}, {0, 0, 0}, Vec3::UnitY()}.at(q[0]);
  const Transform X_c = X_b * UrdfJoint{"fixed", {1, 2, 3}, {0, 0, 0.5}, Vec3::Zero()}.at(0.0);
  const std::vector<std::pair<std::string, Transform>> expected = {
      {"a", Transform::Identity()},
      {"b", X_b},
      {"c", X_c},
      {"d", transform(Mat3::Identity(), Vec3(0.0, 0.0, 4.0))}};
  ASSERT_EQ(arm.links.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const LinkFrame& frame = arm.links[k];
    EXPECT_EQ(frame.name, expected[k].first);
    const Transform X_BL = transform(frame.R_BL, frame.p_BL);
    const Transform X_0B =
        frame.body < 0 ? Transform::Identity().eval() : transform(poses.R_0B.at(0), poses.p_0B.at(0));
    EXPECT_LT((X_0B * X_BL - expected[k].second).norm(), 1e-12) << frame.name;
  }
}

// As a UR's calibrated description has them: origins and angles of the arm's make, a little beside the
// nominal ones, and a shoulder that is far off along its axis, which the elbow takes back.
TEST_F(UrdfGeometry, ACalibratedArmsPosesEqualTheProductOfItsTransforms) {
  const double h = kPi / 2;
  const std::vector<UrdfJoint> joints = {
      {"revolute", {0, 0, 0.162476}, {0, 0, -2.1e-5}, Vec3::UnitZ()},
      {"revolute", {0.000131, 0, 0}, {h + 0.000418, 0, 1.3e-5}, Vec3::UnitZ()},
      {"revolute", {-0.425063, 0, 0}, {0.00163, 0.00213, 7.2e-5}, Vec3::UnitZ()},
      {"revolute", {-0.392261, -0.000412, 2.741831}, {3.14091, -3.13998, 3.141589}, Vec3::UnitZ()},
      {"revolute", {-8.7e-5, -0.099651, -0.000135}, {h + 0.00117, 0, -4.4e-5}, Vec3::UnitZ()},
      {"revolute", {2.2e-5, 0.099557, -0.000228}, {h + 0.00229, kPi, kPi - 3.1e-5}, Vec3::UnitZ()},
  };
  std::string urdf = R"(<robot name="calibrated"><link name="l0"/>)";
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto list = [](const Vec3& v) {
      return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
    };
    urdf += fmt::format(
        R"(<link name="l{1}"><inertial><mass value="2"/><inertia ixx="0.02" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>)"
        R"(<joint name="j{1}" type="revolute"><parent link="l{0}"/><child link="l{1}"/><origin xyz="{2}" rpy="{3}"/>)"
        R"(<axis xyz="{4}"/><limit lower="-6.2" upper="6.2" velocity="3" effort="150"/></joint>)",
        k, k + 1, list(joints[k].xyz), list(joints[k].rpy), list(joints[k].axis));
  }
  const RobotModel arm = read_urdf(write(urdf + "</robot>"));
  ASSERT_EQ(arm.n(), 6);
  JointVector q(6);
  q << 0.3, -1.2, 1.9, -0.4, 2.5, -3.0;
  expect_same_poses(arm, joints, q);
  EXPECT_GT(std::abs((arm.chain.R_PB0[2] * Vec3::UnitZ()).x()), 1e-3) << "the elbow's axis is skew";
}

TEST_F(UrdfGeometry, RandomArmsWithFixedLinksBetweenPosesEqualTheProductOfTheirTransforms) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto vector = [&] { return Vec3(number(generator), number(generator), number(generator)); };
  const std::vector<std::string> types = {"fixed", "revolute",   "fixed",    "prismatic",
                                          "fixed", "continuous", "revolute", "fixed"};
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<UrdfJoint> joints;
    std::string text = link("l0");
    for (const std::string& type : types) {
      UrdfJoint next{type, vector(), kPi * vector(), 5.0 * vector()};
      if (trial == 0) next.axis = Vec3(0, 0, -2);
      if (trial == 1) next.axis = Vec3(1e-9, 0, -1);
      const std::string parent = fmt::format("l{}", joints.size());
      const std::string child = fmt::format("l{}", joints.size() + 1);
      const Vec3& p = next.xyz;
      const Vec3& r = next.rpy;
      const Vec3& a = next.axis;
      text += link(child) +
              joint("to_" + child, type, parent, child,
                    fmt::format("<origin xyz='{} {} {}' rpy='{} {} {}'/><axis xyz='{} {} {}'/>{}", p.x(),
                                p.y(), p.z(), r.x(), r.y(), r.z(), a.x(), a.y(), a.z(), kLimit));
      joints.push_back(next);
    }
    JointVector q(4);
    for (double& angle : q) angle = 3.0 * number(generator);
    UrdfOptions options;
    options.tip_link = "l8";
    expect_same_poses(read(robot(text), options), joints, q);
  }
}

TEST_F(UrdfGeometry, AxisOppositeToZTurnsTheBodyFrameAboutX) {
  const RobotModel arm = read(robot(one_joint(kInertial, "<axis xyz='0 0 -3'/>" + kLimit)));
  const Mat3 half_turn = Vec3(1, -1, -1).asDiagonal();
  EXPECT_EQ(arm.chain.R_PB0[0], half_turn);
}

// --- Merging against a cloud of point masses ---

struct Cloud {
  std::vector<double> mass;
  std::vector<Vec3> point;

  void add(const Cloud& other, const Transform& X) {
    for (std::size_t i = 0; i < other.mass.size(); ++i) {
      mass.push_back(other.mass[i]);
      point.push_back((X * other.point[i].homogeneous()).head<3>());
    }
  }
  LinkInertia sums() const {
    LinkInertia body;
    for (std::size_t i = 0; i < mass.size(); ++i) {
      const Vec3& p = point[i];
      body.mass += mass[i];
      body.first_moment += mass[i] * p;
      body.inertia += mass[i] * (p.dot(p) * Mat3::Identity() - p * p.transpose());
    }
    return body;
  }
};

/// Six points about a centre, as URDF text too: `rpy` turns the axes that the inertia is given in.
struct Part {
  Cloud cloud;
  std::string inertial;

  template <typename Number>
  Part(Number&& number, const Vec3& center, const Vec3& rpy) {
    const Mat3 R = from_rpy(rpy);
    Cloud about_center;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 offset(number(), number(), number());
      const double m = 1.5 + number();
      for (const double sign : {-1.0, 1.0}) {
        about_center.mass.push_back(m);
        about_center.point.push_back(sign * 0.2 * offset);
      }
    }
    const LinkInertia body = about_center.sums();
    const Mat3& I = body.inertia;
    inertial = fmt::format(
        "<inertial><origin xyz='{} {} {}' rpy='{} {} {}'/><mass value='{}'/>"
        "<inertia ixx='{}' ixy='{}' ixz='{}' iyy='{}' iyz='{}' izz='{}'/></inertial>",
        center.x(), center.y(), center.z(), rpy.x(), rpy.y(), rpy.z(), body.mass, I(0, 0), I(0, 1), I(0, 2),
        I(1, 1), I(1, 2), I(2, 2));
    cloud.add(about_center, transform(R, center));
  }
};

TEST_F(UrdfGeometry, MergingFixedLinksConservesMassCentreAndInertia) {
  std::mt19937 generator(3);
  const auto number = [&] { return std::uniform_real_distribution<double>(-1.0, 1.0)(generator); };
  const auto vector = [&] { return Vec3(number(), number(), number()); };
  for (int trial = 0; trial < 20; ++trial) {
    // Link b carries c, c carries d, and b carries e: all fixed, except b, which turns.
    Cloud whole;  // in link b
    std::string text = link("a");
    Transform X_bc = Transform::Identity();
    for (const auto& [name, parent] : {std::pair{"b", "a"}, {"c", "b"}, {"d", "c"}, {"e", "b"}}) {
      const Part part(number, vector(), kPi * vector());
      const UrdfJoint origin{"fixed", vector(), kPi * vector(), Vec3::Zero()};
      const Vec3& p = origin.xyz;
      const Vec3& r = origin.rpy;
      const bool turns = name == std::string("b");
      text += link(name, part.inertial) +
              joint(fmt::format("to_{}", name), turns ? "revolute" : "fixed", parent, name,
                    fmt::format("<origin xyz='{} {} {}' rpy='{} {} {}'/><axis xyz='1 2 -2'/>{}", p.x(), p.y(),
                                p.z(), r.x(), r.y(), r.z(), kLimit));
      Transform X = turns ? Transform::Identity().eval() : origin.at(0.0);
      if (name == std::string("c")) X_bc = X;
      if (name == std::string("d")) X = X_bc * X;
      whole.add(part.cloud, X);
    }
    const RobotModel arm = read(robot(text));
    ASSERT_EQ(arm.n(), 1);

    // Frame B from frame L of link b: the tool frame is L.
    Cloud in_B;
    in_B.add(whole, transform(arm.chain.R_BT, arm.chain.p_BT));
    const LinkInertia expected = in_B.sums();
    const LinkInertia& merged = arm.chain.link[0];
    EXPECT_NEAR(merged.mass, expected.mass, 1e-12);
    EXPECT_LT((merged.first_moment - expected.first_moment).norm(), 1e-11);
    EXPECT_LT((merged.inertia - expected.inertia).norm(), 1e-11);

    // The whole about a common point, the base frame's origin, with the joint turned.
    JointVector q(1);
    q << 0.8;
    Poses poses;
    forward_kinematics(arm.chain, q, poses);
    Cloud in_0;
    in_0.add(whole, transform(poses.R_0T, poses.p_0T));
    const LinkInertia in_base = in_frame(merged, poses.R_0B[0], poses.p_0B[0]);
    EXPECT_LT((in_base.first_moment - in_0.sums().first_moment).norm(), 1e-11);
    EXPECT_LT((in_base.inertia - in_0.sums().inertia).norm(), 1e-10);
  }
}

}  // namespace urdf_geometry_test
}  // namespace armtune::internal

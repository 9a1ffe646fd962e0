// A URDF whose inertias no body has: all of them are named at once, and what is proposed is accepted.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>

#include "core/robot/body_inertia.hpp"
#include "core/robot/urdf_reader.hpp"
#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/sidecar_text.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/core/support/urdf_text.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace impossible_inertia_test {

using testing::AllOf;
using testing::HasSubstr;

TEST(ImpossibleInertia, AllLinksAreNamedAndTheProposalIsAccepted) {
  RobotModel arm = test::ur10();
  for (const std::size_t k : {1U, 4U}) {
    LinkInertia& link = arm.chain.link[k];
    const Vec3 center = link.first_moment / link.mass;
    link = in_frame({link.mass, Vec3::Zero(), Mat3(Vec3(0.3, 0.4, 0.73).asDiagonal())}, Mat3::Identity(),
                    center);
  }
  const test::TemporaryFolder folder;
  const std::string urdf = folder.write("arm.urdf", urdf_text(arm));
  const InputError error = test::input_error([&] { load_robot(urdf); });
  EXPECT_THAT(error, test::refused_at({.file = urdf,
                                       .key = "upper_arm_link/inertia",
                                       .value = "principal moments 0.3, 0.4, 0.73 kg m^2"}));
  EXPECT_THAT(error.what(),
              AllOf(HasSubstr("wrist_2_link (principal moments 0.3, 0.4, 0.73 kg"), HasSubstr("--sidecar")));
  const MissingData missing = missing_data(urdf);
  ASSERT_EQ(missing.impossible.size(), 2U);
  EXPECT_FALSE(missing.empty());
  // The nearest S is 0.015 away along one axis; the inertia given has a norm of 0.884.
  EXPECT_NEAR(missing.impossible[0].moved, 0.015 * std::sqrt(2.0) / 0.884, 2e-3);
  const auto proposed = load_robot(folder.write("arm.yaml", sidecar_yaml(urdf, missing, {})));
  for (const std::size_t k : {1U, 4U}) {
    const LinkInertia& link = proposed->chain.link[k];
    EXPECT_TRUE(is_physical(link));
    EXPECT_NEAR(link.mass, arm.chain.link[k].mass, 1e-9);
    EXPECT_LT((link.first_moment - arm.chain.link[k].first_moment).norm(), 1e-8);
    EXPECT_LT((link.inertia - arm.chain.link[k].inertia).norm(), 0.03);
  }
}

struct GivenLink {
  double mass;   // kg
  Vec3 moments;  // kg m^2, about the link's axes
};

/// A URDF of links l0, l1, ... Each turns about its z axis, and its centre of mass lies on this axis.
std::string arm_of(const std::vector<GivenLink>& links) {
  std::string text = test::link("base", "");
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Vec3& moments = links[i].moments;
    text += test::link(
        fmt::format("l{}", i),
        fmt::format("<inertial><origin xyz='0 0 0.1'/><mass value='{}'/><inertia ixx='{}' iyy='{}' izz='{}' "
                    "ixy='0' ixz='0' iyz='0'/></inertial>",
                    links[i].mass, moments.x(), moments.y(), moments.z()));
    text += test::joint(fmt::format("j{}", i), "revolute", i == 0 ? "base" : fmt::format("l{}", i - 1),
                        fmt::format("l{}", i));
  }
  return test::robot(text);
}

/// The text with a value behind the first key that has none.
std::string filled(std::string text, const std::string& key, const std::string& value) {
  const auto at = text.find(key + ":  #");
  EXPECT_NE(at, std::string::npos) << key;
  return at == std::string::npos ? text : text.insert(at + key.size() + 1, " " + value);
}

TEST(ImpossibleInertia, EveryKindIsNamedAtOnceWithTheNearestInertiaOrAKeyToFillIn) {
  const std::vector<GivenLink> links = {{-2.0, Vec3(0.1, 0.2, 0.2)},   // a negative mass
                                        {1.0, Vec3(-1.0, 1.0, 1.0)},   // a negative moment
                                        {1.0, Vec3(0.1, 0.2, 0.4)},    // triangle inequality
                                        {1.0, Vec3(1.0, 1.0, 0.0)},    // a rod along the axis
                                        {1.0, Vec3(0.0, 0.0, 0.0)},    // a point on the axis
                                        {1.0, Vec3(0.1, 0.2, 0.25)}};  // possible
  const test::TemporaryFolder folder;
  const std::string urdf = folder.write("arm.urdf", arm_of(links));
  const InputError all = test::input_error([&] { load_robot(urdf); });
  EXPECT_THAT(all, test::refused_at({.file = urdf, .key = "l0/inertia", .value = "mass -2 kg"}));
  EXPECT_THAT(all.what(),
              AllOf(HasSubstr("l1 (moment -1 kg m^2)"), HasSubstr("l2 (principal moments 0.1, 0.2, 0.4 kg"),
                    HasSubstr("l3 (no inertia"), HasSubstr("l4 (no inertia"), testing::Not(HasSubstr("l5"))));
  const MissingData missing = missing_data(urdf);
  EXPECT_TRUE(missing.inertia.empty()) << "none is named twice";
  ASSERT_EQ(missing.impossible.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const ImpossibleInertia& link = missing.impossible[i];
    EXPECT_EQ(link.link, fmt::format("l{}", i));
    EXPECT_EQ(link.joint, static_cast<int>(i));
    EXPECT_EQ(link.is_complete(), i != 0 && i != 4) << i;
    EXPECT_TRUE(is_physical({1.0, Vec3::Zero(), link.nearest.about_center})) << i;
    EXPECT_LT((link.nearest.center - Vec3(0.0, 0.0, 0.1)).norm(), 1e-12) << i;
    if (i == 4) continue;
    const Mat3 given = links[i].moments.asDiagonal();
    EXPECT_NEAR(link.moved, (link.nearest.about_center - given).norm() / given.norm(), 1e-12) << i;
  }
  EXPECT_EQ(missing.impossible[0].moved, 0.0) << "the moments beside a negative mass are possible";
  EXPECT_LT(missing.impossible[3].moved, 2e-3) << "a thousandth of the rod's second moment about each axis";

  // What has no nearest value is asked for.
  std::string text = sidecar_yaml(urdf, missing, {});
  const auto load = [&] { load_robot(folder.write("arm.yaml", text)); };
  EXPECT_THAT(load,
              test::refused_at({.file = folder / "arm.yaml", .key = "inertia/l0/mass", .limit = "a number"}));
  text = filled(text, "mass", "2");
  EXPECT_THAT(load, test::refused_at({.key = "inertia/l4/moments", .limit = "a list of 6 numbers"}));
  text = filled(text, "moments", "[0.1, 0, 0, 0.1, 0, 0.1]");
  const auto arm = load_robot(folder.write("arm.yaml", text));
  EXPECT_EQ(arm->chain.link[0].mass, 2.0);
  EXPECT_NEAR(arm->chain.link[0].inertia(2, 2), 0.2, 1e-12);
  for (const LinkInertia& link : std::span(arm->chain.link).first(6)) EXPECT_TRUE(is_physical(link));
}

// A tool or another fixed link gives the body the inertia that one of its links lacks.
TEST(ImpossibleInertia, ALinkThatIsHiddenInItsBodyIsNoReasonToRefuse) {
  EXPECT_TRUE(missing_data(test::source_dir() + "/sim/robots/ur10.urdf").impossible.empty());
  const test::TemporaryFolder folder;
  const std::string urdf = folder.write("arm.urdf", arm_of({{1.0, Vec3::Zero()}}));
  EXPECT_EQ(missing_data(urdf).impossible.size(), 1U);
  UrdfOptions options;
  options.tool_inertia = {1.0, Vec3::Zero(), Mat3(0.1 * Mat3::Identity())};
  EXPECT_TRUE(missing_data(urdf, options).empty());
  EXPECT_NO_THROW(read_urdf(urdf, options));
}

}  // namespace impossible_inertia_test
}  // namespace armtune::internal

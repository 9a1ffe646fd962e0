#include "sim/scenario/sidecar_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace sidecar_text_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

LinkInertia body(double mass, double radius_of_gyration) {
  const Vec3 center(0.0, 0.0, 0.1);
  const LinkInertia about_center{mass, Vec3::Zero(),
                                 mass * radius_of_gyration * radius_of_gyration * Mat3::Identity()};
  return in_frame(about_center, Mat3::Identity(), center);
}

/// The text without the comment marks before proposed values. Sentences have a blank behind their mark, which
/// stays.
std::string accepted(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool mark = text[at] == '#' && (at == 0 || text[at - 1] == '\n');
    const bool of_value = mark && (text[at + 1] != ' ' || text[at + 2] == ' ');
    if (!of_value) result += text[at];
  }
  return result;
}

// Without the comment marks, what is proposed is a robot YAML that settles the doubt.
TEST(SidecarText, WhatIsProposedSettlesTheDoubt) {
  const test::TemporaryFolder folder;
  RobotModel arm = test::ur10();
  test::fit_rotors(arm);
  arm.joints[0].limits.lower = -160.0;
  arm.joints[0].limits.upper = 160.0;
  arm.joints[0].limits.velocity = 180.0;
  folder.write("arm.urdf", urdf_text(arm));
  const std::vector<Doubt> found = doubts_with_proposals(arm);
  ASSERT_EQ(found.size(), 2U);
  const std::string text = sidecar_yaml("arm.urdf", {}, found);
  EXPECT_EQ(doubts(*load_robot(folder.write("as_written.yaml", text))).size(), 2U)
      << "comments change nothing";
  const auto robot = load_robot(folder.write("settled.yaml", accepted(text)));
  EXPECT_THAT(doubts(*robot), IsEmpty());
  EXPECT_NEAR(robot->joints[0].limits.upper, 2.793, 1e-3);
  EXPECT_NEAR(robot->joints[0].limits.velocity, 3.142, 1e-3);
}

TEST(SidecarText, WhatOnlyTheMakerKnowsIsAskedFor) {
  RobotModel arm = test::ur10();
  arm.chain.link[1] = body(0.01, 0.1);
  const std::string text = sidecar_yaml("arm.urdf", {}, doubts_with_proposals(arm));
  EXPECT_THAT(text, HasSubstr("#inertia:\n#  \"upper_arm_link\":\n#    mass:\n"));
}

// The estimate replaces what the URDF or the file gives, which 'rotor_inertia: estimated' would not.
TEST(SidecarText, ADoubtfulRotorInertiaIsReplacedByTheEstimate) {
  const test::TemporaryFolder folder;
  RobotModel arm = test::ur10();
  test::fit_rotors(arm);
  const JointVector rule = arm.chain.rotor_inertia;
  arm.chain.rotor_inertia[2] *= 1e-4;
  folder.write("arm.urdf", urdf_text(arm));
  const std::string text = sidecar_yaml("arm.urdf", {}, doubts_with_proposals(arm));
  EXPECT_THAT(text, HasSubstr("#rotor_inertia:\n#  \"estimated\": ["));
  const auto robot = load_robot(folder.write("arm.yaml", accepted(text)));
  EXPECT_EQ(robot->estimated_rotors.size(), 6U);
  // Proposals have two digits.
  EXPECT_LT((robot->chain.rotor_inertia - rule).cwiseQuotient(rule).cwiseAbs().maxCoeff(), 0.05);
  EXPECT_THAT(doubts(*robot), IsEmpty());
}

// A key that is there already is not proposed once more, because YAML refuses a key that is there twice.
TEST(SidecarText, MissingAndDoubtfulValuesAreInOneFileWithEachKeyOnce) {
  const test::TemporaryFolder folder;
  RobotModel arm = test::ur10();
  test::fit_rotors(arm);
  arm.joints[0].limits.lower = -160.0;
  arm.joints[0].limits.upper = 160.0;
  arm.joints[0].limits.effort = 0.0;
  arm.joints[5].limits.velocity = 0.0;
  const std::string urdf = folder.write("arm.urdf", urdf_text(arm));
  MissingData missing;
  const auto incomplete = load_robot(read_robot_file(urdf), &missing);
  EXPECT_THAT(missing.velocity, ElementsAre("wrist_3_joint"));
  EXPECT_THAT(missing.effort, ElementsAre("shoulder_pan_joint"));
  const std::vector<Doubt> found = doubts_with_proposals(*incomplete, missing);
  ASSERT_EQ(found.size(), 1U);
  std::string text = sidecar_yaml(urdf, missing, found);
  for (const auto& [key, value] : {std::pair("velocity:", " 2"), std::pair("effort:", " 300")}) {
    const auto at = text.find(key);
    ASSERT_NE(at, std::string::npos) << text;
    text.insert(at + std::string(key).size(), value);
  }
  EXPECT_EQ(load_robot(folder.write("as_written.yaml", text))->joints[0].limits.upper, 160.0);
  const auto robot = load_robot(folder.write("accepted.yaml", accepted(text)));
  EXPECT_NEAR(robot->joints[0].limits.upper, 2.793, 1e-3);
  EXPECT_EQ(robot->joints[0].limits.effort, 300.0);
  EXPECT_EQ(robot->joints[5].limits.velocity, 2.0);
  EXPECT_THAT(doubts(*robot), IsEmpty());
}

}  // namespace sidecar_text_test
}  // namespace armtune::internal

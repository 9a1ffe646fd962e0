// A URDF whose inertias no body has: all of them are named at once, and what is proposed is accepted.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/body_inertia.hpp"
#include "core/robot/urdf_reader.hpp"
#include "core/robot/urdf_writer.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/urdf_keys.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace {

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
  EXPECT_THAT(test::refusal([&] { load_robot(urdf); }),
              AllOf(HasSubstr("upper_arm_link (0.3, 0.4, 0.73)"), HasSubstr("wrist_2_link (0.3, 0.4, 0.73)"),
                    HasSubstr("--sidecar")));
  const MissingData missing = missing_data(urdf);
  ASSERT_EQ(missing.impossible.size(), 2U);
  EXPECT_FALSE(missing.empty());
  // The nearest S is 0.015 away along one axis; the inertia given has a norm of 0.884.
  EXPECT_NEAR(missing.impossible[0].moved, 0.015 * std::sqrt(2.0) / 0.884, 2e-3);
  const auto proposed = load_robot(folder.write("arm.yaml", missing_yaml(urdf, missing)));
  for (const std::size_t k : {1U, 4U}) {
    const LinkInertia& link = proposed->chain.link[k];
    EXPECT_TRUE(is_physical(link));
    EXPECT_NEAR(link.mass, arm.chain.link[k].mass, 1e-9);
    EXPECT_LT((link.first_moment - arm.chain.link[k].first_moment).norm(), 1e-8);
    EXPECT_LT((link.inertia - arm.chain.link[k].inertia).norm(), 0.03);
  }
}

TEST(ImpossibleInertia, ALinkThatIsHiddenInItsBodyIsNoReasonToRefuse) {
  EXPECT_TRUE(missing_data(ARMTUNE_SOURCE_DIR "/sim/robots/ur10.urdf").impossible.empty());
}

}  // namespace
}  // namespace armtune::internal

#include "tuner/gains/gains_difference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/control/laws/controller_kind.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace gains_difference_test {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class GainsDifference : public testing::Test {
 protected:
  const std::shared_ptr<const RobotModel> arm_ = test::scenario_of("moving_target").robot;
  const RobotModel& robot_ = *arm_;
  const std::vector<std::string> joints_ = joint_names(robot_);
  const Gains published_ = load_gains("published", joints_);
};

TEST_F(GainsDifference, ShowsWhatDiffersWithUnitAndRatio) {
  Gains tuned = published_;
  tuned.task_space_gains_p[3] *= 2.5;
  tuned.task_space_gains_d[2] *= 0.5;
  tuned.slerp_reference = SlerpReference::kCurrent;
  tuned.joint_centering_gain = 4.0;
  const std::string table = gains_difference({{"published", published_}, {"tuned", tuned}}, joints_);
  EXPECT_THAT(table, ContainsRegex("task_space_gains_p/rx +1/s +25 +62\\.5 +2\\.5\n"));
  EXPECT_THAT(table, ContainsRegex("task_space_gains_d/elbow_joint +N m s/rad +200 +100 +0\\.5\n"));
  EXPECT_THAT(table, ContainsRegex("slerp_reference +start +current"));
  EXPECT_THAT(table, ContainsRegex("joint_centering_gain +[^ ]+ +0 +4 *\n")) << "no ratio to nothing";
  EXPECT_THAT(table, AllOf(Not(HasSubstr("gains_p/ry")), Not(HasSubstr("controller"))));
  // Four rows, and all that both have in one number.
  std::size_t all = 1;
  for (const GainField& field : fields_of(published_))
    all += field.is_number() ? numbers(published_, field).size() : 1;
  EXPECT_THAT(table, HasSubstr(std::to_string(all - 4) + " of " + std::to_string(all) + " values are"));
}

TEST_F(GainsDifference, SeesTheLastBit) {
  Gains other = published_;
  other.slerpDurationErrorGain = std::nextafter(other.slerpDurationErrorGain, 9.0);
  EXPECT_THAT(gains_difference({{"a", published_}, {"b", other}}, joints_),
              ContainsRegex("slerpDurationErrorGain +s/rad +2\\.5 +2\\.5000000000000004 +1\\+2\\.2e-16"));
  EXPECT_THAT(gains_difference({{"a", published_}, {"b", published_}}, joints_),
              HasSubstr(" values are the same"));
}

TEST_F(GainsDifference, OneNumberPerForcePointIsTheSameAsAListOfEqualOnes) {
  Gains lists = published_;
  lists.force_control_gains.resize(36);
  for (Eigen::Index i = 0; i < 6; ++i)
    lists.force_control_gains.segment(6 * i, 6).setConstant(published_.force_control_gains[i]);
  EXPECT_THAT(gains_difference({{"numbers", published_}, {"lists", lists}}, joints_),
              HasSubstr(" values are the same"));
  lists.force_control_gains[2 * 6 + 1] *= 3.0;
  for (const auto& [first, second, ratio] :
       {std::tuple(published_, lists, "100 +300 +3\n"), std::tuple(lists, published_, "300 +100 +0\\.333")}) {
    EXPECT_THAT(
        gains_difference({{"a", first}, {"b", second}}, joints_),
        ContainsRegex(std::string("force_control_gains/elbow_joint/shoulder_lift_joint +N +") + ratio));
  }
}

TEST_F(GainsDifference, AGainThatAControllerHasNotIsADash) {
  const Gains other = convert_gains(controller_kind("joint_pd"), published_, robot_,
                                    in_si(robot_, published_.joint_space_goal));
  const std::string table = gains_difference({{"a", published_}, {"b", other}}, joints_);
  EXPECT_THAT(table, ContainsRegex("controller +adaptive +joint_pd"));
  EXPECT_THAT(table, ContainsRegex("task_space_gains_d/elbow_joint +N m s/rad +200 +- *\n"));
  EXPECT_THAT(table, ContainsRegex("joint_pd_p/elbow_joint .* - +[0-9]"));
}

}  // namespace gains_difference_test
}  // namespace armtune::internal

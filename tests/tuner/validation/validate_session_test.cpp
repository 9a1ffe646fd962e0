#include "tuner/validation/session/validate_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/validation/written_log.hpp"
#include "tuner/report/run_report.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace validate_session_test {

namespace fs = std::filesystem;

const std::atomic<bool> kNever{false};

class ASessionThatValidates : public ::testing::Test {
 protected:
  RobotModel model_ = test::validation_arm("ur5e");
  test::TemporaryFolder files_;

  ValidateOutcome run(const Chain& arm, const test::WrittenLog& how, const std::string& folder) {
    test::Recording recording;
    recording.duration = 12.0;
    recording.rate = 125.0;
    ValidateSettings settings;
    settings.model = std::make_shared<const RobotModel>(model_);
    settings.logs = {
        files_.write("log.csv", test::log_text(model_, test::recorded(model_, arm, recording), how))};
    if (!folder.empty()) settings.folder = files_ / folder;
    SessionObserver silent;
    return ValidateSession(settings, {kNever}, silent).run();
  }
};

TEST_F(ASessionThatValidates, PassesTheLogOfTheSameArmAndWritesItsFiles) {
  const ValidateOutcome outcome = run(model_.chain, {}, "run");
  EXPECT_EQ(outcome.ending, Ending::kPassed);
  ASSERT_TRUE(outcome.found.torques);
  EXPECT_FALSE(outcome.found.motion);
  for (const std::string& file : outcome.files)
    EXPECT_TRUE(fs::is_regular_file(files_ / ("run/" + file))) << file;
  const ValidationFacts facts = find_run_record(files_ / "run")->validation.value();
  EXPECT_TRUE(facts.matches);
  EXPECT_EQ(facts.joints.size(), 6U);
  for (const JointMatchFact& joint : facts.joints) EXPECT_GT(joint.explained.value(), 0.99) << joint.joint;
  EXPECT_FALSE(facts.not_compared.empty()) << "there are no commands";
  EXPECT_EQ(facts.thresholds.size(), validation_threshold_fields().size());

  const auto table = test::read_csv(files_ / "run/residuals.csv");
  EXPECT_EQ(static_cast<Eigen::Index>(table.rows.size()), outcome.found.torques->rows.count());
  const report::ReportData data = report::report_of(files_ / "run");
  EXPECT_EQ(data.kind, RunKind::kValidate);
  EXPECT_THAT(data.left_out, testing::IsEmpty());
  ASSERT_TRUE(data.validation);
  EXPECT_EQ(data.validation->torques.size(), 6U);
  for (const auto& torque : data.validation->torques) {
    ASSERT_EQ(torque.measured.steps.size(), data.validation->time.steps.size());
    // A thinned point is the extreme of a bucket, so the law holds where every row is kept.
    if (data.validation->time.steps.size() != table.rows.size()) continue;
    const double step = (torque.measured.hi - torque.measured.lo) / report::Series::kSteps;
    for (std::size_t i = 0; i < torque.measured.steps.size(); ++i)
      EXPECT_NEAR(torque.measured.at(i) - torque.predicted.at(i), torque.residual.at(i), 3.0 * step);
  }
}

TEST_F(ASessionThatValidates, NamesTheJointWhoseFrictionTheFileLacks) {
  RobotModel arm = model_;
  arm.chain.coulomb_friction[4] += 0.3 * model_.joints[4].limits.effort;
  const ValidateOutcome outcome = run(arm.chain, {}, "run");
  EXPECT_EQ(outcome.ending, Ending::kChecksFailed);
  const ValidationFacts facts = find_run_record(files_ / "run")->validation.value();
  EXPECT_FALSE(facts.matches);
  EXPECT_FALSE(facts.joints[4].matches);
  EXPECT_THAT(facts.headline, testing::HasSubstr(model_.joints[4].name));
  ASSERT_FALSE(facts.misfit.empty());
  EXPECT_EQ(facts.misfit.front().kind, "coulomb_friction");
  EXPECT_EQ(facts.misfit.front().joint, model_.joints[4].name);
  EXPECT_NEAR(facts.misfit.front().value, 0.3 * model_.joints[4].limits.effort, 0.5);
  EXPECT_THAT(facts.findings, testing::IsEmpty());
}

TEST_F(ASessionThatValidates, RecordsWhatIsWrongWithTheLogInFields) {
  RobotModel arm = model_;
  arm.chain.gravity *= -1.0;
  run(arm.chain, {}, "run");
  const ValidationFacts facts = find_run_record(files_ / "run")->validation.value();
  ASSERT_EQ(facts.findings.size(), 1U);
  EXPECT_EQ(facts.findings[0].kind, "mounting");
  EXPECT_EQ(facts.findings[0].joint, "");
  EXPECT_FALSE(facts.findings[0].text.empty());
  EXPECT_THAT(report::report_of(files_ / "run").verdict.details,
              testing::Contains(testing::HasSubstr(facts.findings[0].text)));
}

TEST_F(ASessionThatValidates, JudgesTheLogAloneWithoutTorquesAndCommands) {
  const ValidateOutcome outcome = run(model_.chain, {.torques = false}, "");
  EXPECT_EQ(outcome.ending, Ending::kPassed);
  EXPECT_FALSE(outcome.found.torques);
  EXPECT_EQ(outcome.found.not_compared.size(), 2U);
  EXPECT_TRUE(outcome.files.empty());
  const ValidateOutcome degrees =
      run(model_.chain, {.angle = 180.0 / M_PI, .unit = " [rad]", .torques = false}, "");
  EXPECT_EQ(degrees.ending, Ending::kChecksFailed) << "the file says radians and has degrees";
  EXPECT_FALSE(degrees.found.findings.empty());
}

TEST_F(ASessionThatValidates, SimulatesTheMotionUnderLoggedCommands) {
  const ValidateOutcome outcome = run(model_.chain, {.commands = true}, "run");
  ASSERT_TRUE(outcome.found.motion);
  EXPECT_EQ(outcome.found.motion->kind, CommandKind::kPosition);
  const report::ReportData data = report::report_of(files_ / "run");
  ASSERT_TRUE(data.validation);
  EXPECT_EQ(data.validation->horizons, outcome.found.motion->horizons);
  EXPECT_EQ(data.validation->motion.size(), 6U);
}

}  // namespace validate_session_test
}  // namespace armtune::internal

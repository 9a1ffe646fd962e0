#include "tuner/calibration/session/calibrate_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/calibration/hidden_log.hpp"
#include "tuner/calibration/calibration_files.hpp"
#include "tuner/report/run_report.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal {
namespace calibrate_session_test {

namespace fs = std::filesystem;
using test::HiddenArm;
using test::refused_at;
using test::TemporaryFolder;

const std::atomic<bool> kNever{false};

CalibrateSettings settings_of(const RobotModel& model, std::vector<std::string> logs) {
  CalibrateSettings settings;
  settings.model = std::make_shared<const RobotModel>(model);
  settings.logs = std::move(logs);
  return settings;
}

CalibrateOutcome run(const CalibrateSettings& settings, const std::atomic<bool>& stop = kNever) {
  SessionObserver silent;
  return CalibrateSession(settings, {stop}, silent).run();
}

/// An arm that was calibrated from a short log of torque commands, in a run folder.
struct Calibrated {
  TemporaryFolder files;
  HiddenArm arm = test::hidden_arm(*load_robot("ur5e"), 11, 125.0);
  std::string log =
      files.write("log.csv", test::hidden_log_text(arm.model, test::short_torque_log(arm, 9.0)));
  CalibrateOutcome outcome = [this] {
    CalibrateSettings settings = settings_of(arm.model, {log});
    settings.folder = files / "run";
    return run(settings);
  }();
};
const Calibrated& calibrated() {
  static const Calibrated once;
  return once;
}

TEST(ASessionThatCalibrates, PassesBecauseTheErrorOnTheHeldOutPartFalls) {
  const Calibrated& c = calibrated();
  EXPECT_EQ(c.outcome.ending, Ending::kPassed);
  EXPECT_LT(c.outcome.facts.error_ratio.value(), 0.5);
  for (const std::string& file : c.outcome.files)
    EXPECT_TRUE(fs::is_regular_file(c.files / ("run/" + file))) << file;
}

TEST(ASessionThatCalibrates, RecordsWhatItFound) {
  const Calibrated& c = calibrated();
  const RunRecord record = find_run_record(c.files / "run").value();
  EXPECT_EQ(record.kind, RunKind::kCalibrate);
  EXPECT_EQ(record.calibration.value(), c.outcome.facts);
  EXPECT_EQ(record.calibration->commands, "torque");
  EXPECT_NEAR(record.calibration->duration, 9.0, 0.1);
  std::vector<std::string> untold;
  for (const UntoldFact& fact : record.calibration->not_told) untold.push_back(fact.parameter);
  std::vector<std::string> expected;
  for (const FittedParameter& p : c.outcome.found.parameters)
    if (!p.told) expected.push_back(p.prior.name);
  EXPECT_EQ(untold, expected);
  EXPECT_THAT(untold, testing::Contains("shoulder_pan_joint/encoder_offset")) << "no motion tells it";
  EXPECT_THAT(record.inputs, testing::Contains(testing::Field(&InputFact::path, c.log)));
}

TEST(ASessionThatCalibrates, WritesARobotThatReadsBackAsTheCalibratedOne) {
  const Calibrated& c = calibrated();
  const auto robot = load_robot(c.files / "run/robot.yaml");
  const RobotModel expected = calibrated_model(c.arm.model, c.outcome.found);
  EXPECT_TRUE(robot->chain.coulomb_friction.isApprox(expected.chain.coulomb_friction, 1e-12));
  EXPECT_TRUE(robot->chain.viscous_friction.isApprox(expected.chain.viscous_friction, 1e-12));
  EXPECT_TRUE(robot->chain.rotor_inertia.isApprox(expected.chain.rotor_inertia, 1e-12));
  EXPECT_NEAR(robot->chain.link.back().mass, expected.chain.link.back().mass, 1e-9);
  EXPECT_FALSE(robot->chain.coulomb_friction.isApprox(c.arm.model.chain.coulomb_friction, 0.05));
}

TEST(ASessionThatCalibrates, ShowsEveryParameterInItsTableAndOnThePage) {
  const Calibrated& c = calibrated();
  const std::vector<FittedParameter>& parameters = c.outcome.found.parameters;
  const report::ReportData data = report::report_of(c.files / "run");
  EXPECT_EQ(data.kind, RunKind::kCalibrate);
  EXPECT_THAT(data.left_out, testing::IsEmpty());
  EXPECT_EQ(data.verdict.sentence, c.outcome.facts.headline + ".");
  ASSERT_TRUE(data.calibration);
  ASSERT_EQ(data.calibration->parameters.size(), parameters.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const report::CalibratedParameterRow& row = data.calibration->parameters[i];
    EXPECT_EQ(row.name, parameters[i].prior.name);
    EXPECT_EQ(row.unit.find(','), std::string::npos) << "of a joint that turns: " << row.unit;
    EXPECT_EQ(row.before, parameters[i].prior.nominal);
    EXPECT_EQ(row.after, parameters[i].value);
    EXPECT_EQ(row.told, parameters[i].told);
    EXPECT_EQ(row.motion.empty(), parameters[i].told);
  }
  EXPECT_EQ(data.calibration->joints.size(), 6U);
  ASSERT_EQ(data.calibration->horizons.size(), kReportedHorizons.size());
  for (std::size_t h = 0; h < kReportedHorizons.size(); ++h) {
    const double logged = c.outcome.found.after.rms(static_cast<Eigen::Index>(h), 2);
    if (!std::isfinite(logged)) continue;
    EXPECT_EQ(data.calibration->joints[2].after[h], logged);
  }
}

TEST(ASessionThatCalibrates, LeavesOutAFileOfThePageThatIsDamaged) {
  const TemporaryFolder files;
  for (const char* file : {"run.json", "held_out.csv", "parameters.csv"})
    fs::copy_file(calibrated().files / (std::string("run/") + file), files / file);
  files.write("parameters.csv", "parameter,unit\ndelay,s\n");
  const report::ReportData data = report::report_of(files.path());
  EXPECT_THAT(data.left_out, testing::ElementsAre(testing::HasSubstr("parameters.csv")));
  EXPECT_TRUE(data.calibration->parameters.empty());
  EXPECT_EQ(data.calibration->joints.size(), 6U);
  fs::remove(files / "run.json");
  EXPECT_EQ(report::report_of(files.path()).kind, RunKind::kCalibrate) << "by its other files";
}

TEST(ASessionThatCalibrates, IsNotBetterOnALogOfTheRobotFilesOwnArm) {
  const TemporaryFolder files;
  HiddenArm arm = test::hidden_arm(*load_robot("ur5e"), 11, 125.0);
  arm.truth = shooting_arm(arm.model);
  const std::string log =
      files.write("log.csv", test::hidden_log_text(arm.model, test::short_torque_log(arm, 5.0)));
  CalibrateSettings settings = settings_of(arm.model, {log});
  settings.folder = files / "run";
  const CalibrateOutcome outcome = run(settings);
  EXPECT_GE(outcome.facts.error_ratio.value(), 1.0);
  EXPECT_EQ(outcome.ending, Ending::kChecksFailed);
  EXPECT_THAT(outcome.files, testing::Contains("parameters.csv"));
  for (const char* file : {"robot.yaml", "robot.urdf", "uncertainty.yaml"})
    EXPECT_FALSE(fs::exists(files / (std::string("run/") + file))) << "nobody should use it: " << file;
}

TEST(ASessionThatCalibrates, EndsWithoutFilesIfItIsStopped) {
  const Calibrated& c = calibrated();
  CalibrateSettings settings = settings_of(c.arm.model, {c.log});
  settings.folder = c.files / "stopped";
  const std::atomic<bool> stop{true};
  EXPECT_EQ(run(settings, stop).ending, Ending::kInterrupted);
  EXPECT_FALSE(fs::exists(settings.folder));

  // Stopped during the fit.
  struct Stopper : SessionObserver {
    void progressed(const Progress& progress) override {
      if (progress.work.find("iteration") != std::string::npos) flag = true;
    }
    std::atomic<bool> flag{false};
  } stopper;
  EXPECT_EQ(CalibrateSession(settings, {stopper.flag}, stopper).run().ending, Ending::kInterrupted);
  EXPECT_FALSE(fs::exists(settings.folder));
}

TEST(ASessionThatCalibrates, RefusesLogsThatItCannotUse) {
  const Calibrated& c = calibrated();
  const TemporaryFolder files;
  const CommandedLog made = test::short_torque_log(c.arm, 1.5);
  const std::string bare = files.write("bare.csv", test::hidden_log_text(c.arm.model, made, false));
  EXPECT_THAT([&] { return run(settings_of(c.arm.model, {bare})); },
              (refused_at({.file = bare, .key = "--commands", .value = "none"})));
  const std::string brief = files.write("brief.csv", test::hidden_log_text(c.arm.model, made));
  EXPECT_THAT([&] { return run(settings_of(c.arm.model, {brief})); },
              (refused_at({.file = brief, .key = "time"})));
  const RobotModel panda = *load_robot("panda");
  EXPECT_THAT([&] { return run(settings_of(panda, {c.log})); },
              (refused_at({.file = c.log, .key = "position"})));
  const std::string slower = files.write(
      "slower.csv", test::hidden_log_text(c.arm.model, test::short_torque_log(c.arm, 5.0, 100.0)));
  EXPECT_THAT(
      [&] {
        return run(settings_of(c.arm.model, {c.log, slower}));
      },
      (refused_at({.file = slower, .key = "command time", .limit = "125 Hz"})));
  CalibrateSettings velocity = settings_of(c.arm.model, {c.log});
  velocity.options.command = CommandKind::kVelocity;
  EXPECT_THAT([&] { return run(velocity); },
              (refused_at({.file = c.log, .key = "--commands", .value = "velocity"})));
  CalibrateSettings used = settings_of(c.arm.model, {c.log});
  used.folder = c.files / "run";
  EXPECT_THAT([&] { return run(used); }, (refused_at({.file = c.files / "run"})));
}

}  // namespace calibrate_session_test
}  // namespace armtune::internal

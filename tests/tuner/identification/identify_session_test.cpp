#include "tuner/identification/session/identify_session.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "armtune/error.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/scenario.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/identification/excitation_design.hpp"
#include "tuner/identification/excitation_log.hpp"

namespace armtune::internal {
namespace identify_session_test {

namespace fs = std::filesystem;

const std::atomic<bool> kNever{false};

ExcitationLog exciting_log(const RobotModel& arm) {
  ExcitationOptions options;
  options.center.resize(6);
  options.center << 0.0, -1.5, -1.0, -1.5, 1.5, 0.0;
  options.min_height = 0.1;
  options.evaluations = 100;
  const Excitation excitation = design_excitation(arm, options, kNever).excitation;
  return simulate_excitation(load_scenario("moving_target"), excitation, {}, kNever);
}

TEST(IdentifySession, GivesWhatIdentifyGivesAndWritesNothingItDoubts) {
  const test::TemporaryFolder files;
  const auto arm = load_robot("ur10");
  ExcitationLog log = exciting_log(*arm);
  IdentifySettings settings;
  settings.model = arm;
  settings.columns = default_log_columns(*arm);
  settings.logs = {files.write("log.csv", log_csv(*arm, log))};
  SessionObserver silent;
  const Identification found = identify(*arm, settings.logs, settings.columns, {}, kNever);
  const IdentifyOutcome bare = IdentifySession(settings, {kNever}, silent).run();
  settings.folder = files / "run";
  const IdentifyOutcome kept = IdentifySession(settings, {kNever}, silent).run();
  EXPECT_EQ(bare.found.theta, found.theta);
  EXPECT_EQ(kept.found.theta, found.theta);
  EXPECT_EQ(bare.ending, Ending::kPassed);
  EXPECT_TRUE(bare.files.empty());
  EXPECT_FALSE(kept.files.empty());
  for (const std::string& file : kept.files)
    EXPECT_TRUE(fs::is_regular_file(files / ("run/" + file))) << file;

  for (LogSample& sample : log.samples) sample.torque[1] *= -1.0;
  settings.logs = {files.write("wrong.csv", log_csv(*arm, log))};
  settings.folder = files / "doubted";
  const IdentifyOutcome doubted = IdentifySession(settings, {kNever}, silent).run();
  EXPECT_EQ(doubted.ending, Ending::kChecksFailed);
  EXPECT_FALSE(doubted.doubts.empty());
  EXPECT_FALSE(fs::exists(settings.folder));

  settings.logs = {files / "missing.csv"};
  EXPECT_THROW(IdentifySession(settings, {kNever}, silent).run(), InputError);
  EXPECT_FALSE(fs::exists(settings.folder));
}

}  // namespace identify_session_test
}  // namespace armtune::internal

// From a robot's own files to tuned gains: armtune init, and armtune tune --controllers.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <regex>
#include <sstream>

#include "core/control/laws/first_gains.hpp"
#include "sim/scenario/scenario.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace init_test {

using test::Finished;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;

const std::string kExample = test::source_dir() + "/examples/joint_trajectory/";

/// The words of `command` for the example, with more behind them.
std::vector<std::string> of_example(const std::string& command, const std::vector<std::string>& more) {
  std::vector<std::string> words = {command,
                                    "--robot",
                                    "ur5e",
                                    "--controllers",
                                    kExample + "ros2_controllers.yaml",
                                    "--trajectory",
                                    kExample + "moves.csv"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Lines of two texts that differ, of the second.
std::vector<std::string> changed_lines(const std::string& before, const std::string& after) {
  std::istringstream a(before), b(after);
  std::vector<std::string> changed;
  for (std::string x, y; std::getline(a, x) && std::getline(b, y);) {
    if (x != y) changed.push_back(y);
  }
  return changed;
}

TEST(OwnFiles, AreTunedIntoTheSameParameterFileWithOtherNumbers) {
  const test::TemporaryFolder folder;
  const std::string run = folder / "moves";
  const Finished tuned =
      run_program(of_example("tune", {"--max-evaluations", "60", "--workers", "2", "--out", run + "/"}));
  ASSERT_EQ(tuned.exit_code, 0) << tuned.err << tuned.out;
  EXPECT_THAT(tuned.out,
              AllOf(HasSubstr("note: "), HasSubstr("straight lines"), HasSubstr("joint_error/rms"),
                    HasSubstr("only the gains are changed"), HasSubstr("Simulation checks: passed")));
  const std::string before = test::read_text(kExample + "ros2_controllers.yaml");
  const std::string after = test::read_text(run + "/ros2_controllers.yaml");
  const auto lines = changed_lines(before, after);
  EXPECT_EQ(lines.size(), 6U);
  for (const std::string& line : lines) EXPECT_THAT(line, HasSubstr("joint: {p: "));
  EXPECT_TRUE(std::filesystem::exists(folder / "moves_study/study.yaml")) << "beside the run";
  // The run is known by its folder alone, and the study can be tuned by itself.
  EXPECT_THAT(run_program({"tune", "--resume", run}).out, HasSubstr("this run is finished"));
  const Finished by_study = run_program(
      {"tune", folder / "moves_study/study.yaml", "--max-evaluations", "60", "--out", folder / "again"});
  EXPECT_EQ(by_study.exit_code, 0) << by_study.err;
  EXPECT_EQ(test::read_text(folder / "again/ros2_controllers.yaml"), after);
}

TEST(OwnFiles, AreNotChangedWhereChecksWereLeftOut) {
  const test::TemporaryFolder folder;
  const std::string run = folder / "moves";
  const Finished tuned =
      run_program(of_example("tune", {"--max-evaluations", "8", "--no-analysis", "--out", run}));
  EXPECT_THAT(tuned.out, AllOf(HasSubstr("ros2_controllers.yaml with the tuned gains was not written"),
                               HasSubstr("--into " + kExample + "ros2_controllers.yaml")));
  EXPECT_TRUE(std::filesystem::exists(run + "/gains.yaml"));
  EXPECT_FALSE(std::filesystem::exists(run + "/ros2_controllers.yaml"));
  // The same again: its study is there already, and its run's folder is not to be overwritten.
  const Finished again =
      run_program(of_example("tune", {"--max-evaluations", "8", "--no-analysis", "--out", run}));
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.err, HasSubstr("moves"));
  std::filesystem::remove_all(run);
  EXPECT_NE(
      run_program(of_example("tune", {"--max-evaluations", "8", "--no-analysis", "--out", run})).exit_code,
      2);
}

TEST(OwnFiles, BecomeAStudyThatIsNotTunedYet) {
  const test::TemporaryFolder folder;
  const Finished made = run_program(of_example("init", {"--out", folder / "my study"}));
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, AllOf(HasSubstr("study.yaml, moves.yaml"),
                              HasSubstr("tune '" + (folder / "my study/study.yaml") + "'")));
  EXPECT_FALSE(std::filesystem::exists(folder / "my study/gains.yaml"));
}

TEST(OwnFiles, TheDistributionThatIsFollowedIsNamed) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(run_program(of_example("init", {"--out", folder / "jazzy"})).out, HasSubstr("ROS 2 Jazzy"));
  const std::string run = folder / "run";
  const Finished tuned = run_program(
      of_example("tune", {"--distro", "humble", "--max-evaluations", "8", "--no-analysis", "--out", run}));
  EXPECT_THAT(tuned.out, HasSubstr("ROS 2 Humble"));
  EXPECT_THAT(test::read_text(folder / "run_study/study.yaml"), HasSubstr("\ndistro: humble\n"));
  EXPECT_THAT(test::read_text(run + "/gains.yaml"), HasSubstr("jtc_distro: 1.0"));
  EXPECT_THAT(test::read_text(run + "/verdict.yaml"), HasSubstr("ROS 2 Humble"));
  const Finished exported = run_program(
      {"export", run, "--into", kExample + "ros2_controllers.yaml", "--out", folder / "new.yaml"});
  EXPECT_EQ(exported.exit_code, 0) << exported.err;
  EXPECT_EQ(run_program(of_example("init", {"--distro", "rolling", "--out", folder / "none"})).exit_code, 2);
}

TEST(OwnFiles, MotionsCanBeSlowedDown) {
  const test::TemporaryFolder folder;
  const Finished made = run_program(of_example("init", {"--speed", "0.25", "--out", folder / "slow"}));
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(test::read_text(folder / "slow/moves.yaml"), HasSubstr("speed: 0.25"));
  EXPECT_EQ(run_program(of_example("init", {"--speed", "0", "--out", folder / "none"})).exit_code, 2);
}

// Both are inputs: the map, and the file that has the numbers.
TEST(OwnFiles, ARunWithAMapOfGainsKeepsItAndTheFileThatItNames) {
  const test::TemporaryFolder folder;
  run_program(of_example("init", {"--out", folder / "study"}));
  folder.write("numbers.yaml", "stiff: 400.0\n");
  std::string map = "controller: joint_impedance\nfile: numbers.yaml\nmap:\n";
  map += "  stiff: joint_impedance_k/elbow_joint\njoint_impedance_d: 20\njoint_impedance_k: 300\n";
  const std::string gains = folder.write("map.yaml", map);
  const std::string scenario = folder / "study/moves.yaml";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"simulate", scenario, "--gains", gains, "--engine", "native"},
        {"compare", gains, gains, "--scenarios", scenario},
        {"robustness", gains, "--scenarios", scenario, "--samples", "2"}}) {
    std::vector<std::string> all = words;
    const std::string run = folder / words[0];
    all.insert(all.end(), {"--out", run});
    const Finished done = run_program(all);
    EXPECT_TRUE(done.exit_code == 0 || done.exit_code == 3) << words[0] << ": " << done.err;
    EXPECT_THAT(test::read_text(run + "/run.json"), AllOf(HasSubstr("map.yaml"), HasSubstr("numbers.yaml")))
        << words[0];
  }
}

TEST(OwnFiles, AStreamOfPositionsIsTunedWithoutAParameterFile) {
  const test::TemporaryFolder folder;
  const std::vector<std::string> words = {
      "--robot", "ur5e", "--controller", "position_streaming", "--trajectory", kExample + "moves.csv"};
  const auto with = [&words](const std::string& command, const std::vector<std::string>& more) {
    std::vector<std::string> all = {command};
    all.insert(all.end(), words.begin(), words.end());
    all.insert(all.end(), more.begin(), more.end());
    return run_program(all);
  };
  const Finished made = with("init", {"--rate", "500", "--out", folder / "study"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(test::read_text(folder / "study/gains.yaml"), HasSubstr("servo_lookahead_time: 0.1"));
  EXPECT_THAT(with("init", {"--out", folder / "none"}).err, HasSubstr("--rate"));

  const std::string run = folder / "run";
  const Finished tuned = with("tune", {"--rate", "500", "--max-evaluations", "30", "--out", run});
  ASSERT_EQ(tuned.exit_code, 0) << tuned.err << tuned.out;
  EXPECT_THAT(tuned.out, AllOf(HasSubstr("Simulation checks: passed"), HasSubstr("position_streaming.md")));
  EXPECT_THAT(test::read_text(run + "/gains.yaml"), HasSubstr("servo_gain: "));
  EXPECT_THAT(run_program({"tune", "--resume", run}).out, HasSubstr("this run is finished"));
}

/// The joint that oscillates, its frequency [Hz], and since when [s].
struct Shaking {
  std::string joint;
  double frequency = 0.0;
  double since = -1.0;
};

/// Reads it from a text that contains `pattern`, whose groups are joint, frequency and time.
Shaking shaking_in(const std::string& text, const char* pattern) {
  std::smatch found;
  if (!std::regex_search(text, found, std::regex(pattern))) return {};
  return {found[1], std::stod(found[2]), std::stod(found[3])};
}

// The wrist has the published gains of a package for simulators. For the inertia that it moves, the joint is
// a spring of 500 N m/rad with too little damping.
TEST(OwnFiles, GainsThatShakeAreDiagnosedAndReplacedByOnesThatPass) {
  const test::TemporaryFolder folder;
  std::string text = test::read_text(kExample + "ros2_controllers.yaml");
  const std::string wrist = "wrist_1_joint: {p: 300.0, d: 10.0";
  ASSERT_NE(text.find(wrist), std::string::npos);
  text.replace(text.find(wrist), wrist.size(), "wrist_1_joint: {p: 500.0, d: 1.0");
  const std::string shaky = folder.write("shaky.yaml", text);
  const std::vector<std::string> inputs = {"--robot", "ur5e",         "--controllers",
                                           shaky,     "--trajectory", kExample + "moves.csv"};
  const auto with = [&inputs](const std::string& command, const std::vector<std::string>& more) {
    std::vector<std::string> words = {command};
    words.insert(words.end(), inputs.begin(), inputs.end());
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  };
  ASSERT_EQ(with("init", {"--out", folder / "study"}).exit_code, 0);
  const std::string scenario = folder / "study/moves.yaml";
  const auto simulate = [&](const std::string& gains, const std::string& out) {
    return run_program({"simulate", scenario, "--gains", gains, "--engine", "native", "--out", out});
  };
  EXPECT_EQ(simulate(shaky, folder / "before").exit_code, 3);
  std::smatch seen;
  const std::string verdict = test::read_text(folder / "before/verdict.yaml");
  const std::regex oscillation(
      "check: \"oscillation\", passed: false, [^\n]*joint: \"(\\w+)\", time: ([0-9.e-]+), [^\n]* at ([0-9.]+) Hz");
  ASSERT_TRUE(std::regex_search(verdict, seen, oscillation)) << verdict;
  EXPECT_EQ(seen[1], "wrist_1_joint");
  // An undamped joint oscillates at sqrt(p / inertia). Delay and the motion of other joints change that a
  // bit.
  const Scenario moves = load_scenario(scenario);
  const double inertia = joint_inertia(*moves.robot, moves.start_position)[3];
  const double expected = std::sqrt(500.0 / inertia) / (2.0 * std::numbers::pi);
  EXPECT_NEAR(std::stod(seen[3]), expected, 0.3 * expected);

  const Finished tuned =
      with("tune", {"--max-evaluations", "12", "--no-analysis", "--workers", "2", "--out", folder / "run"});
  ASSERT_EQ(tuned.exit_code, 0) << tuned.err << tuned.out;
  const Shaking said =
      shaking_in(tuned.err, "(\\w+) oscillates: [^\n]* at ([0-9.]+) Hz, from ([0-9.]+) s on");
  EXPECT_EQ(said.joint, "wrist_1_joint") << tuned.err;
  EXPECT_EQ(said.frequency, std::stod(seen[3])) << "as simulate says";
  EXPECT_NEAR(said.since, std::stod(seen[2]), 1e-3);
  const Finished after = simulate(folder / "run/gains.yaml", folder / "after");
  EXPECT_EQ(after.exit_code, 0) << after.out;
  EXPECT_THAT(test::read_text(folder / "after/verdict.yaml"),
              HasSubstr("check: \"oscillation\", passed: true"));
}

TEST(OwnFiles, OptionsThatMeanNothingTogetherAreRefused) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"tune", "ur10_gaze", "--robot", "ur5e", "--controllers", "a", "--trajectory",
                                 "b"},
        {"tune", "--robot", "ur5e"},
        {"tune", "--robot", "ur5e", "--controllers", "a"},
        {"tune", "--robot", "ur5e", "--controllers", "a", "--trajectory", "b", "--controller", "joint_pd"},
        {"tune", "--robot", "ur5e", "--trajectory", "b"},
        {"tune", "ur10_gaze", "--degrees"},
        {"tune", "ur10_gaze", "--rate", "500"},
        {"tune", "ur10_gaze", "--speed", "0.5"},
        {"init", "--robot", "ur5e", "--trajectory", "b", "--rate", "500", "--out", "c"},
        {"init", "--robot", "ur5e", "--controllers", "a", "--trajectory", "b"}}) {
    const Finished refused = run_program(words);
    EXPECT_EQ(refused.exit_code, 2) << words[1];
    EXPECT_EQ(refused.out, "") << words[1];
  }
}

}  // namespace init_test
}  // namespace armtune::internal

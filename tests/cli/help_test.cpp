#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "sim/metrics/metric.hpp"
#include "tests/cli/support/program.hpp"
#include "tuner/cli/declared/short_help.hpp"
#include "tuner/solver/solver.hpp"

namespace armtune::internal {
namespace help_test {

using test::Finished;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;

TEST(Help, OfTheProgramShowsHowToBeginAndWhatExitCodesMean) {
  const Finished help = run_program({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  EXPECT_THAT(help.out, AllOf(HasSubstr("armtune simulate moving_target"), HasSubstr("130 interrupted")));
}

/// What `armtune COMMAND OPTION` prints, every run of blanks as one: descriptions are wrapped.
std::string help(const std::string& command, const char* option = "--help") {
  const Finished finished = run_program({command, option});
  EXPECT_EQ(finished.exit_code, 0) << command;
  EXPECT_EQ(finished.err, "") << command;
  return std::regex_replace(finished.out, std::regex(" *\n *"), " ");
}

/// The options that a help lists, those that show help left out.
std::vector<std::string> options(const std::string& command, const char* option) {
  const std::string text = run_program({command, option}).out;
  const std::regex line("\n  (?:-[a-z],)?(--[a-z-]+)");
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it) {
    if (!(*it)[1].str().starts_with("--help")) found.push_back((*it)[1]);
  }
  return found;
}

std::vector<std::string> commands() {
  std::istringstream lines(run_program({"--help"}).out);
  std::vector<std::string> found;
  bool listed = false;
  for (std::string line; std::getline(lines, line);) {
    if (listed && line.starts_with("  ")) found.push_back(line.substr(2, line.find(' ', 2) - 2));
    listed = listed || line == "Subcommands:";
  }
  return found;
}

TEST(Help, OfEveryCommandEndsWithTheExitCodesOnce) {
  EXPECT_THAT(commands(), testing::IsSupersetOf({"robot", "simulate", "tune", "compare"}));
  for (const std::string& command : commands()) {
    const std::string text = help(command);
    const auto codes = text.find("Exit codes: ");
    ASSERT_NE(codes, std::string::npos) << command;
    EXPECT_EQ(text.find("Exit codes: ", codes + 1), std::string::npos) << command;
    EXPECT_THAT(text.substr(codes), HasSubstr("130 interrupted")) << command;
  }
}

TEST(Help, OfEveryCommandShowsTheOptionsThatABeginnerNeeds) {
  const std::map<std::string, std::vector<std::string>> expected = {
      {"simulate", {"--out"}},
      {"tune", {"--max-evaluations", "--seed", "--warm-start"}},
      {"robustness", {"--payload", "--limit"}},
      {"margins", {"--limit"}},
      {"plan", {"--knots"}},
      {"report", {"--out"}}};
  for (const auto& [command, names] : expected)
    EXPECT_THAT(options(command, "--help"), testing::IsSupersetOf(names)) << command;
  for (const char* command : {"tune", "pareto", "robustness", "sensitivity"})
    EXPECT_THAT(options(command, "--help-all"), testing::Contains("--rollout-deadline")) << command;
}

TEST(Help, OfEveryCommandNamesWhatIsBundledAndWhatItDoes) {
  const std::pair<const char*, std::vector<const char*>> expected[] = {
      {"robot", {"ur10"}},
      {"simulate", {"moving_target", "realistic_obstacle_pass", "published", "report.html"}},
      {"tune", {"ur10_gaze", "armtune metrics", "armtune algorithms", "armtune controllers"}},
      {"robustness", {"1000", "report.html"}},
      {"margins", {"control_rate", "1 % of the control periods", "armtune margins extended_tuned"}},
      {"plan", {"ur10_switch", "fastest", "slowly first"}},
      {"yardstick", {"RUN", "a local optimum"}},
      {"compare", {"report.html"}},
      {"report", {"DIR", "report.html"}}};
  for (const auto& [command, texts] : expected) {
    const std::string shown = help(command);
    for (const char* text : texts) EXPECT_THAT(shown, HasSubstr(text)) << command;
  }
  EXPECT_THAT(help("simulate", "--help-all"), HasSubstr("midpoint"));
  for (const char* command : {"tune", "pareto", "robustness", "sensitivity"})
    EXPECT_THAT(help(command, "--help-all"), HasSubstr("every rank is one worker")) << command;
}

// CLI11 has them between an option's name and its description, where they read as one sentence.
TEST(Help, LimitsDefaultsAndOtherOptionsStandBehindADescription) {
  EXPECT_THAT(help("margins"), testing::ContainsRegex("--workers INT [^-]*\\(1 to 1024; default: one per "
                                                      "processor\\)"));
  EXPECT_THAT(help("tune"), HasSubstr("(at least 1; default: study's value)"));
  EXPECT_THAT(help("tune", "--help-all"), HasSubstr("(default: rad; only with")) << "a flag has one as well";
  const std::string extended = help("simulate");
  const std::string endurance = extended.substr(extended.find("--endurance"));
  EXPECT_THAT(endurance.substr(0, endurance.find(" --yardstick")), testing::Not(HasSubstr("default:")))
      << "its default is that of its value";
  EXPECT_THAT(help("compare"), HasSubstr("(not with --gains)"));
  EXPECT_THAT(help("init"), HasSubstr("(required)"));
  EXPECT_THAT(help("simulate", "--help-all"), HasSubstr("one of: midpoint, "));
  for (const std::string& command : commands()) {
    const std::string text = help(command, "--help-all");
    for (const char* word :
         {"Excludes:", "Needs:", "REQUIRED", " in [", "{false}", "FLOAT", "UINT", "POSITIVE"})
      EXPECT_THAT(text, testing::Not(HasSubstr(word))) << command;
  }
}

TEST(Help, ShowsAtMostTenOptionsOfACommandAndSaysWhereTheOthersAre) {
  ASSERT_GE(commands().size(), 15U);
  for (const std::string& command : commands()) {
    const auto shown = options(command, "--help");
    const auto all = options(command, "--help-all");
    EXPECT_LE(shown.size(), cli::kMostOptionsOfHelp) << command;
    EXPECT_THAT(all, testing::IsSupersetOf(shown)) << command;
    EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size()) << command;
    const std::string rest = std::to_string(all.size() - shown.size()) + " more";
    const auto says = AllOf(HasSubstr(rest), HasSubstr("armtune " + command + " --help-all"));
    const std::string text = help(command);
    if (all.size() > shown.size()) {
      EXPECT_THAT(text, says) << command;
    } else {
      EXPECT_THAT(text, testing::Not(HasSubstr("more options"))) << command;
    }
    if (!all.empty()) {
      EXPECT_THAT(text.substr(text.find("Usage")), HasSubstr("armtune " + command + " ")) << "an example";
    }
  }
}

TEST(Help, HasEveryOptionThatIsChosenForItUnderItsHeading) {
  const std::string built = run_program({"--help"}).out;
  for (const cli::ShortHelp& chosen : cli::short_helps()) {
    if (built.find("\n  " + chosen.command + " ") == std::string::npos) continue;
    const std::string text = run_program({chosen.command, "--help"}).out;
    for (const cli::OptionGroup& group : chosen.groups) {
      const auto begin = text.find("\n" + group.heading + ":\n");
      ASSERT_NE(begin, std::string::npos) << chosen.command << ' ' << group.heading;
      const std::string section = text.substr(begin, text.find("\n\n", begin) - begin);
      for (const std::string& option : group.options)
        EXPECT_THAT(section, HasSubstr("\n  " + option)) << chosen.command;
    }
  }
}

TEST(Lists, HoldEveryMetricWithUnitAndDirectionAndEveryAlgorithm) {
  std::istringstream lines(run_program({"metrics"}).out);
  std::map<std::string, std::string> rows;
  for (std::string line; std::getline(lines, line);) {
    const auto end = line.find(' ', 2);
    if (line.size() > 2 && line[1] == ' ') rows.emplace(line.substr(2, end - 2), line);
  }
  for (const MetricField& field : metric_fields()) {
    ASSERT_TRUE(rows.contains(field.name)) << field.name;
    const std::string& row = rows[field.name];
    EXPECT_THAT(row, testing::EndsWith("[" + std::string(field.unit) + "]"));
    const char direction = field.better == Better::kMore ? '+' : field.better == Better::kLess ? '-' : ' ';
    EXPECT_EQ(row.front(), direction) << field.name;
  }
  const std::string algorithms_said = run_program({"algorithms"}).out;
  for (const AlgorithmInfo& algorithm : algorithms())
    EXPECT_THAT(algorithms_said, HasSubstr("\n  " + std::string(algorithm.name) + " "));
}

TEST(Help, VersionNamesTheLibraries) {
  const Finished version = run_program({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  for (const char* library : {"armtune 0.", "simbody 3.", "nlopt ", "eigen 3.", "yaml_cpp ", "open_mpi "})
    EXPECT_THAT(version.out, HasSubstr(library));
}

TEST(Help, WrongUsageEndsWithTwo) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"simulate"},
                                                    {"tun"},
                                                    {"simulate", "moving_target", "--no-such-option"},
                                                    {"tune", "--max-evaluations", "0"},
                                                    {"simulate", "moving_target", "--workers", "many"}}) {
    const Finished finished = run_program(arguments);
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_EQ(finished.out, "");
    EXPECT_NE(finished.err, "");
  }
}

TEST(Help, UsageNamesTheProgramAsUsersCallIt) {
  EXPECT_THAT(run_program({}).err, HasSubstr("Usage: armtune [OPTIONS]"));
  EXPECT_THAT(run_program({"tune", "--help"}).out, HasSubstr("Usage: armtune tune [OPTIONS]"));
}

TEST(Robot, ShowsJointsLimitsMassesAndReach) {
  const Finished shown = run_program({"robot", "ur10"});
  EXPECT_EQ(shown.exit_code, 0);
  for (const char* joint : {"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint",
                            "wrist_2_joint", "wrist_3_joint"}) {
    EXPECT_THAT(shown.out, HasSubstr(joint));
  }
  EXPECT_THAT(shown.out, AllOf(HasSubstr("6 joints"), HasSubstr("kg"), HasSubstr("reach"), HasSubstr("330"),
                               HasSubstr("2.16"), HasSubstr("12.93")));
}

TEST(Robot, SaysWhichOfItsValuesAreEstimatedUnknownOrDoubtful) {
  const Finished ur10 = run_program({"robot", "ur10"});
  EXPECT_THAT(ur10.out, HasSubstr("Joint friction: none given"));
  EXPECT_THAT(run_program({"robot", "panda"}).out, HasSubstr("* an estimate"));
  EXPECT_THAT(ur10.out, AllOf(HasSubstr("Rotor inertia: assumed"), testing::Not(HasSubstr("drawn"))));
  EXPECT_EQ(ur10.err, "");
  const Finished youbot = run_program({"robot", "youbot"});
  EXPECT_THAT(youbot.out,
              testing::Not(testing::AnyOf(HasSubstr("* an estimate"), HasSubstr("friction: none given"))));
  EXPECT_THAT(youbot.out,
              AllOf(HasSubstr("Rotor inertia: published"), HasSubstr("Viscous friction: estimated"),
                    HasSubstr("Coulomb friction: estimated"), HasSubstr("drawn (visual) shapes of "),
                    HasSubstr("arm_link_1")));
}

TEST(Help, SaysWhatIsWrongWhereTheBundledDataIsMissing) {
  ASSERT_EQ(::setenv("ARMTUNE_DATA", "/nonexistent", 1), 0);
  const Finished help = run_program({"tune", "--help"});
  ::unsetenv("ARMTUNE_DATA");
  EXPECT_EQ(help.exit_code, 2);
  EXPECT_THAT(help.err, testing::HasSubstr("/nonexistent"));
}

TEST(Help, IsACommandToo) {
  EXPECT_EQ(run_program({"help"}).out, run_program({"--help"}).out);
  const Finished of_tune = run_program({"help", "tune"});
  EXPECT_EQ(of_tune.exit_code, 0);
  EXPECT_EQ(of_tune.out, run_program({"tune", "--help"}).out);
}

TEST(Help, ACommandThatThereIsNotNamesTheOneThatWasMeant) {
  const Finished misspelt = run_program({"tun", "ur10_gaze"});
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_THAT(misspelt.err, AllOf(HasSubstr("no command 'tun'"), HasSubstr("did you mean 'tune'?")));
  EXPECT_THAT(run_program({"help", "optimize"}).err, HasSubstr("no command 'optimize'"));
}

// A roboticist with an arm of another kind is not to get a UR10's figures unasked.
TEST(Help, NoCommandTakesAnArmThatNobodyNamed) {
  const Finished tune = run_program({"tune"});
  EXPECT_EQ(tune.exit_code, 2);
  EXPECT_EQ(tune.out, "");
  EXPECT_THAT(tune.err, AllOf(HasSubstr("ur10_gaze"), HasSubstr("--controllers")));
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"pareto"}, {"excite", "--out", "x"}, {"identify", "/dev/null"}}) {
    const Finished finished = run_program(arguments);
    EXPECT_EQ(finished.exit_code, 2) << arguments[0];
    EXPECT_THAT(finished.err, HasSubstr("required")) << arguments[0];
  }
}

TEST(Help, IsWhatTheBareProgramShows) {
  const Finished bare = run_program({});
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_THAT(bare.err, testing::HasSubstr("armtune tune"));
}

}  // namespace help_test
}  // namespace armtune::internal

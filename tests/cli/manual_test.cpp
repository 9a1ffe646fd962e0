// The manual page and shell completion say what --help says: all come from one declaration.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <set>

#include "sim/scenario/data_files.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/cli/declared/completion.hpp"
#include "tuner/cli/declared/man_page.hpp"

namespace armtune::internal {
namespace manual_test {

using test::run_program;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

std::set<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
    found.insert((*it)[1]);
  return found;
}

std::string printed(const std::vector<std::string>& arguments) {
  const auto done = run_program(arguments);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  return done.out;
}

std::set<std::string> commands() {
  const std::string help = printed({"--help"});
  return matches(help.substr(help.find("Subcommands:")), "\n  ([a-z]+) ");
}

/// The options that `armtune COMMAND --help-all` lists.
std::set<std::string> options(const std::string& command) {
  return matches(printed({command, "--help-all"}), "\n  (?:-[a-z],)?(--[a-z-]+)");
}

/// What bash offers for the last of `words`.
std::set<std::string> offered(const std::string& script, const std::vector<std::string>& words) {
  const test::TemporaryFolder folder;
  std::string line = "cd " + folder.path() + "\n. " + folder.write("completion", script) + "\nCOMP_WORDS=(";
  for (const std::string& word : words) line += "'" + word + "' ";
  line += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
          "\n_armtune\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
  folder.write("a file", "");
  const std::string out = folder / "out";
  EXPECT_EQ(std::system(("bash " + folder.write("ask", line) + " > " + out).c_str()), 0);
  return matches(test::read_text(out), "([^\n]+)\n");
}

TEST(ManualPage, HasEveryCommandAndOptionOfHelp) {
  std::string page = printed({"man"});
  for (std::size_t at; (at = page.find("\\-")) != std::string::npos;) page.erase(at, 1);
  ASSERT_GE(commands().size(), 12U);
  for (const std::string& command : commands()) {
    const auto begin = page.find("\n.SS " + command + "\n");
    ASSERT_NE(begin, std::string::npos) << command;
    const std::string section = page.substr(begin, page.find("\n.SS ", begin + 1) - begin);
    EXPECT_THAT(options(command), Not(testing::IsEmpty()));
    for (const std::string& option : options(command)) EXPECT_THAT(section, HasSubstr(option)) << command;
  }
  EXPECT_THAT(page, AllOf(HasSubstr("130 interrupted"), HasSubstr("armtune 0.")));
  EXPECT_THAT(page, AllOf(HasSubstr("Default: as in the task."), HasSubstr("Default: rad.")));
}

TEST(ManualPage, IsAPageWithoutWarnings) {
  if (std::system("groff -v >/dev/null 2>&1") != 0) GTEST_SKIP() << "groff-base is not installed";
  const test::TemporaryFolder folder;
  const std::string page = folder.write("armtune.1", printed({"man"}));
  const std::string said = folder / "said";
  EXPECT_EQ(std::system(
                ("groff -man -ww -Tutf8 -P-cbou -Wbreak " + page + " > " + (folder / "shown") + " 2> " + said)
                    .c_str()),
            0);
  EXPECT_EQ(test::read_text(said), "");
  EXPECT_THAT(test::read_text(folder / "shown"),
              AllOf(HasSubstr("EXIT STATUS"), HasSubstr("--max-evaluations")));
}

TEST(ManualPage, WhatLooksLikeAMacroIsText) {
  cli::DeclaredProgram program;
  program.app = {"armtune", ".so /etc/passwd", {}, ""};
  program.commands = {
      {"c", "'br and \\fB", {{{"--x"}, "TEXT", "", {}, "a\n.PP\nb", false, false, false}}, ""}};
  const std::string page = cli::man_page(program, "armtune 1");
  EXPECT_THAT(page, AllOf(Not(HasSubstr("\n.so")), HasSubstr("\\&.so"), Not(HasSubstr("\n'br")),
                          HasSubstr("\\efB"), HasSubstr("a\n\\&.PP\nb")));
}

TEST(Completion, OffersEveryCommandAndOptionOfHelp) {
  const std::string script = printed({"completion", "bash"});
  const auto first = offered(script, {"armtune", ""});
  for (const std::string& command : commands()) {
    EXPECT_THAT(first, Contains(command));
    auto expected = options(command);
    auto found = offered(script, {"armtune", command, "--"});
    EXPECT_EQ(found, expected) << command;
  }
  EXPECT_THAT(offered(script, {"armtune", "--v"}), testing::ElementsAre("--version"));
}

TEST(Completion, OffersTheWordsAndBundledNamesThatAreTaken) {
  const std::string script = printed({"completion", "bash"});
  EXPECT_THAT(offered(script, {"armtune", "export", "published", "--format", ""}),
              testing::UnorderedElementsAre("yaml", "ros1", "ros2"));
  EXPECT_THAT(offered(script, {"armtune", "simulate", "moving_target", "--stepper", ""}),
              testing::UnorderedElementsAre("midpoint", "semi_implicit_euler", "rk4", "reference"));
  EXPECT_THAT(offered(script, {"armtune", "simulate", "moving_target", "--engine", "na"}),
              testing::ElementsAre("native"));
  EXPECT_THAT(offered(script, {"armtune", "tune", "--controller", ""}),
              AllOf(Contains("adaptive"), Contains("impedance")));
  const auto studies = bundled_names("studies");
  const auto tune = offered(script, {"armtune", "tune", ""});
  for (const std::string& study : studies) EXPECT_THAT(tune, Contains(study));
  EXPECT_THAT(tune, Contains("completion")) << "a file of this folder";
  EXPECT_THAT(tune, Contains("a file")) << "is one word";
  EXPECT_THAT(offered(script, {"armtune", "simulate", "moving_target", "--gains", "publ"}),
              testing::ElementsAre("published"));
}

TEST(Completion, OfEveryShellNamesCommandsAndOptions) {
  for (const std::string& shell : cli::shell_names()) {
    const std::string script = printed({"completion", shell});
    for (const std::string& command : commands()) EXPECT_THAT(script, HasSubstr(command)) << shell;
    EXPECT_THAT(script, HasSubstr("max-evaluations")) << shell;
  }
  for (const char* shell : {"tcsh", "fish"}) EXPECT_EQ(run_program({"completion", shell}).exit_code, 2);
}

}  // namespace manual_test
}  // namespace armtune::internal

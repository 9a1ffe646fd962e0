// Expanding xacro files, by programs that stand in for xacro in PATH.

#include "core/robot/xacro.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iterator>

#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal {
namespace xacro_test {

namespace fs = std::filesystem;

using test::one_joint;
using test::refused_at;
using test::robot;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kXacroText =
    "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n<xacro:include filename='x'/></robot>";

class Xacro : public test::UrdfFiles {
 protected:
  void SetUp() override {
    test::UrdfFiles::SetUp();
    const char* path = std::getenv("PATH");
    path_ = path == nullptr ? "" : path;
    ::setenv("PATH", (folder_ + ":/usr/bin:/bin").c_str(), 1);
    std::ofstream(file_) << kXacroText;
  }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    test::UrdfFiles::TearDown();
  }

  /// Puts a shell script in the place of xacro. It first adds a line with its arguments to the file `calls`.
  void install(const std::string& script) const {
    const std::string program = folder_ + "/xacro";
    std::ofstream(program) << "#!/bin/sh\necho \"$*\" >> '" << folder_ << "/calls'\n" << script << '\n';
    fs::permissions(program, fs::perms::owner_all);
  }
  /// Puts a program in the place of xacro that prints this URDF.
  void install_printing(const std::string& urdf) const {
    std::ofstream(folder_ + "/expanded") << urdf;
    install("cat '" + folder_ + "/expanded'");
  }
  std::string calls() const {
    std::ifstream file(folder_ + "/calls");
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string refused() const {
    return test::input_error([&] { return read_urdf(file_); }).what();
  }

  std::string path_;
  const std::string file_ = folder_ + "/arm.urdf.xacro";
};

TEST_F(Xacro, IsNotRunUnlessTheUserAsksForIt) {
  install_printing(robot(one_joint()));
  EXPECT_THAT(refused(), AllOf(HasSubstr("first: xacro "), HasSubstr("--xacro")));
  EXPECT_EQ(calls(), "");
  {
    const XacroExpansion allowed({});
    EXPECT_EQ(read_urdf(file_).n(), 1);
  }
  EXPECT_THAT(refused(), HasSubstr("first: xacro ")) << "only as long as the permission lives";
}

TEST_F(Xacro, IsRunOnceForEachFileWithTheArgumentsOfTheUser) {
  install_printing(robot(one_joint()));
  std::vector<std::string> commands;
  const XacroExpansion allowed({{"ur_type:=ur5e", "prefix:=a b;$(touch x)"},
                                60.0,
                                [&commands](const std::string& command) { commands.push_back(command); }});
  const RobotModel arm = read_urdf(file_);
  EXPECT_EQ(read_urdf(file_).n(), arm.n());
  EXPECT_EQ(calls(), file_ + " ur_type:=ur5e prefix:=a b;$(touch x)\n") << "no shell reads the arguments";
  EXPECT_THAT(commands,
              testing::ElementsAre(folder_ + "/xacro " + file_ + " ur_type:=ur5e 'prefix:=a b;$(touch x)'"));
  EXPECT_THAT(arm.files, testing::ElementsAre(file_));
  EXPECT_EQ(arm.source, file_) << "meshes are looked for from the folder of this file";
}

TEST_F(Xacro, AUrdfIsNotExpanded) {
  install("exit 1");
  const XacroExpansion allowed({});
  EXPECT_EQ(read(robot(one_joint())).n(), 1);
  EXPECT_EQ(calls(), "");
  EXPECT_THAT(refusal(kXacroText), HasSubstr("xacro failed")) << "xacro under the name of a URDF";
}

TEST_F(Xacro, ItsErrorIsOneLine) {
  install(
      "echo \"error: name 'mass' is not defined\" >&2\n"
      "printf '\\n\\nwhen evaluating expression\\n\\033[31mred' >&2\nexit 2");
  const XacroExpansion allowed({});
  EXPECT_THAT([&] { return read_urdf(file_); }, refused_at({.file = file_}));
  EXPECT_THAT(refused(), AllOf(HasSubstr("exit code 2: error: name 'mass' is not defined; when evaluating"),
                               Not(HasSubstr("\n")), Not(HasSubstr("\033"))));
  install("head -c 100000 /dev/zero | tr '\\0' 'e' >&2\nexit 1");
  EXPECT_LT(refused().size(), 600U);
}

TEST_F(Xacro, WithoutAUrdfItIsRefused) {
  const auto refused_when_expanded = [&] {
    const XacroExpansion allowed({});
    return refused();
  };
  install("exit 0");
  EXPECT_THAT(refused_when_expanded(), HasSubstr("wrote no URDF"));
  install("kill -9 $$");
  EXPECT_THAT(refused_when_expanded(), HasSubstr("killed by a signal"));
  install_printing("<robot name='r'>");
  EXPECT_THAT(refused_when_expanded(), HasSubstr(file_));
  ::setenv("PATH", "/nowhere", 1);
  EXPECT_THAT(refused_when_expanded(), AllOf(HasSubstr("no program 'xacro'"), HasSubstr("PATH")));
  fs::remove(file_);
  EXPECT_THAT(refused_when_expanded(), HasSubstr("no such file"));
}

TEST_F(Xacro, AnErrorInItsUrdfHasTheLineOfTheExpandedText) {
  install_printing(robot("\n\n<link name='%s'/>"));
  const XacroExpansion allowed({});
  EXPECT_THAT([&] { return read_urdf(file_); }, refused_at({.file = file_ + " (expanded)", .line = 4}));
}

// The child of the script has the output open, and must not outlive it.
TEST_F(Xacro, IsStoppedAtTheTimeLimitWithWhatItHasStarted) {
  install("sleep 100 &\necho $! > '" + folder_ + "/child'\nsleep 100");
  const XacroExpansion allowed({{}, 0.5, {}});
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THAT([&] { return read_urdf(file_); }, refused_at({.file = file_, .limit = "0.5 s"}));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  std::ifstream file(folder_ + "/child");
  pid_t child = 0;
  ASSERT_TRUE(file >> child);
  // A killed orphan is gone once the system has collected it.
  bool runs = true;
  for (int k = 0; k < 100 && runs; ++k, ::usleep(20'000)) {
    std::ifstream status("/proc/" + std::to_string(child) + "/stat");
    const std::string text{std::istreambuf_iterator<char>(status), {}};
    runs = !text.empty() && text.find(") Z ") == std::string::npos;
  }
  EXPECT_FALSE(runs);
}

TEST_F(Xacro, IsStoppedWhenItWritesTooMuch) {
  install("cat /dev/zero");
  const XacroExpansion allowed({});
  EXPECT_THAT([&] { return read_urdf(file_); }, refused_at({.file = file_, .limit = "at most 32 MB"}));
}

TEST_F(Xacro, LeavesNoTemporaryFile) {
  const std::string temporary = folder_ + "/tmp";
  fs::create_directories(temporary);
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  ::setenv("TMPDIR", temporary.c_str(), 1);
  install("ls '" + temporary + "' >&2\nexit 1");
  {
    const XacroExpansion allowed({});
    EXPECT_THAT(refused(), HasSubstr("without a message")) << "not even while it runs";
  }
  EXPECT_TRUE(fs::is_empty(temporary));
  if (before == nullptr) {
    ::unsetenv("TMPDIR");
  } else {
    ::setenv("TMPDIR", kept.c_str(), 1);
  }
}

TEST_F(Xacro, ArgumentsAreNoOptionsOfXacro) {
  for (const std::string argument :
       {"-o", "--help", "ur_type", "=x", ":=x", "a b:=x", "-a:=x", "9a:=x", ""}) {
    EXPECT_THAT([&] { XacroExpansion({{argument}, 60.0, {}}); }, refused_at({.value = argument})) << argument;
  }
}

}  // namespace xacro_test
}  // namespace armtune::internal

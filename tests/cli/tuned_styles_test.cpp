// Parameter files in the styles in which people publish them, tuned by the program.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "sim/controller_files/controller_gains.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/cli/support/program.hpp"
#include "tests/sim/support/controller_styles.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/without_numbers.hpp"

namespace armtune::internal {
namespace tuned_styles_test {

using test::Finished;
using test::run_program;
using test::Style;

/// An arm of three joints that turn about different axes.
std::string arm() {
  std::string text = "<robot name='three'>\n<link name='base'/>\n";
  const char* const axes[] = {"0 0 1", "0 1 0", "0 1 0"};
  std::string parent = "base";
  for (int k = 0; k < 3; ++k) {
    const std::string link = fmt::format("link{}", k + 1);
    text += fmt::format(
        "<joint name='j{0}' type='revolute'>\n<parent link='{1}'/><child link='{2}'/>\n"
        "<origin xyz='0 0 {3}'/><axis xyz='{4}'/>\n"
        "<limit lower='-2' upper='2' effort='{5}' velocity='3'/>\n</joint>\n"
        "<link name='{2}'><inertial><origin xyz='0 0 0.2'/><mass value='2'/>\n"
        "<inertia ixx='0.03' iyy='0.03' izz='0.003' ixy='0' ixz='0' iyz='0'/></inertial></link>\n",
        k + 1, parent, link, k == 0 ? 0.1 : 0.4, axes[k], 200 - 50 * k);
    parent = link;
  }
  return text + "</robot>\n";
}

class TunedStyles : public testing::TestWithParam<Style> {};

TEST_P(TunedStyles, GetTheTunedNumbersAndNothingElse) {
  const test::TemporaryFolder folder;
  const std::string text = GetParam().text;
  const std::string file = folder.write("controllers.yaml", text);
  const std::string run = folder / "run";
  std::vector<std::string> command = {
      "tune",
      "--robot",
      folder.write("arm.urdf", arm()),
      "--controllers",
      file,
      "--trajectory",
      folder.write("moves.csv", "time,j1,j2,j3\n0,0,0.4,0.6\n1,0.4,0.6,0.2\n2,0,0.4,0.6\n"),
      "--rate",
      "250",
      "--max-evaluations",
      "4",
      "--no-analysis",
      "--out",
      run};
  if (GetParam().stiffness == std::string("joint_impedance_k"))
    command.insert(command.end(), {"--max-stiffness", "3000"});
  const Finished tuned = run_program(command);
  ASSERT_NE(tuned.exit_code, 2) << tuned.err;
  ASSERT_NE(tuned.exit_code, 1) << tuned.err;
  const std::string made = folder / "tuned.yaml";
  const Finished written = run_program({"export", run, "--into", file, "--out", made});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  const std::string after = test::read_text(made);
  EXPECT_EQ(test::without_numbers(after), test::without_numbers(text));
  const std::set<std::string> changed = test::keys_of_other_numbers(text, after);
  EXPECT_FALSE(changed.empty()) << "the search found other gains";
  for (const std::string& key : changed) EXPECT_TRUE(GetParam().keys.contains(key)) << key;
  // Read back, the file has the run's gains to the bit.
  const Gains back =
      controller_gains(chosen_controller(ros_controllers(after, made), made), made, test::kStyleJoints);
  const Gains found = load_gains(run + "/gains.yaml", test::kStyleJoints);
  EXPECT_EQ(back.controller, found.controller);
  EXPECT_EQ(back.own, found.own);
  EXPECT_EQ((tuned.out + tuned.err).find("are linked") != std::string::npos, GetParam().two_in_one);
}

INSTANTIATE_TEST_SUITE_P(Styles, TunedStyles, testing::ValuesIn(test::kStyles),
                         [](const auto& style) { return style.param.name; });

}  // namespace tuned_styles_test
}  // namespace armtune::internal

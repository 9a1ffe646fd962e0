// Bundled scenarios and robots, cut off anywhere. YAML itself takes what is left of a block mapping for a
// whole one.

#include <gtest/gtest.h>

#include <filesystem>

#include "sim/scenario/data_files.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/scenario.hpp"
#include "tests/sim/support/cut_off.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace cut_off_test {

void expect_valid(const Scenario& scenario) {
  ASSERT_NE(scenario.robot, nullptr);
  const int n = scenario.robot->n();
  EXPECT_GE(scenario.periods(), 1);
  EXPECT_FALSE(scenario.targets.empty());
  EXPECT_EQ(scenario.start_position.size(), n);
  EXPECT_TRUE(scenario.start_position.allFinite());
  EXPECT_TRUE(scenario.path.at(1.0).position.allFinite());
  EXPECT_NO_THROW(validate(plant_model(scenario)));
  EXPECT_TRUE(start_theta(scenario).allFinite());
}

test::Cuts cut_scenario(const test::TemporaryFolder& folder, const std::string& text, std::size_t required) {
  return test::cut_off(text, required, 1, [&](const std::string& beginning) {
    expect_valid(load_scenario(folder.write("cut.yaml", beginning)));
  });
}

TEST(CutOff, AScenarioIsRefusedOrWhole) {
  const test::TemporaryFolder folder;
  const std::string text = test::read_text(find_data_file("scenarios", "moving_target"));
  const std::size_t required = test::up_to_key(text, "theta_start");
  const test::Cuts cuts = cut_scenario(folder, text, required);
  EXPECT_EQ(cuts.refused_before, required + 1);
  EXPECT_GT(cuts.refused_after, 0U) << "in the middle of theta_start";
  EXPECT_GT(cuts.loaded, 0U) << "without its seed";
}

TEST(CutOff, AScenarioWithBasesIsRefusedOrWhole) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "fragments");
  folder.write("fragments/realistic.yaml",
               test::read_text(data_folder() + "/scenarios/fragments/realistic.yaml"));
  const std::string text = test::read_text(find_data_file("scenarios", "realistic_moving_target"));
  // Up to the last base's bracket.
  const std::size_t required = text.find(']');
  ASSERT_NE(required, std::string::npos);
  const test::Cuts cuts = cut_scenario(folder, text, required);
  EXPECT_EQ(cuts.refused_before, required + 1);
  EXPECT_GT(cuts.refused_after, 0U) << "in the middle of a key";
  EXPECT_GT(cuts.loaded, 0U);
}

TEST(CutOff, ARobotIsRefusedOrWhole) {
  const test::TemporaryFolder folder;
  folder.write("ur10.urdf", test::read_text(data_folder() + "/robots/ur10.urdf"));
  const std::string text = test::read_text(find_data_file("robots", "ur10"));
  const std::size_t required = test::up_to_key(text, "urdf");
  const test::Cuts cuts = test::cut_off(text, required, 1, [&](const std::string& beginning) {
    const auto robot = load_robot(folder.write("cut.yaml", beginning));
    EXPECT_EQ(robot->n(), 6);
    EXPECT_NO_THROW(validate(*robot));
  });
  EXPECT_EQ(cuts.refused_before, required + 1);
  EXPECT_GT(cuts.refused_after, 0U) << "in the middle of names and lists";
  EXPECT_GT(cuts.loaded, 0U) << "without its comment";
}

}  // namespace cut_off_test
}  // namespace armtune::internal

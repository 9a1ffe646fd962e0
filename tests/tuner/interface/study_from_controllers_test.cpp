// Studies that a program makes from the files of a robot.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armtune/error.hpp"
#include "armtune/study.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/joint_trajectory_example.hpp"

namespace armtune {
namespace study_from_controllers_test {

using internal::test::refused_at;

const std::string kParameterFile = internal::test::kExample + "ros2_controllers.yaml";
const std::vector<std::string> kMoves = {internal::test::kExample + "moves.csv"};

TEST(StudyFromControllers, IsTheStudyInItsFolder) {
  const internal::test::TemporaryFolder folder;
  std::vector<std::string> notes;
  ControllerStudyOptions options;
  options.folder = folder / "made";
  options.distro = "humble";
  options.watch.warning = [&notes](const std::string& note) { notes.push_back(note); };
  const Study study = Study::from_controllers("ur5e", kParameterFile, kMoves, options);
  EXPECT_THAT(notes, testing::Contains(testing::HasSubstr("500 Hz")));
  const Study read = Study::load(options.folder + "/study.yaml");
  EXPECT_EQ(study.parameters(), read.parameters());
  EXPECT_EQ(study.start().text(), read.start().text());
  EXPECT_TRUE(study.files() && study.scenarios().front().as_in_file()) << "a run with a folder accepts it";
  EXPECT_EQ(Study::from_controllers("ur5e", kParameterFile, kMoves, options).name(), study.name())
      << "the same files are there already";
}

TEST(StudyFromControllers, ReplacesStartGainsThatOscillate) {
  const internal::test::TemporaryFolder folder;
  std::string text = internal::test::read_text(kParameterFile);
  const std::string wrist = "wrist_1_joint: {p: 300.0, d: 10.0";
  ASSERT_NE(text.find(wrist), std::string::npos);
  text.replace(text.find(wrist), wrist.size(), "wrist_1_joint: {p: 500.0, d: 1.0");
  ControllerStudyOptions options;
  options.folder = folder / "made";
  options.workers = 2;
  const Study study = Study::from_controllers("ur5e", folder.write("shaky.yaml", text), kMoves, options);
  EXPECT_NE(study.start().text(), Study::load(options.folder + "/study.yaml").start().text());
}

TEST(StudyFromControllers, RefusesOptionsOutsideTheirLimits) {
  const internal::test::TemporaryFolder folder;
  const auto refusal = [&](const auto& change) {
    ControllerStudyOptions options;
    options.folder = folder / "none";
    change(options);
    return internal::test::input_error(
        [&] { return Study::from_controllers("ur5e", kParameterFile, kMoves, options); });
  };
  EXPECT_THAT(refusal([](auto& options) { options.folder.clear(); }), refused_at({.key = "folder"}));
  EXPECT_THAT(refusal([](auto& options) { options.workers = 0; }), refused_at({.key = "workers"}));
  EXPECT_THAT(refusal([](auto& options) { options.rate = 5.0; }), refused_at({.key = "rate", .value = "5"}));
  EXPECT_THAT(refusal([](auto& options) { options.speed = NAN; }), refused_at({.key = "speed"}));
  EXPECT_THAT(refusal([](auto& options) { options.max_stiffness = {-1.0}; }),
              refused_at({.key = "max_stiffness", .value = "-1"}));
  EXPECT_THAT(refusal([](auto& options) { options.distro = "lunar"; }), refused_at({}));
  ControllerStudyOptions options;
  options.folder = folder / "none";
  EXPECT_THAT([&] { return Study::from_controllers("ur5e", kParameterFile, {}, options); },
              refused_at({.key = "trajectories"}));
  EXPECT_FALSE(std::ifstream(options.folder + "/study.yaml").good());
}

}  // namespace study_from_controllers_test
}  // namespace armtune

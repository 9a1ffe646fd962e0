#include "tuner/controller_study/shared_numbers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/control/laws/controller_kind.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/csv/text_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/support/joint_trajectory_example.hpp"
#include "tuner/controller_study/controller_study.hpp"
#include "tuner/session/study_files.hpp"
#include "tuner/session/tune_files.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace shared_numbers_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

using test::changed_example;
using test::example;
using test::refused_at;

/// The file of an arm whose second joint has the p of the first through an alias, and one more alias.
std::string shared_numbers_of_shoulder(const std::string& more) {
  std::string text =
      changed_example("shoulder_pan_joint: {p: 2000.0", "shoulder_pan_joint: {p: &stiff 2000.0");
  text.replace(text.find("p: 2000.0"), 9, "p: *stiff");
  return text + more;
}

// One number of the text gets one value: the study links the gains of both joints.
TEST(ControllerStudy, LinksGainsThatAreOneNumberOfTheFile) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write("shared.yaml", shared_numbers_of_shoulder(""));
  const ControllerStudyFiles files = write_controller_study(inputs, folder / "made").value();
  EXPECT_THAT(files.notes, Contains(AllOf(HasSubstr("shared.yaml"), HasSubstr("alias"),
                                          HasSubstr("p of shoulder_pan_joint, shoulder_lift_joint"))));
  const Study study = load_study(files.study);
  EXPECT_EQ(study.space.free.size(), 17U);
  ASSERT_EQ(study.space.links.size(), 1U);
  const Link& link = study.space.links.front();
  EXPECT_EQ(link.entry.name, "jtc_p/shoulder_lift_joint");
  EXPECT_EQ(study.space.free[link.parameter].entry.name, "jtc_p/shoulder_pan_joint");
  EXPECT_EQ(link.factor, 1.0);
  // Any point of the search can be written.
  const Gains tuned = study.space.gains_at(std::vector<double>(17, 0.7));
  EXPECT_EQ(own(tuned, "jtc_p")[1], own(tuned, "jtc_p")[0]);
  std::filesystem::create_directory(folder / "run");
  EXPECT_EQ(write_controllers(study, tuned, folder / "run"), "shared.yaml");
  EXPECT_THAT(test::read_text(folder / "run/shared.yaml"), HasSubstr("p: *stiff"));
}

// A study of the user's own may forget the link, or give it another factor.
TEST(ControllerStudy, IsRefusedWhenItIsLoadedIfItSplitsANumberOfTheFile) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write("shared.yaml", shared_numbers_of_shoulder(""));
  const std::string study = write_controller_study(inputs, folder / "made").value().study;
  const std::string text = test::read_text(study);
  const auto link = text.find(", link: ");
  ASSERT_NE(link, std::string::npos);
  const auto end = text.find('}', link);
  const auto line = text.rfind('\n', link);
  const auto refused = refused_at({.file = study,
                                   .key = "jtc_p/shoulder_lift_joint",
                                   .limit = HasSubstr("link: jtc_p/shoulder_pan_joint")});
  for (const std::string& split : {
           text.substr(0, line) + text.substr(end + 1),              // keeps its start value
           text.substr(0, link) + text.substr(end),                  // is tuned by itself
           text.substr(0, end) + ", factor: 2.0" + text.substr(end)  // is linked, but twice as large
       }) {
    write_text_file(study, split);
    EXPECT_THAT([&] { load_study(study); }, refused) << split;
  }
}

TEST(ControllerStudy, AFileThatCannotHoldOtherGainsIsRefusedBeforeASearch) {
  const test::TemporaryFolder folder;
  ControllerStudyInputs inputs = example();
  inputs.controllers = folder.write("shared.yaml", shared_numbers_of_shoulder("other: {x: {y: *stiff}}\n"));
  EXPECT_THAT([&] { write_controller_study(inputs, folder / "new"); },
              refused_at({.file = inputs.controllers, .line = testing::Gt(0), .key = "arm_controller"}));
}

}  // namespace shared_numbers_test
}  // namespace armtune::internal

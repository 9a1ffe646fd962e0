// Parameter files in the styles in which people publish them: read, changed, written.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "sim/controller_files/changed_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "tests/sim/support/controller_styles.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/without_numbers.hpp"

namespace armtune::internal {
namespace controller_files_test {

using testing::AllOf;
using testing::HasSubstr;

using test::kStyleJoints;
using test::Style;

class ControllerFiles : public testing::TestWithParam<Style> {};

TEST_P(ControllerFiles, AreReadAndGetNothingButOtherNumbers) {
  const Style& style = GetParam();
  const std::string text = style.text;
  const RosController controller = chosen_controller(ros_controllers(text, "f.yaml"), "f.yaml");
  EXPECT_EQ(controller.name, style.controller);
  Gains gains = controller_gains(controller, "f.yaml", kStyleJoints);
  validate(gains, kStyleJoints, "f.yaml");
  EXPECT_EQ(own(gains, style.stiffness), Vec3(600.0, style.two_in_one ? 600.0 : 500.0, 250.0));
  EXPECT_EQ(own(gains, style.damping), Vec3(30.0, style.two_in_one ? 30.0 : 20.0, 10.0));
  EXPECT_EQ(with_gains(text, controller, "f.yaml", gains, kStyleJoints), text) << "nothing differs";

  own(gains, style.stiffness) = Vec3(1.0 / 3.0, style.two_in_one ? 1.0 / 3.0 : 1e-7, 4321.0);
  own(gains, style.damping) = Vec3(style.two_in_one ? 1e22 : 31.5, 1e22, 10.0);
  const std::string changed = with_gains(text, controller, "f.yaml", gains, kStyleJoints);
  EXPECT_EQ(test::without_numbers(changed), test::without_numbers(text));
  for (const std::string& key : test::keys_of_other_numbers(text, changed))
    EXPECT_TRUE(style.keys.contains(key)) << key;
  EXPECT_THAT(changed, AllOf(HasSubstr("0.3333333333333333"), HasSubstr("4321.0"), HasSubstr("1.0e+22")));
  EXPECT_THAT(changed, HasSubstr(style.two_in_one ? "*big" : "1.0e-07"));
  const RosController again = chosen_controller(ros_controllers(changed, "f.yaml"), "f.yaml");
  const Gains back = controller_gains(again, "f.yaml", kStyleJoints);
  EXPECT_EQ(back.own, gains.own);
}

INSTANTIATE_TEST_SUITE_P(Styles, ControllerFiles, testing::ValuesIn(test::kStyles),
                         [](const auto& style) { return style.param.name; });

}  // namespace controller_files_test
}  // namespace armtune::internal

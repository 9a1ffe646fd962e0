#include "core/robot/urdf_rotors.hpp"

#include "core/robot/robot_model.hpp"
#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal {
namespace urdf_rotors_test {

using test::joint;
using test::link;
using test::one_joint;
using test::robot;
using testing::AllOf;
using testing::HasSubstr;

std::string transmission(const std::string& joint, const std::string& in_actuators) {
  return fmt::format(
      "<transmission name='t'><type>transmission_interface/SimpleTransmission</type><joint name='{}'/>{}"
      "</transmission>\n",
      joint, in_actuators);
}
std::string actuator(const std::string& inside) {
  return "<actuator name='m'>" + inside + "</actuator>";
}
const std::string kRotor = "<drake:rotor_inertia value='0.00013'/>";

std::map<std::string, double> read(const std::string& inside) {
  return rotor_inertias(robot(inside), "arm.urdf");
}

TEST(UrdfRotors, AJointFeelsItsRotorTimesTheSquareOfTheGearRatio) {
  const auto found = read(transmission("j", actuator("<drake:gear_ratio value='-100'/>" + kRotor)));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found.at("j"), 1.3, 1e-12);
}

TEST(UrdfRotors, DrakesGearRatioComesBeforeTheMechanicalReduction) {
  const std::string reduction = "<mechanicalReduction> 50 </mechanicalReduction>";
  EXPECT_NEAR(read(transmission("j", actuator(kRotor + reduction))).at("j"), 0.325, 1e-12);
  EXPECT_NEAR(
      read(transmission("j", actuator(kRotor + reduction + "<drake:gear_ratio value='10'/>"))).at("j"), 0.013,
      1e-12);
  EXPECT_NEAR(read(transmission("j", actuator(kRotor))).at("j"), 0.00013, 1e-15);
}

TEST(UrdfRotors, SeveralActuatorsOfAJointAddUp) {
  const std::string geared = actuator("<drake:gear_ratio value='100'/>" + kRotor);
  EXPECT_NEAR(read(transmission("j", geared + geared)).at("j"), 2.6, 1e-12);
  EXPECT_NEAR(read(transmission("j", geared) + transmission("j", geared)).at("j"), 2.6, 1e-12);
}

TEST(UrdfRotors, WithoutARotorOrWithSeveralJointsNothingIsGiven) {
  EXPECT_TRUE(read(transmission("j", actuator("<mechanicalReduction>100</mechanicalReduction>"))).empty());
  EXPECT_TRUE(read(transmission("j", "<joint name='k'/>" + actuator(kRotor))).empty());
  EXPECT_TRUE(read("").empty());
}

TEST(UrdfRotors, ValuesThatMeanNothingAreRefused) {
  const auto refused = [](const std::string& in_actuator) {
    try {
      read(transmission("elbow", actuator(in_actuator)));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto names_it = AllOf(HasSubstr("arm.urdf"), HasSubstr("'elbow'"));
  EXPECT_THAT(refused("<drake:rotor_inertia value='a lot'/>"), AllOf(names_it, HasSubstr("a lot")));
  EXPECT_THAT(refused("<drake:rotor_inertia value='nan'/>"), AllOf(names_it, HasSubstr("nan")));
  EXPECT_THAT(refused("<drake:rotor_inertia/>"), AllOf(names_it, HasSubstr("drake:rotor_inertia")));
  EXPECT_THAT(refused("<drake:rotor_inertia value='-1e-4'/>"), AllOf(names_it, HasSubstr("-0.0001")));
  EXPECT_THAT(refused(kRotor + "<drake:gear_ratio value='0'/>"), AllOf(names_it, HasSubstr("gear_ratio")));
  EXPECT_THAT(refused(kRotor + "<mechanicalReduction>1:100</mechanicalReduction>"),
              AllOf(names_it, HasSubstr("1:100")));
}

class ArmWithTransmissions : public test::UrdfFiles {};

TEST_F(ArmWithTransmissions, HasTheRotorsOfItsJoints) {
  const RobotModel arm =
      read(robot(one_joint() + transmission("j", actuator("<drake:gear_ratio value='100'/>" + kRotor)) +
                 transmission("of another arm", actuator(kRotor))));
  EXPECT_NEAR(arm.chain.rotor_inertia[0], 1.3, 1e-12);
  EXPECT_TRUE(arm.estimated_rotors.empty());
  EXPECT_EQ(read(robot(one_joint())).chain.rotor_inertia[0], 0.0);
}

}  // namespace urdf_rotors_test
}  // namespace armtune::internal

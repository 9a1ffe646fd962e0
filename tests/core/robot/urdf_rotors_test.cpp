#include "core/robot/urdf_rotors.hpp"

#include "core/robot/robot_model.hpp"
#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal {
namespace urdf_rotors_test {

using test::joint;
using test::link;
using test::one_joint;
using test::refused_at;
using test::robot;

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
  struct Refused {
    std::string in_actuator, element, value, limit;
  };
  const std::string rotor = "drake:rotor_inertia";
  for (const auto& [in_actuator, element, value, limit] :
       {Refused{"<drake:rotor_inertia value='a lot'/>", rotor, "a lot", "a finite number"},
        Refused{"<drake:rotor_inertia value='nan'/>", rotor, "nan", "a finite number"},
        Refused{"<drake:rotor_inertia/>", rotor, "", "a finite number"},
        Refused{"<drake:rotor_inertia value='-1e-4'/>", rotor, "-1e-4", "not negative"},
        Refused{kRotor + "<drake:gear_ratio value='0'/>", "drake:gear_ratio", "0", "not 0"},
        Refused{kRotor + "<mechanicalReduction>1:100</mechanicalReduction>", "mechanicalReduction", "1:100",
                "a finite number"}}) {
    const std::string text = transmission("elbow", actuator(in_actuator));
    EXPECT_THAT([&text] { read(text); },
                refused_at({.file = "arm.urdf", .key = "elbow/" + element, .value = value, .limit = limit}));
  }
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

// Files that cannot be used, each refused with the names and values to look for.

#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal {
namespace urdf_bad_input_test {

using test::joint;
using test::kInertial;
using test::kLimit;
using test::link;
using test::one_joint;
using test::refused_at;
using test::robot;
using testing::AllOf;
using testing::HasSubstr;

class UrdfBadInput : public test::UrdfFiles {};

TEST_F(UrdfBadInput, NumbersUrdfdomCannotReadAreRefused) {
  for (const char* mass : {"nan", "inf", "1,5", "1e400", "1.5kg", "0x10", ""}) {
    const std::string text = kInertial.substr(0, 23) + mass + kInertial.substr(24);
    ASSERT_THAT(refusal(robot(one_joint(text))),
                AllOf(HasSubstr(fmt::format("mass [{}]", mass)), HasSubstr("Link [b]")));
  }
  EXPECT_THAT(refusal(robot(one_joint("<inertial><mass/></inertial>"))), HasSubstr("Link [b]"));
  EXPECT_THAT(refusal(robot(one_joint("<inertial><mass value='1'/><inertia ixx='1'/></inertial>"))),
              AllOf(HasSubstr("ixy"), HasSubstr("Link [b]")));
}

TEST_F(UrdfBadInput, PrintfFormatsThatCrashUrdfdomAreRefusedWithTheirLine) {
  for (const char* mass : {"'%s%s%n'", "%s%s%n ", "'&#37;s'"}) {
    const std::string text = robot(one_joint(fmt::format("<inertial><mass value={}/></inertial>", mass)));
    const InputError error = error_of(text);
    EXPECT_THAT(error, refused_at({.line = 3})) << mass;
    EXPECT_THAT(error.what(), HasSubstr("'%' or a character reference '&#..;' in a tag"));
  }
}

struct Refused {
  const char* what;
  std::string text;
  test::RefusedFields fields;
  std::vector<std::string> hints = {};  ///< what urdfdom says, or what to do
};

TEST_F(UrdfBadInput, BadModelsAreRefusedWithNamesAndValues) {
  const auto zero_mass = [](const std::string& mass, const std::string& moments) {
    return fmt::format("<inertial><mass value='{}'/><inertia {} ixy='0' ixz='0' iyz='0'/></inertial>", mass,
                       moments);
  };
  const std::string ones = "ixx='1' iyy='1' izz='1'";
  const std::string axis = "<axis xyz='0 0 1'/>";
  const std::string two = link("a") + link("b");
  const std::string three = two + link("c");
  const std::vector<Refused> table = {
      {"no inertial", robot(one_joint("")), {.key = "b/mass", .value = "0", .limit = "finite and above 0"}},
      {"zero mass",
       robot(one_joint(zero_mass("0", ones))),
       {.key = "b/mass", .value = "0", .limit = "finite and above 0"}},
      {"negative mass",
       robot(one_joint(zero_mass("-2", ones))),
       {.key = "b/inertia", .value = "mass -2 kg"},
       {"--sidecar"}},
      {"a planet's mass",
       robot(one_joint(zero_mass("3.6e41", ones))),
       {.key = "b/mass", .value = "3.6e+41", .limit = "at most 1000000 kg"}},
      {"a second inertial",
       robot(one_joint(std::string(kInertial) + kInertial, "<axis xyz='0 0 1'/>" + kLimit)),
       {.line = 3, .key = "link/inertial", .limit = "one <inertial>"}},
      {"a second axis",
       robot(one_joint(kInertial, axis + "<axis xyz='1 0 0'/>" + kLimit)),
       {.line = 4, .key = "joint/axis", .limit = "one <axis>"}},
      {"an origin that is nowhere",
       robot(one_joint(kInertial, "<origin xyz='1e300 0 0'/>" + axis + kLimit)),
       {.key = "j/origin", .value = "1e+300", .limit = "at most 10000 m"}},
      {"a centre of mass that is nowhere",
       robot(one_joint("<inertial><origin xyz='0 2e4 0'/><mass value='1'/><inertia ixx='1' iyy='1' izz='1' "
                       "ixy='0' ixz='0' iyz='0'/></inertial>")),
       {.key = "b/center", .value = "20000", .limit = "at most 10000 m"}},
      {"an inertia of no link",
       robot(one_joint(zero_mass("1", "ixx='1e300' iyy='1e300' izz='1e300'"))),
       {.key = "b/inertia", .value = "1e+300", .limit = "at most 1e+14 kg m^2"}},
      {"a slide without end",
       robot(two + joint("j", "prismatic", "a", "b",
                         axis + "<limit lower='0' upper='1e300' velocity='1' effort='1'/>")),
       {.key = "j/upper", .value = "1e+300", .limit = "at most 10000 m"}},
      {"negative inertia",
       robot(one_joint(zero_mass("1", "ixx='-1' iyy='1' izz='1'"))),
       {.key = "b/inertia", .value = "moment -1 kg m^2"},
       {"--sidecar"}},
      {"triangle",
       robot(one_joint(zero_mass("1", "ixx='1' iyy='1' izz='3'"))),
       {.key = "b/inertia", .value = "principal moments 1, 1, 3 kg m^2"},
       {"--sidecar"}},
      {"no inertia about the axis",
       robot(one_joint(zero_mass("1", "ixx='1' iyy='1' izz='0'"))),
       {.key = "b/inertia", .value = "no inertia about the axis of its joint"},
       {"--sidecar"}},
      {"zero axis",
       robot(one_joint(kInertial, "<axis xyz='0 0 0'/>" + kLimit)),
       {.key = "j/axis", .value = "0 0 0", .limit = "a unit vector"}},
      {"NaN axis", robot(one_joint(kInertial, "<axis xyz='0 nan 0'/>" + kLimit)), {}, {"joint [j]", "nan"}},
      {"NaN origin",
       robot(one_joint(kInertial, "<origin xyz='0 nan 0'/>" + axis + kLimit)),
       {},
       {"joint [j]", "nan"}},
      {"no limit",
       robot(one_joint(kInertial, axis)),
       {.key = "j/lower", .value = "", .limit = "a lower limit below an upper one"}},
      {"no effort",
       robot(one_joint(kInertial, axis + "<limit lower='0' upper='1' velocity='1'/>")),
       {.key = "j/effort", .value = "0", .limit = "finite and above 0"},
       {"robot YAML"}},
      {"crossed",
       robot(one_joint(kInertial, axis + "<limit lower='2' upper='1' velocity='1' effort='1'/>")),
       {.key = "j/lower", .value = "2", .limit = "below 1"}},
      {"no torque",
       robot(one_joint(kInertial, axis + "<limit lower='0' upper='1' velocity='1' effort='0'/>")),
       {.key = "j/effort", .value = "0", .limit = "finite and above 0"}},
      {"no speed",
       robot(one_joint(kInertial, axis + "<limit lower='0' upper='1' velocity='0' effort='1'/>")),
       {.key = "j/velocity", .value = "0", .limit = "finite and above 0"}},
      {"negative damping",
       robot(one_joint(kInertial, axis + kLimit + "<dynamics damping='-3'/>")),
       {.key = "j/viscous_friction", .value = "-3", .limit = "finite and 0 or more"}},
      {"continuous",
       robot(two + joint("j", "continuous", "a", "b", axis)),
       {.key = "j/limit", .limit = "<limit velocity=\"..\" effort=\"..\"/>"}},
      {"floating",
       robot(two + joint("j", "floating", "a", "b")),
       {.key = "j", .limit = "a fixed, revolute, continuous or prismatic joint"}},
      {"planar",
       robot(two + joint("j", "planar", "a", "b")),
       {.key = "j", .limit = "a fixed, revolute, continuous or prismatic joint"}},
      {"spherical", robot(two + joint("j", "spherical", "a", "b")), {}, {"[j]", "[spherical]"}},
      {"mimic",
       robot(two + joint("j", "revolute", "a", "b", axis + kLimit + "<mimic joint='k'/>")),
       {.key = "j", .value = "k", .limit = "hold: {j: 0}"}},
      {"mimic of itself",
       robot(two + joint("j", "revolute", "a", "b", axis + kLimit + "<mimic joint='j'/>")),
       {.key = "j", .value = "j", .limit = "hold: {j: 0}"}},
      {"no velocity",
       robot(one_joint(kInertial, axis + "<limit lower='0' upper='1' effort='1'/>")),
       {.key = "j/velocity", .value = "0", .limit = "finite and above 0"},
       {"robot YAML"}},
      {"NaN limit",
       robot(one_joint(kInertial, axis + "<limit lower='nan' upper='1' velocity='1' effort='1'/>")),
       {},
       {"(nan)", "lower"}},
      {"NaN rpy",
       robot(one_joint(kInertial, "<origin rpy='0 nan 0'/>" + axis + kLimit)),
       {},
       {"joint [j]", "nan"}},
      {"NaN damping",
       robot(one_joint(kInertial, axis + kLimit + "<dynamics damping='nan'/>")),
       {},
       {"(nan)", "damping"}},
      {"duplicate joint",
       robot(three + joint("j", "revolute", "a", "b") + joint("j", "revolute", "b", "c")),
       {},
       {"'j'", "not unique"}},
      {"name of a megabyte",
       robot(link("a") + link(std::string(1'000'000, 'x')) +
             joint("j", "revolute", "a", std::string(1'000'000, 'x'), axis + kLimit)),
       {.key = "link", .value = "1000000", .limit = "at most 255 bytes"}},
      {"name of a formula",
       robot(link("a") + link("b") + joint("=j", "revolute", "a", "b", axis + kLimit)),
       {.key = "joint", .value = "=j", .limit = "a name that is not a formula"}},
      {"name that is not UTF-8",
       robot(link("a") + link("b\xE9") + joint("j", "revolute", "a", "b\xE9", axis + kLimit)),
       {.key = "link", .value = "b\xE9", .limit = "UTF-8"}},
      {"two branches",
       robot(three + joint("j", "revolute", "a", "b") + joint("k", "revolute", "a", "c")),
       {.key = "k", .value = "j", .limit = "one moving joint on each link"}},
      {"two branches over a fixed link",
       robot(three + link("d") + joint("f", "fixed", "a", "b") + joint("j", "revolute", "a", "c") +
             joint("k", "prismatic", "b", "d")),
       {.key = "k", .value = "j", .limit = "one moving joint on each link"}},
      {"cycle below the root",
       robot(three + joint("j", "revolute", "a", "b") + joint("k", "revolute", "b", "c") +
             joint("l", "revolute", "c", "b")),
       {.key = "b", .value = "l", .limit = "one parent joint"}},
      {"detached cycle",
       robot(three + link("d") + joint("j", "revolute", "a", "b") + joint("k", "fixed", "c", "d") +
             joint("l", "fixed", "d", "c")),
       {.key = "c"},
       {"root link 'a'"}},
      {"diamond",
       robot(three + link("d") + joint("j", "fixed", "a", "b") + joint("k", "fixed", "a", "c") +
             joint("l", "fixed", "b", "d") + joint("m", "fixed", "c", "d")),
       {.key = "d", .value = "l", .limit = "one parent joint"}},
      {"two roots", robot(two), {}, {"[a]", "[b]"}},
      {"duplicate link", robot(link("a") + link("a")), {}, {"'a'", "not unique"}},
      {"missing link", robot(link("a") + joint("j", "revolute", "a", "b")), {}, {"[b]", "[j]"}},
      {"no moving joint",
       robot(two + joint("j", "fixed", "a", "b")),
       {.key = "joints", .value = "0", .limit = "at least 1"}},
      {"empty name",
       "<robot name=''>" + one_joint() + "</robot>",
       {.key = "robot", .value = "", .limit = "a name"}},
      {"SDF",
       "<sdf version='1.6'><model name='m'/></sdf>",
       {.line = 1, .key = "sdf", .value = "sdf", .limit = "URDF"},
       {"sdf2urdf"}},
      {"MJCF",
       "<!-- arm -->\n<mujoco model='m'><worldbody/></mujoco>",
       {.line = 2, .key = "mujoco", .value = "mujoco", .limit = "URDF"},
       {"mjcf"}},
      {"not closed", "<robot name='r'><link name='a'/>", {}, {"Error reading Element value"}},
      {"half a tag", "<robot name='r'><link name='a", {.line = 1}, {"closing quote"}},
      {"quote missing", "<robot name='r'>\n<link name='a/>\n<link name='b'/></robot>", {.line = 2}, {"'<'"}},
      {"comment not closed", "<robot name='r'><!-- </robot>", {.line = 1}, {"'<!--'"}},
      {"empty", "", {.line = 0}, {"is empty"}},
      {"UTF-16", std::string("\xFF\xFE<\0r\0", 6), {.line = 0}, {"UTF-16"}},
      {"NUL", std::string("<robot\0 name='r'/>", 18), {.line = 0}, {"binary"}},
      {"entity bomb", "<!DOCTYPE r [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;'>]><robot name='r'/>", {.line = 1}},
      {"xacro element",
       "<robot name='r'>\n<xacro:include filename='x'/></robot>",
       {.line = 2, .value = "<xacro:include>", .limit = "URDF without xacro"},
       {"arm.urdf > arm_expanded.urdf", "ros2 run xacro xacro"}},
      {"xacro value",
       robot(one_joint("<inertial><mass value='${m}'/></inertial>")),
       {.line = 3, .value = "${m}", .limit = "URDF without xacro"}},
      {"xacro argument",
       robot(one_joint("<visual name='$(arg prefix)'/>")),
       {.line = 3, .value = "$(arg prefix)", .limit = "URDF without xacro"}},
  };
  for (const Refused& row : table) {
    const InputError error = error_of(row.text);
    const std::string message = error.what();
    ASSERT_THAT(error, refused_at(row.fields)) << row.what;
    for (const std::string& hint : row.hints) ASSERT_THAT(message, HasSubstr(hint)) << row.what;
    ASSERT_LT(message.size(), 3000U) << row.what;
  }
}

TEST_F(UrdfBadInput, XacroIsRefusedWithTheCommandThatExpandsThisFile) {
  for (const auto& [name, expanded] :
       {std::pair("arm.urdf.xacro", "arm.urdf"), std::pair("arm.xacro", "arm.urdf"),
        std::pair("arm.urdf", "arm_expanded.urdf"), std::pair("my arm.xacro", "'my arm.urdf'")}) {
    std::string path = folder_ + "/" + name;
    std::ofstream(path) << "<robot name='r'><xacro:include filename='x'/></robot>";
    const std::string message = error_of_file(path).what();
    if (path.find(' ') != std::string::npos) path = "'" + path + "'";
    EXPECT_THAT(message, HasSubstr(fmt::format("first: xacro {} > {} (", path, expanded)));
  }
}

TEST_F(UrdfBadInput, MoreThanTwelveJointsAreRefused) {
  std::string text = link("l0");
  for (int i = 1; i <= 13; ++i)
    text += link(fmt::format("l{}", i)) +
            joint(fmt::format("j{:02}", i), "revolute", fmt::format("l{}", i - 1), fmt::format("l{}", i));
  EXPECT_THAT(error_of(robot(text)),
              refused_at({.key = "j13", .value = "13", .limit = "at most 12 moving joints"}));
}

TEST_F(UrdfBadInput, FilesThatCannotBeReadAreRefused) {
  EXPECT_THAT(error_of_file(folder_ + "/missing.urdf").what(), testing::EndsWith(": no such file"));
  EXPECT_THAT(error_of_file(folder_), refused_at({.line = 0, .limit = "a URDF file"}));
  const std::string path = write("");
  std::filesystem::resize_file(path, (32u << 20) + 1);
  EXPECT_THAT(error_of_file(path), refused_at({.limit = "at most 32 MB"}));
}

TEST_F(UrdfBadInput, DeepNestingAndTooManyLinksAreRefusedBeforeParsing) {
  std::string deep = "<robot name='r'>";
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_THAT(error_of(deep), refused_at({.line = 1, .key = "a", .limit = "at most 1000 levels"}));

  std::string links = link("l0");
  for (int i = 1; i <= 10'000; ++i)
    links += link(fmt::format("l{}", i), "") +
             joint(fmt::format("j{}", i), "fixed", fmt::format("l{}", i - 1), fmt::format("l{}", i));
  // Line 1 is the robot, line 2 its first link; every further one has a line behind it with its joint.
  EXPECT_THAT(error_of(robot(links)), refused_at({.line = 20'001, .limit = "at most 10000 links"}));
}

TEST_F(UrdfBadInput, TagsWithHundredsOfAttributesAreRefusedBeforeParsing) {
  std::string text = "<robot name='r'";
  for (int i = 0; i < 60'000; ++i) text += fmt::format(" a{}='1'", i);
  EXPECT_THAT(error_of(text + "/>"), refused_at({.line = 1, .limit = "at most 100 attributes"}));
}

TEST_F(UrdfBadInput, HundredsOfThousandsOfElementsAreRefusedBeforeParsing) {
  std::string text = "<robot name='r'>";
  for (int i = 0; i < 200'000; ++i) text += "<a/>";
  EXPECT_THAT(error_of(text + "</robot>"), refused_at({.line = 1, .limit = "at most 200000 elements"}));
}

TEST_F(UrdfBadInput, AsManyFixedLinksAsAllowedAreMergedWithoutRecursion) {
  std::string text = one_joint();
  for (int i = 0; i < 9'998; ++i)
    text +=
        link(fmt::format("l{}", i)) + joint(fmt::format("j{}", i), "fixed",
                                            i == 0 ? "b" : fmt::format("l{}", i - 1), fmt::format("l{}", i));
  EXPECT_EQ(read(robot(text)).chain.link[0].mass, 9'999.0);
}

}  // namespace urdf_bad_input_test
}  // namespace armtune::internal

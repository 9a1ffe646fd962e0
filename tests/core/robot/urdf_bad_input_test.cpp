// Files that cannot be used, each refused with the names and values to look for.

#include "tests/core/support/urdf_text.hpp"

namespace armtune::internal {
namespace urdf_bad_input_test {

using test::joint;
using test::kInertial;
using test::kLimit;
using test::link;
using test::one_joint;
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
  EXPECT_THAT(refusal(robot(one_joint("<inertial><mass value='%s%s%n'/></inertial>"))),
              AllOf(HasSubstr("arm.urdf:3:"), HasSubstr("'%'")));
  EXPECT_THAT(refusal(robot(one_joint("<inertial><mass value=%s%s%n /></inertial>"))), HasSubstr("'%'"));
  EXPECT_THAT(refusal(robot(one_joint("<inertial><mass value='&#37;s'/></inertial>"))), HasSubstr("'&#..;'"));
}

struct Refused {
  const char* what;
  std::string text;
  std::vector<std::string> says;
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
      {"no inertial", robot(one_joint("")), {"link 'b'", "mass is 0 kg"}},
      {"zero mass", robot(one_joint(zero_mass("0", ones))), {"link 'b'", "mass is 0 kg"}},
      {"negative mass", robot(one_joint(zero_mass("-2", ones))), {"b (mass -2 kg)", "--sidecar"}},
      {"a planet's mass",
       robot(one_joint(zero_mass("3.6e41", ones))),
       {"link 'b'", "mass is 3.6e+41 kg", "at most 1000000 kg"}},
      {"a second inertial",
       robot(one_joint(std::string(kInertial) + kInertial, "<axis xyz='0 0 1'/>" + kLimit)),
       {"arm.urdf:", "second <inertial> in one <link>"}},
      {"a second axis",
       robot(one_joint(kInertial, axis + "<axis xyz='1 0 0'/>" + kLimit)),
       {"arm.urdf:", "second <axis> in one <joint>"}},
      {"an origin that is nowhere",
       robot(one_joint(kInertial, "<origin xyz='1e300 0 0'/>" + axis + kLimit)),
       {"joint 'j'", "1e+300 m", "at most 10000 m"}},
      {"a centre of mass that is nowhere",
       robot(one_joint("<inertial><origin xyz='0 2e4 0'/><mass value='1'/><inertia ixx='1' iyy='1' izz='1' "
                       "ixy='0' ixz='0' iyz='0'/></inertial>")),
       {"link 'b'", "20000 m", "at most 10000 m"}},
      {"an inertia of no link",
       robot(one_joint(zero_mass("1", "ixx='1e300' iyy='1e300' izz='1e300'"))),
       {"link 'b'", "kg m^2", "at most 1e+14"}},
      {"a slide without end",
       robot(two + joint("j", "prismatic", "a", "b",
                         axis + "<limit lower='0' upper='1e300' velocity='1' effort='1'/>")),
       {"joint 'j'", "1e+300 m"}},
      {"negative inertia",
       robot(one_joint(zero_mass("1", "ixx='-1' iyy='1' izz='1'"))),
       {"b (moment -1 kg m^2)", "--sidecar"}},
      {"triangle",
       robot(one_joint(zero_mass("1", "ixx='1' iyy='1' izz='3'"))),
       {"b (principal moments 1, 1, 3 kg m^2)", "triangle", "--sidecar"}},
      {"no inertia about the axis",
       robot(one_joint(zero_mass("1", "ixx='1' iyy='1' izz='0'"))),
       {"b (no inertia about the axis of its joint)", "--sidecar"}},
      {"zero axis", robot(one_joint(kInertial, "<axis xyz='0 0 0'/>" + kLimit)), {"joint 'j'", "'0 0 0'"}},
      {"NaN axis", robot(one_joint(kInertial, "<axis xyz='0 nan 0'/>" + kLimit)), {"joint [j]", "nan"}},
      {"NaN origin",
       robot(one_joint(kInertial, "<origin xyz='0 nan 0'/>" + axis + kLimit)),
       {"joint [j]", "nan"}},
      {"no limit", robot(one_joint(kInertial, axis)), {"joint 'j'", "lower", "missing"}},
      {"no effort",
       robot(one_joint(kInertial, axis + "<limit lower='0' upper='1' velocity='1'/>")),
       {"joint 'j'", "effort limit is 0 N m", "robot YAML"}},
      {"crossed",
       robot(one_joint(kInertial, axis + "<limit lower='2' upper='1' velocity='1' effort='1'/>")),
       {"joint 'j'", "2 rad", "upper limit 1"}},
      {"no torque",
       robot(one_joint(kInertial, axis + "<limit lower='0' upper='1' velocity='1' effort='0'/>")),
       {"joint 'j'", "effort limit is 0 N m"}},
      {"no speed",
       robot(one_joint(kInertial, axis + "<limit lower='0' upper='1' velocity='0' effort='1'/>")),
       {"joint 'j'", "velocity limit is 0 rad/s"}},
      {"negative damping",
       robot(one_joint(kInertial, axis + kLimit + "<dynamics damping='-3'/>")),
       {"joint 'j'", "viscous friction is -3"}},
      {"continuous",
       robot(two + joint("j", "continuous", "a", "b", axis)),
       {"joint 'j'", "velocity", "effort"}},
      {"floating", robot(two + joint("j", "floating", "a", "b")), {"joint 'j'", "floating"}},
      {"planar", robot(two + joint("j", "planar", "a", "b")), {"joint 'j'", "planar"}},
      {"spherical", robot(two + joint("j", "spherical", "a", "b")), {"[j]", "[spherical]"}},
      {"mimic",
       robot(two + joint("j", "revolute", "a", "b", axis + kLimit + "<mimic joint='k'/>")),
       {"joint 'j'", "'k'"}},
      {"mimic of itself",
       robot(two + joint("j", "revolute", "a", "b", axis + kLimit + "<mimic joint='j'/>")),
       {"joint 'j'", "mimic"}},
      {"no velocity",
       robot(one_joint(kInertial, axis + "<limit lower='0' upper='1' effort='1'/>")),
       {"joint 'j'", "velocity limit is 0 rad/s", "robot YAML"}},
      {"NaN limit",
       robot(one_joint(kInertial, axis + "<limit lower='nan' upper='1' velocity='1' effort='1'/>")),
       {"(nan)", "lower"}},
      {"NaN rpy",
       robot(one_joint(kInertial, "<origin rpy='0 nan 0'/>" + axis + kLimit)),
       {"joint [j]", "nan"}},
      {"NaN damping",
       robot(one_joint(kInertial, axis + kLimit + "<dynamics damping='nan'/>")),
       {"(nan)", "damping"}},
      {"duplicate joint",
       robot(three + joint("j", "revolute", "a", "b") + joint("j", "revolute", "b", "c")),
       {"'j'", "not unique"}},
      {"name of a megabyte",
       robot(link("a") + link(std::string(1'000'000, 'x')) +
             joint("j", "revolute", "a", std::string(1'000'000, 'x'), axis + kLimit)),
       {"link 'xxx", "1000000 bytes", "at most 255 bytes"}},
      {"name of a formula",
       robot(link("a") + link("b") + joint("=j", "revolute", "a", "b", axis + kLimit)),
       {"joint '=j'", "formula"}},
      {"name that is not UTF-8",
       robot(link("a") + link("b\xE9") + joint("j", "revolute", "a", "b\xE9", axis + kLimit)),
       {"link 'b", "not UTF-8"}},
      {"two branches",
       robot(three + joint("j", "revolute", "a", "b") + joint("k", "revolute", "a", "c")),
       {"needs a serial arm", "'j'", "'k'"}},
      {"two branches over a fixed link",
       robot(three + link("d") + joint("f", "fixed", "a", "b") + joint("j", "revolute", "a", "c") +
             joint("k", "prismatic", "b", "d")),
       {"needs a serial arm", "'j'", "'k'"}},
      {"cycle below the root",
       robot(three + joint("j", "revolute", "a", "b") + joint("k", "revolute", "b", "c") +
             joint("l", "revolute", "c", "b")),
       {"link 'b'", "second parent joint"}},
      {"detached cycle",
       robot(three + link("d") + joint("j", "revolute", "a", "b") + joint("k", "fixed", "c", "d") +
             joint("l", "fixed", "d", "c")),
       {"link 'c'", "root link 'a'"}},
      {"diamond",
       robot(three + link("d") + joint("j", "fixed", "a", "b") + joint("k", "fixed", "a", "c") +
             joint("l", "fixed", "b", "d") + joint("m", "fixed", "c", "d")),
       {"link 'd'", "second parent joint"}},
      {"two roots", robot(two), {"[a]", "[b]"}},
      {"duplicate link", robot(link("a") + link("a")), {"'a'", "not unique"}},
      {"missing link", robot(link("a") + joint("j", "revolute", "a", "b")), {"[b]", "[j]"}},
      {"no moving joint", robot(two + joint("j", "fixed", "a", "b")), {"robot 'r'", "nothing to control"}},
      {"empty name", "<robot name=''>" + one_joint() + "</robot>", {"robot has an empty name"}},
      {"SDF", "<sdf version='1.6'><model name='m'/></sdf>", {":1:", "SDF", "sdf2urdf"}},
      {"MJCF", "<!-- arm -->\n<mujoco model='m'><worldbody/></mujoco>", {":2:", "MJCF", "mjcf"}},
      {"not closed", "<robot name='r'><link name='a'/>", {"Error reading Element value"}},
      {"half a tag", "<robot name='r'><link name='a", {":1:", "closing quote"}},
      {"quote missing", "<robot name='r'>\n<link name='a/>\n<link name='b'/></robot>", {":2:", "'<'"}},
      {"comment not closed", "<robot name='r'><!-- </robot>", {":1:", "'<!--'"}},
      {"empty", "", {"is empty"}},
      {"UTF-16", std::string("\xFF\xFE<\0r\0", 6), {"UTF-16"}},
      {"NUL", std::string("<robot\0 name='r'/>", 18), {"binary"}},
      {"entity bomb", "<!DOCTYPE r [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;'>]><robot name='r'/>", {":1:"}},
      {"xacro element",
       "<robot name='r'>\n<xacro:include filename='x'/></robot>",
       {":2:", "<xacro:include>", "arm.urdf > arm_expanded.urdf", "ros2 run xacro xacro"}},
      {"xacro value",
       robot(one_joint("<inertial><mass value='${m}'/></inertial>")),
       {":3:", "${m}", "xacro"}},
      {"xacro argument", robot(one_joint("<visual name='$(arg prefix)'/>")), {"$(arg prefix)", "xacro"}},
  };
  for (const Refused& row : table) {
    const std::string message = refusal(row.text);
    for (const std::string& part : row.says) ASSERT_THAT(message, HasSubstr(part)) << row.what;
    ASSERT_LT(message.size(), 3000U) << row.what;
    ASSERT_THAT(message, testing::Not(HasSubstr("\n"))) << row.what;
  }
}

TEST_F(UrdfBadInput, XacroIsRefusedWithTheCommandThatExpandsThisFile) {
  for (const auto& [name, expanded] :
       {std::pair("arm.urdf.xacro", "arm.urdf"), std::pair("arm.xacro", "arm.urdf"),
        std::pair("arm.urdf", "arm_expanded.urdf"), std::pair("my arm.xacro", "'my arm.urdf'")}) {
    std::string path = folder_ + "/" + name;
    std::ofstream(path) << "<robot name='r'><xacro:include filename='x'/></robot>";
    const std::string message = refusal_of_file(path);
    if (path.find(' ') != std::string::npos) path = "'" + path + "'";
    EXPECT_THAT(message, HasSubstr(fmt::format("first: xacro {} > {} (", path, expanded)));
  }
}

TEST_F(UrdfBadInput, MoreThanTwelveJointsAreRefused) {
  std::string text = link("l0");
  for (int i = 1; i <= 13; ++i)
    text += link(fmt::format("l{}", i)) +
            joint(fmt::format("j{:02}", i), "revolute", fmt::format("l{}", i - 1), fmt::format("l{}", i));
  EXPECT_THAT(refusal(robot(text)), AllOf(HasSubstr("'j13'"), HasSubstr("at most 12")));
}

TEST_F(UrdfBadInput, FilesThatCannotBeReadAreRefused) {
  EXPECT_THAT(refusal_of_file(folder_ + "/missing.urdf"), HasSubstr("no such file"));
  EXPECT_THAT(refusal_of_file(folder_), HasSubstr("is a directory"));
  const std::string path = write("");
  std::filesystem::resize_file(path, (32u << 20) + 1);
  EXPECT_THAT(refusal_of_file(path), HasSubstr("larger than 32 MB"));
}

TEST_F(UrdfBadInput, DeepNestingAndTooManyLinksAreRefusedBeforeParsing) {
  std::string deep = "<robot name='r'>";
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_THAT(refusal(deep), HasSubstr("nested deeper than 1000"));

  std::string links = link("l0");
  for (int i = 1; i <= 10'000; ++i)
    links += link(fmt::format("l{}", i), "") +
             joint(fmt::format("j{}", i), "fixed", fmt::format("l{}", i - 1), fmt::format("l{}", i));
  EXPECT_THAT(refusal(robot(links)), HasSubstr("more than 10000 links"));
}

TEST_F(UrdfBadInput, TagsWithHundredsOfAttributesAreRefusedBeforeParsing) {
  std::string text = "<robot name='r'";
  for (int i = 0; i < 60'000; ++i) text += fmt::format(" a{}='1'", i);
  EXPECT_THAT(refusal(text + "/>"), HasSubstr("more than 100 attributes"));
}

TEST_F(UrdfBadInput, HundredsOfThousandsOfElementsAreRefusedBeforeParsing) {
  std::string text = "<robot name='r'>";
  for (int i = 0; i < 200'000; ++i) text += "<a/>";
  EXPECT_THAT(refusal(text + "</robot>"), HasSubstr("more than 200000 elements"));
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

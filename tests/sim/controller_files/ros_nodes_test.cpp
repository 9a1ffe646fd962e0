// Nodes of ROS 2 receive parameters through wildcards and through names with dots, as rcl gives them.

#include "sim/controller_files/ros_nodes.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/controller_files/ros_controllers.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace ros_nodes_test {

using test::refused_at;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<RosNode> nodes(const std::string& text) {
  return ros2_nodes(*yaml::read_placed(text, "f.yaml"), "f.yaml");
}

std::vector<std::string> names(const std::string& text) {
  std::vector<std::string> found;
  for (const RosNode& node : nodes(text)) found.push_back(node.name);
  return found;
}

/// The value of p of j1 in the only node.
std::string p_of(const std::string& text) {
  const std::vector<RosNode> found = nodes(text);
  if (found.size() != 1) return fmt::format("{} nodes", found.size());
  return found.front().parameters->find("gains")->find("j1")->find("p")->text;
}

std::string node(const std::string& name, const std::string& parameters) {
  return "\"" + name + "\": {ros__parameters: {" + parameters + "}}\n";
}

const std::string kGains = "gains: {j1: {p: 1.0}}";

TEST(RosNodes, ReceiveTheParametersOfEveryWildcardThatMatches) {
  for (const char* wildcard : {"/**", "/**/*", "/**/arm", "/left/*", "left/*", "left/arm"}) {
    const std::string text = node("/left/arm", kGains) + node(wildcard, "command_interfaces: [effort]");
    EXPECT_THAT(names(text), ElementsAre("/left/arm")) << wildcard;
    EXPECT_NE(nodes(text)[0].parameters->find("command_interfaces"), nullptr) << wildcard;
  }
  for (const char* other : {"/**/leg", "/right/*", "/*", "arm", "/left/arm/more"}) {
    const RosNode arm = nodes(node("/left/arm", kGains) + node(other, "command_interfaces: [effort]"))[0];
    EXPECT_EQ(arm.parameters->find("command_interfaces"), nullptr) << other;
  }
}

// rclcpp applies the names in the order of the file. Which of them is more specific does not count.
TEST(RosNodes, ALaterValueReplacesAnEarlierOne) {
  const std::string own = node("arm", "gains: {j1: {p: 2.0}}");
  EXPECT_EQ(p_of(own + node("/**", kGains)), "1.0");
  EXPECT_EQ(p_of(node("/**", kGains) + own), "2.0");
  EXPECT_EQ(p_of(node("/**", kGains) + own + node("/**", "gains: {j1: {p: 3.0}}")), "2.0")
      << "all parameters of a name have the place of its first entry";
  EXPECT_EQ(p_of(node("arm", "gains: {j1: {p: 2.0}}, gains.j1.p: 4.0")), "4.0");
  EXPECT_EQ(p_of(node("arm", "gains.j1.p: 4.0, gains: {j1: {p: 2.0}}")), "2.0");
}

TEST(RosNodes, AWildcardIsOneItselfIfNoOtherReceivesItsParameters) {
  const std::string all = node("/**", kGains + ", command_interfaces: [effort]");
  EXPECT_THAT(names(all), ElementsAre("/**"));
  EXPECT_THAT(names(all + node("camera", "rate: 30")), ElementsAre("/**")) << "a camera is no controller";
  EXPECT_THAT(names(all + node("arm", "command_interfaces: [velocity]")), ElementsAre("arm"));
  EXPECT_THAT(names(node("/**/arm", kGains) + node("leg", kGains)), ElementsAre("/**/arm", "leg"));
}

TEST(RosNodes, NamesWithDotsAreThoseOfNestedMaps) {
  for (const char* gains :
       {"gains: {j1.a: {p: 1.0}}", "gains: {j1.a.p: 1.0}", "gains.j1.a: {p: 1.0}", "gains.j1.a.p: 1.0"}) {
    const std::string text = node("arm", std::string(gains) + ", command_interfaces: [effort]");
    EXPECT_TRUE(may_hold_controllers(text)) << gains;
    const auto all = ros_controllers(text, "f.yaml");
    ASSERT_EQ(all.size(), 1U) << gains;
    EXPECT_EQ(all[0].parameters->find("gains")->find("j1.a")->find("p")->text, "1.0") << gains;
  }
  EXPECT_FALSE(may_hold_controllers("file: gains.yaml\nother: 1\n"));
}

// What is written is refused where the wildcards would make a small file large.
TEST(RosNodes, WildcardsDoNotMultiplyTheFile) {
  std::string text = "/**:\n  ros__parameters:\n";
  for (int k = 0; k < 1000; ++k) text += fmt::format("    p{}: 1\n", k);
  for (int k = 0; k < 300; ++k) text += node(fmt::format("n{}", k), "command_interfaces: [effort]");
  EXPECT_THAT([&] { nodes(text); },
              refused_at({.file = "f.yaml", .line = testing::Gt(0), .limit = HasSubstr("200000")}));
}

}  // namespace ros_nodes_test
}  // namespace armtune::internal

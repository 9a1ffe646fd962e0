// Every file of YAML that armtune writes, with names in it that mean something to YAML: armtune's own reader
// and PyYAML, which is what ROS reads parameters with, find the same texts in it.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "core/robot/theta.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/yaml/document.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/sim/support/hostile_texts.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/gains/gains_formats.hpp"
#include "tuner/identification/excitation.hpp"
#include "tuner/identification/identification_files.hpp"
#include "tuner/run/run_record.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace hostile_names_identified_test {

/// Keys and texts in the order of the file, in hexadecimal; what is no text is "-".
constexpr const char* kPyYaml = R"(
import sys, yaml
def walk(node):
    if isinstance(node, dict):
        for key, value in node.items():
            print("k", key.encode().hex() if isinstance(key, str) else "-")
            walk(value)
    elif isinstance(node, list):
        for value in node: walk(value)
    else:
        print("v", node.encode().hex() if isinstance(node, str) else "-")
for i in range(int(sys.argv[2])):
    print("text", i)
    with open(f"{sys.argv[1]}/{i}.yaml", "rb") as file: walk(yaml.safe_load(file))
)";

std::string hex(const std::string& text) {
  std::string digits;
  for (const char c : text) digits += fmt::format("{:02x}", static_cast<unsigned char>(c));
  return digits;
}

/// The same of armtune's reader. What it takes for a number or a truth value is "-", for others may take it
/// for a text: 1e-05 to YAML 1.1.
std::string walked(const yaml::Node& node) {
  std::string lines;
  if (node.kind() == yaml::Node::Kind::kMap) {
    for (const auto& [key, value] : node.entries()) lines += "k " + hex(key) + "\n" + walked(value);
  } else if (node.kind() == yaml::Node::Kind::kSequence) {
    for (const yaml::Node& item : node.items()) lines += walked(item);
  } else {
    try {
      lines = "v " + hex(node.as_string()) + "\n";
    } catch (const InputError&) {
      lines = "v -\n";
    }
  }
  return lines;
}

class HostileNames : public testing::Test {
 protected:
  /// Gives armtune's tree of the text, which PyYAML reads at the end of the test.
  yaml::Node read(const std::string& text) {
    yaml::Node root = yaml::parse_text(text, "text");
    expected_ += fmt::format("text {}\n{}", read_, walked(root));
    folder_.write(fmt::format("{}.yaml", read_++), text);
    return root;
  }

  void TearDown() override {
    if (std::system("python3 -c 'import yaml' > /dev/null 2>&1") != 0) return;
    const std::string script = folder_.write("walk.py", kPyYaml);
    const std::string out = folder_ / "out.txt";
    const std::string err = folder_ / "err.txt";
    EXPECT_EQ(
        std::system(
            fmt::format("python3 {} {} {} > {} 2> {}", script, folder_.path(), read_, out, err).c_str()),
        0)
        << test::read_text(err);
    std::istringstream own(expected_);
    std::istringstream other(test::read_text(out));
    std::string a;
    std::string b;
    std::string text;
    while (std::getline(own, a)) {
      ASSERT_TRUE(std::getline(other, b)) << "PyYAML ends in " << text << ", before " << a;
      if (a.starts_with("text")) text = a;
      if (a == "v -") continue;
      ASSERT_EQ(a, b) << text << ":\n" << test::read_text(folder_ / (text.substr(5) + ".yaml"));
    }
    EXPECT_FALSE(std::getline(other, b)) << "PyYAML finds more: " << b;
  }

  const test::TemporaryFolder folder_;
  const std::vector<std::string> texts_ = test::hostile_texts();

 private:
  std::string expected_;
  int read_ = 0;
};

TEST_F(HostileNames, InARunsRecord) {
  RunRecord run;
  run.kind = RunKind::kIdentify;
  run.command = "armtune";
  IdentificationFacts& found = run.identification.emplace();
  for (const std::string& text : texts_) {
    found.torque.push_back({text, 1.0, 0.1, {}, {}});
    found.accepted_although.push_back(text);
    run.inputs.push_back({"folder/" + text, text, "inputs/" + text});
    run.command += " " + text;
  }
  const std::string json = run_record_json(run);
  EXPECT_EQ(parse_run_record(json, "run.json"), run);
  // Python's own reader finds the same texts.
  if (std::system("python3 -c '' > /dev/null 2>&1") != 0) return;
  const std::string file = folder_.write("run.json", json);
  const std::string script = folder_.write("texts.py",
                                           "import json, sys\n"
                                           "run = json.load(open(sys.argv[1], 'rb'))\n"
                                           "for text in run['identification']['accepted_although']:\n"
                                           "    print(text.encode().hex())\n");
  const std::string out = folder_ / "texts.txt";
  ASSERT_EQ(std::system(fmt::format("python3 {} {} > {}", script, file, out).c_str()), 0);
  std::string expected;
  for (const std::string& text : texts_) expected += hex(text) + "\n";
  EXPECT_EQ(test::read_text(out), expected);
}

TEST_F(HostileNames, InCommentsOfGains) {
  const auto joints = joint_names(*test::scenario_of("moving_target").robot);
  GainsFile file;
  file.gains = load_gains("published", joints);
  file.joints = texts_;
  for (const std::string& text : texts_) file.origin.emplace_back(text, text);
  const std::string none = walked(read(gains_yaml(file.gains, {})));
  EXPECT_EQ(walked(read(gains_yaml(file.gains, texts_))), none);
  for (const GainsFormat format : {GainsFormat::kYaml, GainsFormat::kRos1, GainsFormat::kRos2}) {
    const std::string bare = gains_text({file.gains, joints, {}, {}, {}}, format);
    EXPECT_EQ(walked(read(gains_text(file, format))), walked(yaml::parse_text(bare, "text")));
  }
}

TEST_F(HostileNames, OfLinksAndJointsInWhatIdentifyAndExciteWrite) {
  for (const std::string& text : texts_) {
    RobotModel arm = test::ur10();
    arm.joints[1].link = text;
    arm.joints[2].name = text;
    arm.base_link = text;
    arm.tip_link = text;
    const ParameterVector theta = theta_of(arm.chain);
    const yaml::Node written = read(theta_yaml(arm, theta, {text}));
    const auto names = theta_names(arm);
    ASSERT_EQ(written.entries().size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      EXPECT_EQ(written.entries()[i].first, names[i]);
      EXPECT_EQ(written.entries()[i].second.as_number(), theta[static_cast<Eigen::Index>(i)]);
    }
    EXPECT_EQ(read(identified_robot_yaml(arm, text)).find("urdf")->as_string(), text);
    const auto joints = joint_names(arm);
    Excitation excitation;
    excitation.center.setZero(arm.n());
    excitation.sine.setConstant(arm.n(), 2, 0.25);
    excitation.cosine.setConstant(arm.n(), 2, 0.5);
    const std::string as_yaml = excitation_yaml(excitation, joints);
    read(as_yaml);
    EXPECT_EQ(load_excitation(folder_.write("excitation.yaml", as_yaml), joints).sine, excitation.sine);
  }
}

TEST_F(HostileNames, OfScenariosAndJointsInStudies) {
  const test::ShortStudy files;
  const Study given = load_study(files.path());
  for (const std::string& text : texts_) {
    Study study = given;
    study.description = text;
    study.scenarios.front().name = text;
    study.space.free.front().entry.name = text;
    study.warm.emplace();
    study.warm->parameters = {text, "b"};
    study.sweep = {{{0}, {0.5, 2.0}}};
    const yaml::Node root = read(study_yaml(study, "gains.yaml", "start/" + text));
    EXPECT_EQ(root.find("description")->as_string(), text);
    EXPECT_EQ(root.find("parameters")->items().front().find("name")->as_string(), text);
    EXPECT_EQ(root.find("objective")->items().front().find("scenarios")->as_strings().front(), text);
    EXPECT_EQ(root.find("warm_start")->find("parameters")->as_strings(), study.warm->parameters);
  }
}

}  // namespace hostile_names_identified_test
}  // namespace armtune::internal

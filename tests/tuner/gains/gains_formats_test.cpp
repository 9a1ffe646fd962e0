#include "tuner/gains/gains_formats.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <regex>

#include "core/control/laws/controller_kind.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/yaml/document.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tests/sim/support/ros_parameters.hpp"

namespace armtune::internal {
namespace gains_formats_test {

using test::kRosParameters;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr GainsFormat kFormats[] = {GainsFormat::kYaml, GainsFormat::kRos1, GainsFormat::kRos2};

class GainsFormats : public testing::Test {
 protected:
  const RobotModel& robot() const { return *arm_; }

  GainsFile published() const {
    GainsFile file;
    file.joints = joint_names(robot());
    file.gains = load_gains("published", file.joints);
    return file;
  }

  /// Of every controller, with numbers of any size.
  std::vector<GainsFile> files() {
    std::uniform_real_distribution<double> exponent(-12.0, 12.0);
    std::vector<GainsFile> made;
    for (const ControllerKind* kind : controller_kinds()) {
      GainsFile file = published();
      file.gains = convert_gains(*kind, file.gains, robot(), in_si(robot(), file.gains.joint_space_goal));
      for (const GainField& field : fields_of(file.gains)) {
        for (double& x : numbers(file.gains, field)) {
          x = std::pow(10.0, exponent(generator_));
          if (x >= field.below) x = field.below / (1.0 + x);
        }
      }
      file.gains.release_radius = file.gains.obstacleInfluenceRadius * 1.1;
      file.gains.slerp_start_angle = file.gains.slerpAngularErrorThreshold * 0.7;
      file.gains.slerp_reference = SlerpReference::kCurrent;
      file.origin = {{"study", "a: b # c"}, {"input x\ny: 1", "of two lines"}};
      made.push_back(file);
    }
    return made;
  }

  static void expect_same(const Gains& read, const Gains& written) {
    EXPECT_EQ(read.controller, written.controller);
    for (const GainField& field : fields_of(written)) {
      if (!field.is_number()) {
        EXPECT_EQ(field_text(read, field), field_text(written, field)) << field.name;
        continue;
      }
      const auto a = numbers(read, field);
      const auto b = numbers(written, field);
      EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end())) << field.name;
    }
  }

  const std::shared_ptr<const RobotModel> arm_ = test::scenario_of("moving_target").robot;
  std::mt19937_64 generator_{16};
  const test::TemporaryFolder folder_;
};

TEST_F(GainsFormats, GainsOfEveryControllerReadBackToTheBit) {
  for (GainsFile file : files()) {
    for (const GainsFormat format : kFormats) {
      for (const char* node : {"", "my_controller", "/arm_1/effort_ctrl"}) {
        file.node = node;
        const std::string text = gains_text(file, format);
        expect_same(load_gains(folder_.write("gains.yaml", text), file.joints), file.gains);
      }
    }
  }
}

TEST_F(GainsFormats, EveryNumberIsOneToYaml11AndAFloatToRos2) {
  // YAML 1.1's float, as ROS 1's reader has it, needs a point and a signed exponent; ROS 2 takes no 5 for
  // a 5.0.
  const std::regex decimal(R"(-?[0-9]+\.[0-9]+(e[-+][0-9]+)?)");
  int seen = 0;
  for (const GainsFile& file : files()) {
    const std::string path = folder_.write("gains.yaml", gains_text(file, GainsFormat::kRos2));
    const yaml::Node root = yaml::parse_file(path);
    const yaml::Node& map = root.entries()[0].second.entries()[0].second;
    const std::string text = test::read_text(path);
    for (const GainField& field : fields_of(file.gains)) {
      if (!field.is_number() || map.find(field.name) == nullptr) continue;
      const auto at = text.find("\n    " + std::string(field.name) + ": ");
      ASSERT_NE(at, std::string::npos) << field.name;
      const auto end = text.find('\n', at + 1);
      std::string values = text.substr(text.find(": ", at) + 2, end - text.find(": ", at) - 2);
      if (values.front() == '[') values = values.substr(1, values.size() - 2);
      std::istringstream words(values);
      for (std::string word; std::getline(words, word, ',') && ++seen;)
        EXPECT_TRUE(std::regex_match(word.substr(word.find_first_not_of(' ')), decimal))
            << field.name << word;
    }
  }
  EXPECT_GT(seen, 100);
}

TEST_F(GainsFormats, APythonReaderOfYaml11ReadsTheSameNumbers) {
  if (std::system("python3 -c 'import yaml' 2>/dev/null") != 0)
    GTEST_SKIP() << "python3-yaml is not installed";
  for (const GainsFile& file : files()) {
    const std::string path = folder_.write("gains.yaml", gains_text(file, GainsFormat::kRos1));
    const std::string script =
        folder_.write("read.py",
                      "import sys, yaml\n"
                      "(fields,) = yaml.safe_load(open(sys.argv[1])).values()\n"
                      "for name, value in fields.items():\n"
                      "    for x in value if isinstance(value, list) else [value]:\n"
                      "        print(name, x.hex() if isinstance(x, float) else repr(x))\n");
    const std::string out = folder_ / "read.txt";
    ASSERT_EQ(std::system(("python3 " + script + " " + path + " > " + out).c_str()), 0);
    std::istringstream lines(test::read_text(out));
    std::string name, value;
    const auto next = [&](const char* wanted) {
      EXPECT_TRUE(lines >> name >> value) << wanted;
      EXPECT_EQ(name, wanted);
      return value;
    };
    if (file.gains.controller != "adaptive") {
      EXPECT_EQ(next("controller"), "'" + file.gains.controller + "'");
    }
    for (const GainField& field : fields_of(file.gains)) {
      for (const double x : numbers(file.gains, field))
        EXPECT_EQ(std::strtod(next(field.name).c_str(), nullptr), x);
      if (!field.is_number()) next(field.name);
    }
  }
}

TEST_F(GainsFormats, ThePublishedParameterFileComesBackWithAllItHas) {
  const std::string path = folder_.write("ros.yaml", kRosParameters);
  GainsFile file = published();
  file.gains = load_gains(path, file.joints);
  file.others = published_path(path);
  const std::string back = folder_.write("back.yaml", gains_text(file, GainsFormat::kRos1));
  const auto values = [](const yaml::Node& node) {
    return node.kind() == yaml::Node::Kind::kSequence ? node.as_numbers()
                                                      : std::vector<double>{node.as_number()};
  };
  const yaml::Node written = yaml::parse_file(back);
  const yaml::Node& fields = written.entries().at(0).second;
  EXPECT_EQ(written.entries().at(0).first, "simple_effort_ctrl");
  const yaml::Node original = yaml::parse_file(path);
  ASSERT_EQ(original.entries()[0].second.entries().size(), 15U);
  for (const auto& [key, value] : original.entries()[0].second.entries()) {
    ASSERT_NE(fields.find(key), nullptr) << key;
    EXPECT_EQ(values(*fields.find(key)), values(value)) << key;
  }
  // And once more, now to the byte.
  file.gains = load_gains(back, file.joints);
  file.others = published_path(back);
  EXPECT_EQ(gains_text(file, GainsFormat::kRos1), test::read_text(back));
}

TEST_F(GainsFormats, TheTopSaysWhereTheyCameFromInWhatOrderAndEachFieldItsUnit) {
  GainsFile file = published();
  file.origin = {{"study", "ur10_gaze"}, {"evil\nobstacleInfluenceRadius", "9"}};
  for (const GainsFormat format : kFormats) {
    const std::string text = gains_text(file, format);
    EXPECT_THAT(text, testing::StartsWith("# study: ur10_gaze\n# evil"));
    EXPECT_THAT(text, AllOf(HasSubstr("\n# order of six task-space numbers: x y z rx ry rz\n"),
                            HasSubstr("\n# order of joint numbers: shoulder_pan_joint shoulder_lift_joint"),
                            HasSubstr("per joint [N m s/rad]\n"), Not(HasSubstr("\nobstacle"))));
  }
  EXPECT_THAT(gains_text(file, GainsFormat::kRos1), HasSubstr("\nsimple_effort_ctrl:\n  # "));
  EXPECT_THAT(gains_text(file, GainsFormat::kRos2), HasSubstr("\n/**:\n  ros__parameters:\n    # "));
  file.node = "ctrl";
  EXPECT_THAT(gains_text(file, GainsFormat::kRos1), HasSubstr("\nctrl:\n  # "));
  EXPECT_THAT(gains_text(file, GainsFormat::kRos2), HasSubstr("\nctrl:\n  ros__parameters:\n    # "));
}

TEST_F(GainsFormats, ANameThatRosDoesNotTakeIsRefused) {
  GainsFile file = published();
  for (const char* node : {"a b", "1st", "a: {b", "a\nb", "ctrl#"}) {
    file.node = node;
    for (const GainsFormat format : kFormats)
      EXPECT_THAT(test::refusal([&] { gains_text(file, format); }), HasSubstr("valid ROS name")) << node;
  }
  EXPECT_THAT(test::refusal([] { gains_format_from_name("ros3"); }),
              AllOf(HasSubstr("'ros3'"), HasSubstr("ros2")));
}

}  // namespace gains_formats_test
}  // namespace armtune::internal

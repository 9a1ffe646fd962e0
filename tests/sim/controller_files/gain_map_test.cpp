// Numbers of a file that armtune does not know, bound to gains by a map: read, changed, read back.

#include "sim/controller_files/gain_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "sim/controller_files/changed_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/controller_files/parameter_file.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/without_numbers.hpp"

namespace armtune::internal {
namespace gain_map_test {

using test::refused_at;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

const std::vector<std::string> kJoints = {"j1", "j2", "j3"};

constexpr const char* kFile = R"(# Ein Regler, den armtune nicht kennt
/**:
  ros__parameters:
    stiffness: [600.0, 250.0,   50.0]   # N m/rad
    joints:
      - {name: j1, kd: 5e1}
      - {name: j2, kd: 20.0}
      - {name: j3, kd: +10.0}
    a/b: 0.25
)";

constexpr const char* kMap = R"(controller: joint_impedance
file: own.yaml
map:
  /**/ros__parameters/stiffness: joint_impedance_k
  /**/ros__parameters/joints/0/kd: joint_impedance_d/j1
  /**/ros__parameters/joints/2/kd: joint_impedance_d/j3
  /**/ros__parameters/joints/1/kd: joint_impedance_d/j2
  /**/ros__parameters/a/b: joint_impedance_filter
joint_impedance_torque_rate: 1000
)";

/// A folder with both files, and one text of the map in place of another.
class Files {
 public:
  explicit Files(const std::string& from = "", const std::string& to = "") {
    std::string map = kMap;
    if (!from.empty()) map.replace(map.find(from), from.size(), to);
    folder_.write("own.yaml", kFile);
    path = folder_.write("map.yaml", map);
  }
  std::string path;

 private:
  test::TemporaryFolder folder_;
};

/// The error with which a changed map is refused.
InputError refused(const std::string& from, const std::string& to) {
  const Files files(from, to);
  return test::input_error([&] { load_gains(files.path, kJoints); });
}

TEST(GainMap, BindsNumbersOfAnyFileToGains) {
  const Files files;
  const Gains gains = load_gains(files.path, kJoints);
  EXPECT_EQ(gains.controller, "joint_impedance");
  EXPECT_EQ(own(gains, "joint_impedance_k"), (JointVector(3) << 600.0, 250.0, 50.0).finished());
  EXPECT_EQ(own(gains, "joint_impedance_d"), (JointVector(3) << 50.0, 20.0, 10.0).finished());
  EXPECT_EQ(own(gains, "joint_impedance_filter")[0], 0.25);
  EXPECT_EQ(own(gains, "joint_impedance_torque_rate")[0], 1000.0) << "as the map gives it";
  EXPECT_EQ(own(gains, "joint_impedance_velocity_factor")[0], 1.0) << "the controller's default";
  EXPECT_EQ(gains.velocity_margin, 0.0) << "a robot has no velocity governor of armtune's";
  EXPECT_EQ(gains.velocity_barrier_gain, 0.0);
}

TEST(GainMap, ChangesTheNumbersAloneAndReadsThemBack) {
  const Files files;
  const ParameterFile file = read_parameter_file(files.path).value();
  Gains gains = controller_gains(file.controller, file.path, kJoints);
  own(gains, "joint_impedance_k") << 1.0 / 3.0, 250.0, 1e-7;
  own(gains, "joint_impedance_d") << 7.0, 0.1, 12345.678;
  const std::string changed = with_gains(file.text, file.controller, file.path, gains, kJoints);
  EXPECT_EQ(test::without_numbers(changed), test::without_numbers(kFile));
  const RosController again = with_text(file.controller, changed, file.path);
  EXPECT_EQ(controller_gains(again, file.path, kJoints).own, gains.own);
  const Gains before = controller_gains(file.controller, file.path, kJoints);
  std::string restored = with_gains(changed, again, file.path, before, kJoints);
  for (const auto& [now, was] : {std::pair{"kd: 50.0", "kd: 5e1"}, {"kd: 10.0", "kd: +10.0"}})
    restored.replace(restored.find(now), std::string(now).size(), was);
  EXPECT_EQ(restored, kFile);
}

TEST(GainMap, SaysWhatIsWrongWithAMap) {
  EXPECT_THAT(refused("controller: joint_impedance\n", "controller: adaptive\n"),
              refused_at({.file = EndsWith("map.yaml"), .line = 1, .key = "controller"}));
  EXPECT_THAT(refused("file: own.yaml", "file: other.yaml"), refused_at({.file = EndsWith("other.yaml")}));
  EXPECT_THAT(refused("/stiffness: j", "/stifness: j"),
              refused_at({.file = EndsWith("map.yaml"), .value = "/**/ros__parameters/stifness"}));
  for (const char* gain : {"joint_impedance_kk", "task_space_gains_p"})
    EXPECT_THAT(
        refused(": joint_impedance_k", std::string(": ") + gain),
        refused_at({.file = EndsWith("map.yaml"), .value = gain, .limit = HasSubstr("joint_impedance_k")}));
  EXPECT_THAT(refused("joint_impedance_d/j1", "joint_impedance_d/j4"),
              refused_at({.file = EndsWith("map.yaml"),
                          .key = "joint_impedance_d/j4",
                          .value = "j4",
                          .limit = "one of: j1, j2, j3"}));
  EXPECT_THAT(
      refused("joint_impedance_d/j1", "joint_impedance_d/j2"),
      refused_at({.file = EndsWith("own.yaml"), .line = 7, .value = "/**/ros__parameters/joints/1/kd"}));
  EXPECT_THAT(refused("joint_impedance_d/j1", "joint_impedance_d"),
              refused_at({.file = EndsWith("own.yaml"), .line = 6, .value = "1", .limit = "3"}));
  EXPECT_THAT(refused("joints/0/kd", "joints/00/kd"),
              refused_at({.value = "/**/ros__parameters/joints/00/kd"}));
  EXPECT_THAT(refused("joints/0/kd", "joints/0/kd/"),
              refused_at({.value = "/**/ros__parameters/joints/0/kd/"}));
  // A gain that is tuned needs a value for every joint, and only one.
  EXPECT_THAT(refused("  /**/ros__parameters/joints/1/kd: joint_impedance_d/j2\n", ""),
              refused_at({.key = "joint_impedance_d", .limit = "joint_impedance_d of j2"}));
  EXPECT_THAT(refused("joint_impedance_torque_rate: 1000", "joint_impedance_k: 7"),
              refused_at({.file = EndsWith("map.yaml"), .key = "joint_impedance_k"}));
  EXPECT_THAT(refused("file: own.yaml", "file: ''"), refused_at({.line = 2, .key = "file"}));
  EXPECT_THAT(refused("joints/0/kd", "joints/0/name"),
              refused_at({.file = EndsWith("own.yaml"), .line = 6, .value = "j1"}));
  EXPECT_THAT(refused("joint_impedance_torque_rate: 1000", "joint_impedance_torque_rates: 1000"),
              refused_at({.file = EndsWith("map.yaml"), .line = testing::Gt(0)}));
  EXPECT_THAT(refused("joint_impedance_torque_rate: 1000", "joint_impedance_k: [1, 2]"),
              refused_at({.key = "joint_impedance_k", .value = "2", .limit = "1 or 3"}));
  const Files files;
  EXPECT_THAT(test::refusal([&] { load_gains(files.path, kJoints, "", "node"); }), HasSubstr("'node'"));
}

// As in the parameter file of the Cartesian-Impedance-Controller package for ROS 2.
constexpr const char* kCartesianFile = R"(cartesian_impedance_controller:
  ros__parameters:
    stiffness:
      translation: {x: 200.0, y: 300.0, z: 400.0}
      rotation: {x: 20.0, y: 30.0, z: 40.0}
      nullspace_stiffness: 10.0
    damping:
      ratios: [1.0, 0.9, 0.8, 0.7, 0.6, 0.5]
)";

std::string cartesian_map(const std::string& damping = "damping/ratios: cartesian_impedance_damping_ratio") {
  std::string map = "controller: cartesian_impedance\nfile: own.yaml\nrate: 500\nmap:\n";
  const std::string node = "  cartesian_impedance_controller/ros__parameters/";
  for (const std::string axis : {"x", "y", "z"}) {
    map += node + "stiffness/translation/" + axis + ": cartesian_impedance_k/" + axis + "\n";
    map += node + "stiffness/rotation/" + axis + ": {gain: cartesian_impedance_k/r" + axis + ", factor: 2}\n";
  }
  return map + node + "stiffness/nullspace_stiffness: cartesian_impedance_nullspace_k\n" + node + damping +
         "\n";
}

// The rotational stiffness of armtune's law acts with half of its value on small errors.
TEST(GainMap, BindsAxesOfTheTaskWithFactors) {
  const test::TemporaryFolder folder;
  folder.write("own.yaml", kCartesianFile);
  const std::string map = folder.write("map.yaml", cartesian_map());
  const ParameterFile file = read_parameter_file(map).value();
  EXPECT_EQ(file.controller.rate, 500.0);
  Gains gains = load_gains(map, kJoints);
  EXPECT_EQ(gains.controller, "cartesian_impedance");
  EXPECT_EQ(own(gains, "cartesian_impedance_k"),
            (JointVector(6) << 200.0, 300.0, 400.0, 40.0, 60.0, 80.0).finished());
  EXPECT_EQ(own(gains, "cartesian_impedance_damping_ratio")[5], 0.5);
  EXPECT_EQ(own(gains, "cartesian_impedance_nullspace_k")[0], 10.0);
  EXPECT_EQ(own(gains, "cartesian_impedance_filter")[0], 0.0) << "the controller's default";

  own(gains, "cartesian_impedance_k")[3] = 50.0;
  const std::string changed = with_gains(file.text, file.controller, file.path, gains, kJoints);
  EXPECT_THAT(changed, HasSubstr("rotation: {x: 25.0, y: 30.0, z: 40.0}"));
  EXPECT_EQ(test::without_numbers(changed), test::without_numbers(kCartesianFile));
  EXPECT_THAT(
      [&] {
        folder.write("wrong.yaml", cartesian_map("damping/ratios: {gain: cartesian_impedance_damping_ratio, "
                                                 "factor: 0}"));
        read_parameter_file(folder / "wrong.yaml");
      },
      test::refused_at({.file = HasSubstr("wrong.yaml"), .key = HasSubstr("factor")}));
}

// As in Franka's example: one number for the three translations.
TEST(GainMap, BindsSeveralGainsToOneNumber) {
  const test::TemporaryFolder folder;
  folder.write("own.yaml", "translational_stiffness: 200.0\nrotational_stiffness: 10.0\nratio: 1.0\n");
  const auto map = [](const std::string& translations) {
    return "controller: cartesian_impedance\nfile: own.yaml\nmap:\n  translational_stiffness: " +
           translations +
           "\n  rotational_stiffness: {gain: [cartesian_impedance_k/rx, cartesian_impedance_k/ry, "
           "cartesian_impedance_k/rz], factor: 0.5}\ncartesian_impedance_damping_ratio: 1\n";
  };
  const std::string axes = "cartesian_impedance_k/x, cartesian_impedance_k/y, cartesian_impedance_k/z";
  const ParameterFile file = read_parameter_file(folder.write("map.yaml", map("[" + axes + "]"))).value();
  Gains gains = controller_gains(file.controller, file.path, kJoints);
  JointVector& k = own(gains, "cartesian_impedance_k");
  EXPECT_EQ(k, (JointVector(6) << 200.0, 200.0, 200.0, 5.0, 5.0, 5.0).finished());
  k = (JointVector(6) << 300.0, 300.0, 300.0, 5.5, 5.5, 5.5).finished();
  EXPECT_EQ(with_gains(file.text, file.controller, file.path, gains, kJoints),
            "translational_stiffness: 300.0\nrotational_stiffness: 11.0\nratio: 1.0\n");
  k[1] = 400.0;
  EXPECT_THAT([&] { with_gains(file.text, file.controller, file.path, gains, kJoints); },
              refused_at({.file = EndsWith("own.yaml"), .line = 1}));
  for (const std::string& wrong : {"[" + axes + ", cartesian_impedance_k/x]", std::string("[]")})
    EXPECT_THAT(
        [&] {
          const auto other = read_parameter_file(folder.write("wrong.yaml", map(wrong))).value();
          controller_gains(other.controller, other.path, kJoints);
        },
        refused_at({.file = testing::AnyOf(EndsWith("wrong.yaml"), EndsWith("own.yaml"))}))
        << wrong;
}

// Division and multiplication by a factor round the last digit, which is no loss.
TEST(GainMap, AFactorThatIsNoPowerOfTwoReadsBack) {
  const test::TemporaryFolder folder;
  folder.write("own.yaml", kCartesianFile);
  const std::string map = folder.write(
      "map.yaml",
      cartesian_map("damping/ratios: {gain: cartesian_impedance_damping_ratio, factor: 0.7071067811865476}"));
  const ParameterFile file = read_parameter_file(map).value();
  Gains gains = load_gains(map, kJoints);
  JointVector& ratio = own(gains, "cartesian_impedance_damping_ratio");
  for (int k = 1; k <= 50; ++k) {
    ratio = JointVector::Constant(6, 0.1 + 0.017 * k);
    const std::string changed = with_gains(file.text, file.controller, file.path, gains, kJoints);
    const Gains back = controller_gains(with_text(file.controller, changed, file.path), file.path, kJoints);
    EXPECT_LE((own(back, "cartesian_impedance_damping_ratio") - ratio).cwiseAbs().maxCoeff(), 1e-15);
  }
}

// A file of armtune's own may have other keys of these names.
TEST(GainMap, IsNotSeenInOtherFiles) {
  const test::TemporaryFolder folder;
  for (const char* text :
       {"map: {a: b}\n", "file: a\n# map: {}\n", "a: {map: {}, file: b, controller: c}\n",
        "x: &big 5.0\nnode: {map: m, file: f, controller: *big}\n", "map: {file: a, controller: b}\n"}) {
    EXPECT_FALSE(read_parameter_file(folder.write("f.yaml", text)).has_value()) << text;
    EXPECT_FALSE(is_parameter_file(folder / "f.yaml")) << text;
  }
  EXPECT_TRUE(is_parameter_file(Files().path));
}

TEST(GainMap, RefusesAPlaceThatTwoKeysFit) {
  const test::TemporaryFolder folder;
  folder.write("own.yaml", "a: {b/c: 300.0}\na/b: {c: 900.0}\n");
  const std::string map = folder.write(
      "map.yaml",
      "controller: position_streaming\nfile: own.yaml\nmap: {a/b/c: servo_gain}\nservo_lookahead_time: 0.1\n");
  EXPECT_THAT(test::refusal([&] { load_gains(map, kJoints); }),
              AllOf(HasSubstr("map.yaml"), HasSubstr("'a'"), HasSubstr("'a/b'")));
}

// Nested aliases and keys that contain '/' must not take exponential time.
TEST(GainMap, IsReadAtOnceWhateverTheFileHas) {
  const test::TemporaryFolder folder;
  std::string text = "l0: &l0 {x: 1.0}\n", place = "l60";
  for (int k = 1; k <= 60; ++k)
    text += "l" + std::to_string(k) + ": &l" + std::to_string(k) + " {a: *l" + std::to_string(k - 1) +
            ", b: *l" + std::to_string(k - 1) + "}\n";
  for (int k = 0; k < 60; ++k) place += "/a";
  folder.write("own.yaml", text);
  const std::string map = "controller: position_streaming\nfile: own.yaml\nservo_lookahead_time: 0.1\nmap: {";
  EXPECT_EQ(
      own(load_gains(folder.write("map.yaml", map + place + "/x: servo_gain}\n"), kJoints), "servo_gain")[0],
      1.0);
  EXPECT_THAT(test::refusal(
                  [&] { load_gains(folder.write("map.yaml", map + place + "/y: servo_gain}\n"), kJoints); }),
              HasSubstr("nothing at"));
}

TEST(GainMap, DoesNotWriteADecimalForAnInteger) {
  const test::TemporaryFolder folder;
  folder.write("own.yaml", "gain: 300\n");
  const std::string map = folder.write(
      "map.yaml",
      "controller: position_streaming\nfile: own.yaml\nmap: {gain: servo_gain}\nservo_lookahead_time: 0.1\n");
  const ParameterFile file = read_parameter_file(map).value();
  Gains gains = controller_gains(file.controller, file.path, kJoints);
  EXPECT_EQ(with_gains(file.text, file.controller, file.path, gains, kJoints), file.text);
  own(gains, "servo_gain")[0] = 1200.0;
  EXPECT_THAT(test::refusal([&] { with_gains(file.text, file.controller, file.path, gains, kJoints); }),
              AllOf(HasSubstr("own.yaml:1"), HasSubstr("300.0")));
}

}  // namespace gain_map_test
}  // namespace armtune::internal

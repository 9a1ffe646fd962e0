#include "sim/scenario/random_targets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace random_targets_test {

using test::refused_at;

const Vec3& low() {
  static const Vec3 corner(-0.9, -0.3, 0.2);
  return corner;
}
const Vec3& high() {
  static const Vec3 corner(-0.3, 0.5, 0.2);
  return corner;
}

TEST(RandomTargets, AreAtRestAllOverTheBox) {
  const auto targets = random_targets(1000, low(), high(), 7);
  ASSERT_EQ(targets.size(), 1000U);
  Vec3 least = high();
  Vec3 most = low();
  Vec3 sum = Vec3::Zero();
  for (const NamedPath& target : targets) {
    const MotionPoint<Vec3> point = target.path.at(3.0);
    EXPECT_TRUE(point.velocity.isZero(0.0));
    least = least.cwiseMin(point.position);
    most = most.cwiseMax(point.position);
    sum += point.position;
  }
  EXPECT_TRUE((least.array() >= low().array()).all());
  EXPECT_TRUE((most.array() <= high().array()).all());
  const Vec3 size = high() - low();
  // Of 1000 uniform numbers the extremes lie within 1 % of the ends but for a chance of exp(-10); the mean
  // scatters by 0.29 / sqrt(1000) = 0.9 % of the width.
  EXPECT_TRUE(((least - low()).array() <= 0.01 * size.array()).all());
  EXPECT_TRUE(((high() - most).array() <= 0.01 * size.array()).all());
  EXPECT_TRUE(((sum / 1000.0 - 0.5 * (low() + high())).array().abs() <= 0.04 * size.array() + 1e-12).all());
  EXPECT_EQ(targets[0].name, "random_1");
  EXPECT_EQ(targets[11].name, "random_12");
}

TEST(RandomTargets, ASeedNamesTheSamePointsWhateverTheCount) {
  const auto few = random_targets(3, low(), high(), 7);
  const auto many = random_targets(9, low(), high(), 7);
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].path.center, many[i].path.center);
  EXPECT_NE(random_targets(3, low(), high(), 8)[0].path.center, few[0].path.center);
}

TEST(RandomTargets, AreThoseOfTheGeneratorTheStandardDefines) {
  // ISO C++ 29.6.6: the 10000th number of a mt19937_64 with its default seed 5489 is 9981545732273789042. Of
  // three per target it is the first coordinate of target 3334.
  const auto targets = random_targets(3334, Vec3::Zero(), Vec3::Ones(), 5489);
  EXPECT_NEAR(targets.back().path.center.x(), 9981545732273789042.0 / 0x1.0p64, 1e-15);
}

TEST(RandomTargets, AFileDrawsThemInPlaceOfItsBasesTargets) {
  const test::TemporaryFolder folder;
  const auto load = [&folder](const std::string& random) {
    return load_scenario(
        folder.write("own.yaml", "base: moving_target\ntargets:\n  random: {" + random + "}\n"));
  };
  const auto refused = [&load](const std::string& random) {
    return test::input_error([&] { load(random); });
  };
  const Scenario scenario = load("count: 4, low: [-0.9, -0.3, 0.2], high: [-0.3, 0.5, 0.2], seed: 7");
  const auto expected = random_targets(4, low(), high(), 7);
  ASSERT_EQ(scenario.targets.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(scenario.targets[i].path.center, expected[i].path.center);

  EXPECT_THAT(refused("count: 0, low: [0, 0, 0], high: [1, 1, 1]"),
              refused_at({.line = 3, .key = "targets/random/count", .value = "0", .limit = "1 to 1000"}));
  EXPECT_THAT(refused("count: 1001, low: [0, 0, 0], high: [1, 1, 1]"),
              refused_at({.line = 3, .key = "targets/random/count", .value = "1001", .limit = "1 to 1000"}));
  EXPECT_THAT(
      refused("count: 2, low: [0, 0.1, 0], high: [1, 0, 1]"),
      refused_at({.line = 3, .key = "targets/random/high", .limit = "at least as large as in 'low'"}));
  EXPECT_THAT(refused("count: 2, low: [0, 0, 0], high: [1, 1, 1], seed: -1"),
              refused_at({.line = 3, .key = "targets/random/seed", .value = "-1", .limit = "not negative"}));
  EXPECT_THAT(refused("count: 2, low: [0, 0, 0]"),
              refused_at({.line = 3, .key = "targets/random", .limit = "the key 'high'"}));
  EXPECT_THAT(refused("count: 2, low: [0, 0, 0], high: [1, 1, 1], sed: 1"),
              refused_at({.line = 3,
                          .key = "targets/random/sed",
                          .value = "sed",
                          .limit = "the keys: count, low, high, seed"}));
  EXPECT_EQ(test::suggested_by(refused("count: 2, low: [0, 0, 0], high: [1, 1, 1], sed: 1")), "seed");
}

}  // namespace random_targets_test
}  // namespace armtune::internal

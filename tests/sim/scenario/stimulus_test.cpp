#include "sim/scenario/stimulus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/scenario/scenario.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace stimulus_test {

using test::refused_at;
using testing::HasSubstr;

TEST(Stimulus, AStepIsWholeFromItsTimeOn) {
  Stimulus stimulus;
  stimulus.direction = Vec3(0.0, 0.6, -0.8);
  stimulus.shape = Step{0.1, 0.006};
  EXPECT_EQ(stimulus.start(), 0.006);
  EXPECT_TRUE(stimulus.at(0.004).isZero(0.0));
  const double rounded = std::nextafter(0.006, 0.0);  // as a multiple of the period may come out
  for (const double t : {rounded, 0.006, 0.008, 1e4}) {
    EXPECT_LT((stimulus.at(t) - Vec3(0.0, 0.06, -0.08)).norm(), 1e-15) << t;
  }
}

Stimulus multisine(const std::vector<int>& orders) {
  Stimulus stimulus;
  stimulus.direction = Vec3::UnitY();
  stimulus.shape = Multisine{0.5, 2.0, orders, schroeder_phases(orders), 2.5, 4};
  return stimulus;
}

TEST(Stimulus, SinesStartAtTheirTimeAndRepeatWithTheBasePeriod) {
  const Stimulus stimulus = multisine({1, 3, 4});
  const auto& sines = std::get<Multisine>(stimulus.shape);
  EXPECT_EQ(stimulus.start(), 2.5);
  EXPECT_EQ(sines.window_start(), 4.5);
  EXPECT_EQ(sines.window_end(), 12.5);
  EXPECT_TRUE(stimulus.at(2.499).isZero(0.0));
  for (double t = 2.5; t < 4.5; t += 0.01) {
    double expected = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      expected += 0.5 * std::sin(M_PI * sines.orders[i] * (t - 2.5) + sines.phases[i]);
    }
    EXPECT_NEAR(stimulus.value(t), expected, 1e-12);
    EXPECT_NEAR(stimulus.value(t + 2.0), expected, 1e-12);
    EXPECT_EQ(stimulus.at(t), stimulus.value(t) * Vec3::UnitY());
  }
}

TEST(Stimulus, PhasesOfConsecutiveOrdersAreSchroedersFormula) {
  std::vector<int> orders;
  constexpr int kCount = 16;
  for (int n = 1; n <= kCount; ++n) orders.push_back(n);
  const auto phases = schroeder_phases(orders);
  for (int n = 1; n <= kCount; ++n) {
    const double expected = -M_PI * n * (n - 1) / kCount;
    EXPECT_NEAR(std::remainder(phases[static_cast<std::size_t>(n - 1)] - expected, 2.0 * M_PI), 0.0, 1e-12)
        << n;
  }
}

/// Largest magnitude over the RMS, sqrt(N / 2) amplitudes.
double crest(const Multisine& sines) {
  Stimulus stimulus;
  stimulus.shape = sines;
  double peak = 0.0;
  for (int k = 0; k < 10000; ++k) {
    peak = std::max(peak, std::abs(stimulus.value(sines.from + k * sines.base_period / 10000.0)));
  }
  return peak / (sines.amplitude * std::sqrt(0.5 * static_cast<double>(sines.orders.size())));
}

TEST(Stimulus, ThePhasesKeepThePeakLow) {
  // One sine has 1.41, Schroeder gives his signals of consecutive orders below 2; N in phase sqrt(2 N).
  const Stimulus consecutive = multisine({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16});
  EXPECT_LT(crest(std::get<Multisine>(consecutive.shape)), 2.0);
  // The wide gaps of the bundled orders leave random phases' crest of 3, which in phase were 7.
  const Stimulus bundled = *load_scenario("sines_position").stimulus;
  Multisine sines = std::get<Multisine>(bundled.shape);
  const double low = crest(sines);
  for (double& phase : sines.phases) phase = M_PI / 2.0;
  RecordProperty("crest", std::to_string(low));
  EXPECT_LT(low, 3.3);
  EXPECT_GT(crest(sines), 2.0 * low);
}

class StimulusFile : public testing::Test {
 protected:
  std::string write(const std::string& stimulus) const {
    return folder_.write("own.yaml", "base: moving_target\nduration: 30\nstimulus:\n" + stimulus);
  }
  std::optional<Stimulus> load(const std::string& stimulus) const {
    return load_scenario(write(stimulus)).stimulus;
  }
  InputError refused(const std::string& stimulus) const {
    const std::string path = write(stimulus);
    const InputError error = test::input_error([&path] { load_scenario(path); });
    EXPECT_EQ(error.place().file, path);
    return error;
  }
  InputError refused_sines(const std::string& what) const {
    return refused("  on: path\n  sines: {" + what + "}\n");
  }

  const test::TemporaryFolder folder_;
};

TEST_F(StimulusFile, AScenarioHasNoneUnlessItSaysSo) {
  EXPECT_FALSE(load_scenario("moving_target").stimulus.has_value());
}

TEST_F(StimulusFile, ReadsAStep) {
  const auto stimulus = load("  on: target\n  step: {offset: [0, -0.3, 0.4], at: 12.5}\n");
  ASSERT_TRUE(stimulus.has_value());
  EXPECT_EQ(stimulus->on, Stimulus::On::kTarget);
  EXPECT_LT((stimulus->direction - Vec3(0.0, -0.6, 0.8)).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(std::get<Step>(stimulus->shape).size, 0.5);
  EXPECT_EQ(std::get<Step>(stimulus->shape).at, 12.5);
  EXPECT_LT((stimulus->at(13.0) - Vec3(0.0, -0.3, 0.4)).norm(), 1e-15);
}

TEST_F(StimulusFile, ReadsSines) {
  const auto stimulus = load(
      "  on: path\n  sines: {direction: [3, 0, 4], amplitude: 0.01, base_period: 5, orders: [1, 2, 7], from: "
      "10, "
      "periods: 3}\n");
  ASSERT_TRUE(stimulus.has_value());
  EXPECT_EQ(stimulus->on, Stimulus::On::kPath);
  EXPECT_LT((stimulus->direction - Vec3(0.6, 0.0, 0.8)).norm(), 1e-15)
      << "a direction's length means nothing";
  const auto& sines = std::get<Multisine>(stimulus->shape);
  EXPECT_EQ(sines.amplitude, 0.01);
  EXPECT_EQ(sines.base_period, 5.0);
  EXPECT_THAT(sines.orders, testing::ElementsAre(1, 2, 7));
  EXPECT_EQ(sines.phases, schroeder_phases({1, 2, 7}));
  EXPECT_EQ(sines.from, 10.0);
  EXPECT_EQ(sines.periods, 3) << "the window ends with the scenario";
}

TEST_F(StimulusFile, MistakesAreRefusedWithTheirLine) {
  EXPECT_THAT(refused("  step: {offset: [0, 0, 1], at: 1}\n"),
              refused_at({.line = 3, .key = "stimulus", .limit = "the key 'on'"}));
  EXPECT_THAT(
      refused("  on: tool\n  step: {offset: [0, 0, 1], at: 1}\n"),
      refused_at({.line = 4, .key = "stimulus/on", .value = "tool", .limit = "one of: path, target"}));
  EXPECT_THAT(refused("  on: path\n"),
              refused_at({.line = 3, .key = "stimulus", .limit = "one of: step, sines"}));
  EXPECT_THAT(
      refused("  on: path\n  stepp: {}\n"),
      refused_at(
          {.line = 5, .key = "stimulus/stepp", .value = "stepp", .limit = "the keys: on, step, sines"}));
  EXPECT_THAT(refused("  on: path\n  stepp: {}\n").what(), HasSubstr("did you mean 'step'"));
  EXPECT_THAT(refused("  on: path\n  step: {offset: [0, 0, 0], at: 1}\n"),
              refused_at({.line = 5, .key = "stimulus/step/offset", .limit = "finite and above zero"}));
  EXPECT_THAT(refused("  on: path\n  step: {offset: [0, 0, 1]}\n"),
              refused_at({.line = 5, .key = "stimulus/step", .limit = "the key 'at'"}));
  EXPECT_THAT(refused("  on: path\n  step: {offset: [0, 0, 1], at: -1}\n"),
              refused_at({.line = 5, .key = "stimulus/step/at", .value = "-1", .limit = "0 to 29.998 s"}));
  EXPECT_THAT(refused("  on: path\n  step: {offset: [0, 0, 1], at: 30}\n"),
              refused_at({.line = 5, .key = "stimulus/step/at", .value = "30", .limit = "0 to 29.998 s"}));
  EXPECT_THAT(
      refused("  on: path\n  step: {offset: [0, 0, 1], at: 1, size: 1}\n"),
      refused_at({.line = 5, .key = "stimulus/step/size", .value = "size", .limit = "the keys: offset, at"}));
}

TEST_F(StimulusFile, SinesThatCannotBeMeasuredAreRefused) {
  const auto sines = [this](const std::string& change) {
    std::string text =
        "direction: [0, 0, 1], amplitude: 0.01, base_period: 5, orders: [1, 2], from: 10, periods: 3";
    const std::string key = change.substr(0, change.find(':') + 1);
    const auto begin = text.find(key);
    auto end = text.find(", ", begin);
    while (end != std::string::npos && text[end + 2] >= '0' && text[end + 2] <= '9')
      end = text.find(", ", end + 1);
    text.replace(begin, end == std::string::npos ? end : end - begin, change);
    return refused_sines(text);
  };
  EXPECT_THAT(sines("direction: [0, 0, 0]"),
              refused_at({.line = 5, .key = "stimulus/sines/direction", .limit = "finite and above zero"}));
  EXPECT_THAT(sines("amplitude: 0"),
              refused_at({.line = 5, .key = "stimulus/sines/amplitude", .value = "0", .limit = "above 0"}));
  EXPECT_THAT(
      sines("base_period: 0"),
      refused_at({.line = 5, .key = "stimulus/sines/base_period", .value = "0", .limit = "0.002 to 30 s"}));
  EXPECT_THAT(
      sines("base_period: 31"),
      refused_at({.line = 5, .key = "stimulus/sines/base_period", .value = "31", .limit = "0.002 to 30 s"}));
  EXPECT_THAT(sines("base_period: 4.999"),
              refused_at({.line = 5,
                          .key = "stimulus/sines/base_period",
                          .value = "4.999",
                          .limit = "a whole number of control periods of 0.002 s"}));
  EXPECT_THAT(sines("orders: []"),
              refused_at({.line = 5, .key = "stimulus/sines/orders", .limit = "at least one order"}));
  EXPECT_THAT(sines("orders: [0, 1]"),
              refused_at({.line = 5, .key = "stimulus/sines/orders/0", .value = "0", .limit = "at least 1"}));
  EXPECT_THAT(sines("orders: [1, 3, 3]"),
              refused_at({.line = 5, .key = "stimulus/sines/orders/2", .value = "3", .limit = "at least 4"}));
  EXPECT_THAT(
      sines("orders: [1, 1250]"),
      refused_at({.line = 5, .key = "stimulus/sines/orders/1", .value = "1250", .limit = "below 1250"}));
  std::string many = "orders: [1";
  for (int k = 2; k <= 33; ++k) many += ", " + std::to_string(k);
  EXPECT_THAT(sines(many + "]"),
              refused_at({.line = 5, .key = "stimulus/sines/orders", .limit = "at most 32 orders"}));
  EXPECT_THAT(sines("from: -1"),
              refused_at({.line = 5, .key = "stimulus/sines/from", .value = "-1", .limit = "at least 0"}));
  EXPECT_THAT(
      sines("from: 10.5"),
      refused_at({.line = 5, .key = "stimulus/sines", .value = "30.5", .limit = "an end at 30 s or before"}));
  EXPECT_THAT(sines("periods: 0"),
              refused_at({.line = 5, .key = "stimulus/sines/periods", .value = "0", .limit = "1 to 1000"}));
  EXPECT_THAT(
      sines("periods: 4"),
      refused_at({.line = 5, .key = "stimulus/sines", .value = "35", .limit = "an end at 30 s or before"}));
  EXPECT_THAT(refused_sines("direction: [0, 0, 1]"),
              refused_at({.line = 5, .key = "stimulus/sines", .limit = "the key 'amplitude'"}));
}

}  // namespace stimulus_test
}  // namespace armtune::internal

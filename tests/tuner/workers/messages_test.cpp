#include "tuner/workers/messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "core/control/laws/controller_kind.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tuner/workers/bytes.hpp"

namespace armtune::internal {
namespace messages_test {

/// Every number another one, switches away from their defaults.
NumberedJob some_job() {
  NumberedJob job{7,
                  3,
                  5,
                  {2,
                   std::numeric_limits<std::uint64_t>::max(),
                   {},
                   {{Metric::kGazeMax, -0.0}, {Metric::kJointEffortMaxRatio, 1.0 / 3.0}},
                   Engine::kNative,
                   {Metric::kOrientationMax, Metric::kEffortRateRms}}};
  Gains& gains = job.job.gains;
  double next = 0.1;
  for (const GainField& field : gain_fields()) {
    if (const auto* joints = std::get_if<JointVector Gains::*>(&field.member)) (gains.**joints).setZero(6);
    if (const auto* forces = std::get_if<ForceGains Gains::*>(&field.member)) (gains.**forces).setZero(36);
    if (const auto* flag = std::get_if<bool Gains::*>(&field.member)) gains.** flag = !(gains.**flag);
    for (double& value : numbers(gains, field)) value = next += 1.0 / 3.0;
  }
  gains.slerp_reference = SlerpReference::kCurrent;
  return job;
}

RolloutResult some_result() {
  RolloutResult result;
  result.status = RolloutStatus::kDiverged;
  result.end_time = 0.1 + 0.2;
  result.reason = std::string("a\0b\n\xff", 5);
  result.metrics.max_ratio_joint = "elbow_joint";
  for (std::size_t m = 0; m < kMetricCount; ++m)
    result.metrics.value[m] = std::exp(static_cast<double>(m) / 3.0);
  result.metrics.value[0] = -0.0;
  result.metrics.value[1] = std::bit_cast<double>(std::uint64_t{0xFFF4000000001234U});  // signalling NaN
  result.metrics.value[2] = std::numeric_limits<double>::denorm_min();
  result.metrics.value[3] = -std::numeric_limits<double>::infinity();
  result.series.start = 0.25;
  result.series.period = 0.002;
  result.series.metrics = {{Metric::kGazeMax, 1, {1.0 / 3.0, NAN}},
                           {Metric::kJointEffortMaxRatio, 2, {0.1, 0.2, 0.3, -0.0}}};
  result.series.modes = {kModeSlerping, kModeTarget};
  return result;
}

template <typename Read>
void expect_only_the_whole_is_read(const std::string& message, Read&& read) {
  EXPECT_NO_THROW(read(message));
  for (std::size_t length = 0; length < message.size(); ++length) {
    EXPECT_THROW(read(message.substr(0, length)), std::runtime_error) << length;
  }
  EXPECT_THROW(read(message + '\0'), std::runtime_error);
}

TEST(Bytes, ComeBackTheSameToTheBit) {
  const std::uint64_t patterns[] = {0,
                                    0x8000000000000000U,
                                    0x7FF8000000000000U,
                                    0xFFF8DEADBEEF0001U,
                                    0x7FF0000000000001U,
                                    std::bit_cast<std::uint64_t>(1.0 / 3.0),
                                    std::numeric_limits<std::uint64_t>::max()};
  ByteWriter writer;
  for (const std::uint64_t pattern : patterns) writer.add(std::bit_cast<double>(pattern));
  for (const std::uint64_t pattern : patterns) writer.add(pattern);
  writer.add(std::string_view("text\0more", 9));
  ByteReader reader(writer.bytes());
  for (const std::uint64_t pattern : patterns)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(reader.number()), pattern);
  for (const std::uint64_t pattern : patterns) EXPECT_EQ(reader.integer(), pattern);
  EXPECT_EQ(reader.text(), std::string("text\0more", 9));
  EXPECT_NO_THROW(reader.end());
  EXPECT_THROW(reader.integer(), std::runtime_error);
}

TEST(Messages, AJobComesBackWithEveryGain) {
  const NumberedJob sent = some_job();
  const NumberedJob got = read_job(job_message(sent));
  EXPECT_EQ(got.number, sent.number);
  EXPECT_EQ(got.pool, sent.pool);
  EXPECT_EQ(got.share, sent.share);
  EXPECT_EQ(got.job.scenario, sent.job.scenario);
  EXPECT_EQ(got.job.sample, sent.job.sample);
  for (const GainField& field : gain_fields()) {
    const auto a = numbers(sent.job.gains, field);
    const auto b = numbers(got.job.gains, field);
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end())) << field.name;
    if (const auto* flag = std::get_if<bool Gains::*>(&field.member)) {
      EXPECT_EQ(got.job.gains.**flag, sent.job.gains.**flag) << field.name;
    }
  }
  EXPECT_EQ(got.job.gains.slerp_reference, SlerpReference::kCurrent);
  EXPECT_EQ(got.job.engine, Engine::kNative);
  EXPECT_EQ(got.job.series, sent.job.series);
  ASSERT_EQ(got.job.limits.size(), sent.job.limits.size());
  for (std::size_t i = 0; i < sent.job.limits.size(); ++i) {
    EXPECT_EQ(got.job.limits[i].metric, sent.job.limits[i].metric);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(got.job.limits[i].value),
              std::bit_cast<std::uint64_t>(sent.job.limits[i].value));
  }
  expect_only_the_whole_is_read(job_message(sent), read_job);
}

TEST(Messages, AJobOfEveryControllerComesBackWithItsOwnGains) {
  for (const ControllerKind* kind : controller_kinds()) {
    NumberedJob sent = some_job();
    Gains& gains = sent.job.gains;
    change_controller(gains, kind->name, 6);
    double next = 0.7;
    for (JointVector& own : gains.own) {
      for (double& value : own) value = next += 1.0 / 3.0;
    }
    const Gains got = read_job(job_message(sent)).job.gains;
    EXPECT_EQ(got.controller, kind->name);
    EXPECT_EQ(got.own, gains.own) << kind->name;
    for (const GainField& field : fields_of(gains)) {
      const auto a = numbers(gains, field);
      const auto b = numbers(got, field);
      EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end())) << field.name;
    }
    expect_only_the_whole_is_read(job_message(sent), read_job);
  }
}

TEST(Messages, AResultComesBackBitByBit) {
  const RolloutResult sent = some_result();
  const auto [number, got] = read_result(result_message(11, sent));
  EXPECT_EQ(number, 11U);
  EXPECT_EQ(got.status, sent.status);
  EXPECT_EQ(got.end_time, sent.end_time);
  EXPECT_EQ(got.reason, sent.reason);
  EXPECT_EQ(got.metrics.max_ratio_joint, sent.metrics.max_ratio_joint);
  EXPECT_EQ(test::bits(got.metrics), test::bits(sent.metrics));
  EXPECT_EQ(got.series.start, sent.series.start);
  EXPECT_EQ(got.series.period, sent.series.period);
  EXPECT_EQ(got.series.modes, sent.series.modes);
  ASSERT_EQ(got.series.metrics.size(), sent.series.metrics.size());
  for (std::size_t i = 0; i < sent.series.metrics.size(); ++i) {
    const MetricSeries& a = sent.series.metrics[i];
    const MetricSeries& b = got.series.metrics[i];
    EXPECT_EQ(b.metric, a.metric);
    EXPECT_EQ(b.channels, a.channels);
    ASSERT_EQ(b.values.size(), a.values.size());
    for (std::size_t k = 0; k < a.values.size(); ++k) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(b.values[k]), std::bit_cast<std::uint64_t>(a.values[k]));
    }
  }
  expect_only_the_whole_is_read(result_message(11, sent), read_result);
}

TEST(Messages, TheOthersComeBackAndAreToldApart) {
  const Hello hello{"host", "no such file", {{"what", "value"}, {"", ""}}};
  const Hello got = read_hello(hello_message(hello));
  EXPECT_EQ(got.host, hello.host);
  EXPECT_EQ(got.failure, hello.failure);
  EXPECT_EQ(got.facts, hello.facts);
  expect_only_the_whole_is_read(hello_message(hello), read_hello);
  EXPECT_EQ(read_failure(failure_message(4, "why")), std::make_pair(std::uint64_t{4}, std::string("why")));
  expect_only_the_whole_is_read(failure_message(4, "why"), read_failure);
  expect_only_the_whole_is_read(stop_message(5), read_stop);
  EXPECT_EQ(read_bye(bye_message(130)), 130);
  expect_only_the_whole_is_read(bye_message(3), read_bye);
  EXPECT_EQ(kind_of(plain_message(MessageKind::kLeaving)), MessageKind::kLeaving);
  EXPECT_THROW(read_stop(failure_message(4, "why")), std::runtime_error);
}

}  // namespace messages_test
}  // namespace armtune::internal

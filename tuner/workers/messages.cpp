#include "tuner/workers/messages.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <type_traits>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "tuner/workers/bytes.hpp"

namespace armtune::internal {
namespace {

ByteWriter begun(MessageKind kind) {
  ByteWriter writer;
  writer.add(static_cast<std::uint64_t>(kind));
  return writer;
}

ByteReader opened(const std::string& message, MessageKind kind) {
  ByteReader reader(message);
  const std::uint64_t found = reader.integer();
  if (found != static_cast<std::uint64_t>(kind)) {
    throw FailedError(fmt::format("a message between ranks is of kind {}, not {}", found,
                                  static_cast<std::uint64_t>(kind)));
  }
  return reader;
}

/// Adds every field of a gain set. Numbers are preceded by their count; a switch is one integer.
void add_gains(ByteWriter& writer, const Gains& gains) {
  writer.add(std::string_view(gains.controller));
  for (const GainField& field : fields_of(gains)) {
    if (field.is_number()) {
      const auto values = numbers(gains, field);
      writer.add(std::uint64_t{values.size()});
      for (const double value : values) writer.add(value);
    } else if (const auto* flag = std::get_if<bool Gains::*>(&field.member)) {
      writer.add(std::uint64_t{gains.**flag ? 1U : 0U});
    } else {
      writer.add(static_cast<std::uint64_t>(gains.*std::get<SlerpReference Gains::*>(field.member)));
    }
  }
}

/// Resizes a field to `count` numbers if its size depends on the arm.
void make_room(Gains& gains, const GainField& field, std::uint64_t count) {
  const auto resize = [&](auto& values) {
    if (count > static_cast<std::uint64_t>(std::remove_cvref_t<decltype(values)>::MaxRowsAtCompileTime)) {
      throw FailedError(
          fmt::format("a message between ranks has too many numbers for {}: {}", field.name, count));
    }
    values.resize(static_cast<Eigen::Index>(count));
  };
  if (const auto* joints = std::get_if<JointVector Gains::*>(&field.member)) {
    resize(gains.**joints);
  } else if (const auto* forces = std::get_if<ForceGains Gains::*>(&field.member)) {
    resize(gains.**forces);
  } else if (std::holds_alternative<OwnGain>(field.member)) {
    resize(gains.own.emplace_back());
  }
}

Gains read_gains(ByteReader& reader) {
  Gains gains;
  change_controller(gains, reader.text(), 0);
  gains.own.clear();
  for (const GainField& field : fields_of(gains)) {
    const std::uint64_t first = reader.integer();
    if (!field.is_number()) {
      if (first > 1)
        throw FailedError(
            fmt::format("in a message between ranks, {} is {}; expected 0 or 1", field.name, first));
      if (const auto* flag = std::get_if<bool Gains::*>(&field.member)) {
        gains.** flag = first == 1;
      } else {
        gains.*std::get<SlerpReference Gains::*>(field.member) = static_cast<SlerpReference>(first);
      }
      continue;
    }
    make_room(gains, field, first);
    const auto values = numbers(gains, field);
    if (values.size() != first) {
      throw FailedError(fmt::format("in a message between ranks, {} has {} numbers, not {}", field.name,
                                    first, values.size()));
    }
    for (double& value : values) value = reader.number();
  }
  return gains;
}

Metric read_metric(ByteReader& reader) {
  const std::uint64_t metric = reader.integer();
  if (metric >= kMetricCount)
    throw FailedError(fmt::format("a message between ranks has the unknown metric {}", metric));
  return static_cast<Metric>(metric);
}

void add_series(ByteWriter& writer, const RolloutSeries& series) {
  const auto& [start, period, metrics, modes] = series;
  writer.add(start);
  writer.add(period);
  writer.add(std::uint64_t{metrics.size()});
  for (const auto& [metric, channels, values] : metrics) {
    writer.add(static_cast<std::uint64_t>(metric));
    writer.add(std::uint64_t{channels});
    writer.add(std::uint64_t{values.size()});
    for (const double value : values) writer.add(value);
  }
  writer.add(std::uint64_t{modes.size()});
  for (const PeriodMode mode : modes) writer.add(mode);
}

RolloutSeries read_series(ByteReader& reader) {
  RolloutSeries series;
  series.start = reader.number();
  series.period = reader.number();
  for (std::uint64_t left = reader.integer(); left > 0; --left) {
    MetricSeries& one = series.metrics.emplace_back();
    one.metric = read_metric(reader);
    one.channels = reader.integer();
    const std::uint64_t values = reader.integer();
    if (one.channels == 0 || values % one.channels != 0) {
      throw FailedError(fmt::format("in a message between ranks, a series has {} values in {} channels",
                                    values, one.channels));
    }
    for (std::uint64_t i = 0; i < values; ++i) one.values.push_back(reader.number());
  }
  for (std::uint64_t left = reader.integer(); left > 0; --left) series.modes.push_back(reader.integer());
  return series;
}

}  // namespace

MessageKind kind_of(const std::string& message) {
  return static_cast<MessageKind>(ByteReader(message).integer());
}

std::string plain_message(MessageKind kind) {
  return begun(kind).bytes();
}

std::string hello_message(const Hello& hello) {
  ByteWriter writer = begun(MessageKind::kHello);
  writer.add(std::string_view(hello.host));
  writer.add(std::string_view(hello.failure));
  writer.add(std::uint64_t{hello.facts.size()});
  for (const auto& [what, value] : hello.facts) {
    writer.add(std::string_view(what));
    writer.add(std::string_view(value));
  }
  return writer.bytes();
}

Hello read_hello(const std::string& message) {
  ByteReader reader = opened(message, MessageKind::kHello);
  Hello hello;
  hello.host = reader.text();
  hello.failure = reader.text();
  for (std::uint64_t left = reader.integer(); left > 0; --left) {
    std::string what = reader.text();
    hello.facts.emplace_back(std::move(what), reader.text());
  }
  reader.end();
  return hello;
}

std::string job_message(const NumberedJob& job) {
  ByteWriter writer = begun(MessageKind::kJob);
  writer.add(job.number);
  writer.add(job.pool);
  writer.add(job.share);
  // A new member of RolloutJob must be sent too. Until it is added here, this line does not compile.
  const auto& [scenario, sample, gains, limits, engine, series] = job.job;
  writer.add(std::uint64_t{scenario});
  writer.add(sample);
  add_gains(writer, gains);
  writer.add(std::uint64_t{limits.size()});
  for (const auto& [metric, value] : limits) {
    writer.add(static_cast<std::uint64_t>(metric));
    writer.add(value);
  }
  writer.add(static_cast<std::uint64_t>(engine));
  writer.add(std::uint64_t{series.size()});
  for (const Metric metric : series) writer.add(static_cast<std::uint64_t>(metric));
  return writer.bytes();
}

NumberedJob read_job(const std::string& message) {
  ByteReader reader = opened(message, MessageKind::kJob);
  NumberedJob job;
  job.number = reader.integer();
  job.pool = reader.integer();
  job.share = reader.integer();
  job.job.scenario = reader.integer();
  job.job.sample = reader.integer();
  job.job.gains = read_gains(reader);
  for (std::uint64_t left = reader.integer(); left > 0; --left) {
    const Metric metric = read_metric(reader);
    job.job.limits.push_back({metric, reader.number()});
  }
  const std::uint64_t engine = reader.integer();
  if (engine > static_cast<std::uint64_t>(Engine::kNative)) {
    throw FailedError(fmt::format("a message between ranks has the unknown engine {}", engine));
  }
  job.job.engine = static_cast<Engine>(engine);
  for (std::uint64_t left = reader.integer(); left > 0; --left) job.job.series.push_back(read_metric(reader));
  reader.end();
  return job;
}

std::string stop_message(std::uint64_t number) {
  ByteWriter writer = begun(MessageKind::kStop);
  writer.add(number);
  return writer.bytes();
}

std::uint64_t read_stop(const std::string& message) {
  ByteReader reader = opened(message, MessageKind::kStop);
  const std::uint64_t number = reader.integer();
  reader.end();
  return number;
}

std::string result_message(std::uint64_t number, const RolloutResult& result) {
  ByteWriter writer = begun(MessageKind::kResult);
  writer.add(number);
  const auto& [status, end_time, reason, metrics, series] = result;
  writer.add(static_cast<std::uint64_t>(status));
  writer.add(end_time);
  writer.add(std::string_view(reason));
  writer.add(std::string_view(metrics.max_ratio_joint));
  for (const double value : metrics.value) writer.add(value);
  add_series(writer, series);
  return writer.bytes();
}

std::pair<std::uint64_t, RolloutResult> read_result(const std::string& message) {
  ByteReader reader = opened(message, MessageKind::kResult);
  const std::uint64_t number = reader.integer();
  RolloutResult result;
  const std::uint64_t status = reader.integer();
  result.status = static_cast<RolloutStatus>(status);
  if (!*name(result.status))
    throw FailedError(fmt::format("a message between ranks has the unknown status {}", status));
  result.end_time = reader.number();
  result.reason = reader.text();
  result.metrics.max_ratio_joint = reader.text();
  for (double& value : result.metrics.value) value = reader.number();
  result.series = read_series(reader);
  reader.end();
  return {number, result};
}

std::string failure_message(std::uint64_t number, const std::string& what) {
  ByteWriter writer = begun(MessageKind::kFailure);
  writer.add(number);
  writer.add(std::string_view(what));
  return writer.bytes();
}

std::pair<std::uint64_t, std::string> read_failure(const std::string& message) {
  ByteReader reader = opened(message, MessageKind::kFailure);
  const std::uint64_t number = reader.integer();
  std::string what = reader.text();
  reader.end();
  return {number, std::move(what)};
}

std::string bye_message(int exit_code) {
  ByteWriter writer = begun(MessageKind::kBye);
  writer.add(static_cast<std::uint64_t>(exit_code));
  return writer.bytes();
}

int read_bye(const std::string& message) {
  constexpr std::uint64_t kLargest = 255;
  ByteReader reader = opened(message, MessageKind::kBye);
  const std::uint64_t exit_code = reader.integer();
  if (exit_code > kLargest)
    throw FailedError(
        fmt::format("a message between ranks has the exit code {}; at most 255 is possible", exit_code));
  reader.end();
  return static_cast<int>(exit_code);
}

}  // namespace armtune::internal

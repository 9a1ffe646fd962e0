// Writes and reads MCAP files for scripts/check-mcap, which compares armtune with the format's own library,
// and for scripts/measure-mcap, which compares their speed.
//
//     benchmark_mcap write FILE none|lz4|zstd MESSAGES NUMBERS   messages of so many numbers on two topics
//     benchmark_mcap read FILE                                   prints topics and counts as JSON
//     benchmark_mcap check FILE                                  also prints the CRC-32 of all times and
//     bytes

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/logs/mcap_reader.hpp"
#include "sim/logs/mcap_writer.hpp"

namespace {

using namespace armtune::internal;

constexpr const char* kDefinition = "float64[] data\n";

std::size_t count_of(const char* text) {
  std::size_t count = 0;
  const std::string_view word(text);
  if (const auto [end, error] = std::from_chars(word.begin(), word.end(), count);
      end != word.end() || error != std::errc())
    throw std::runtime_error(fmt::format("'{}' is not a count", word));
  return count;
}

/// Writes messages in CDR (a 4-byte head, the number of elements, alignment, doubles). Each tenth message is
/// JSON instead. The values are sines with noise in their last 20 bits, so that they compress as measured
/// joint states do.
void write(const std::string& path, std::string_view compression, std::size_t messages, std::size_t numbers) {
  const auto known = chunk_compression_of(compression == "none" ? "" : compression);
  if (!known)
    throw std::runtime_error(fmt::format("no compression '{}'; there are none, lz4 and zstd", compression));
  McapWriter bag(path, {.compression = *known});
  const std::size_t states =
      bag.add_topic({"/states", "test_msgs/msg/Numbers", "cdr", kDefinition, "ros2msg"});
  const std::size_t events = bag.add_topic({"/events", "", "json", "", ""});
  std::vector<std::byte> bytes(12 + 8 * numbers);
  bytes[1] = std::byte{1};  // little-endian CDR
  bytes[4] = static_cast<std::byte>(numbers & 0xFFU);
  bytes[5] = static_cast<std::byte>(numbers >> 8);
  std::uint64_t noise = 1;
  for (std::size_t n = 0; n < messages; ++n) {
    const auto time = static_cast<std::int64_t>(1'700'000'000'000'000'000 + n * 2'000'000);
    if (n % 10 == 9) {
      const std::string event = fmt::format("{{\"event\":{}}}", n);
      bag.write(events, time, std::as_bytes(std::span(event)));
      continue;
    }
    for (std::size_t k = 0; k < numbers; ++k) {
      noise = noise * 6'364'136'223'846'793'005U + 1'442'695'040'888'963'407U;  // Knuth, MMIX
      const double value = std::sin(1e-3 * static_cast<double>(n) + static_cast<double>(k));
      const std::uint64_t bits = std::bit_cast<std::uint64_t>(value) ^ (noise >> 44);
      std::memcpy(&bytes[12 + 8 * k], &bits, sizeof(bits));
    }
    bag.write(states, time, bytes);
  }
  bag.finish();
}

struct TopicCount {
  std::size_t messages = 0;
  std::size_t bytes = 0;
  Crc32 crc;
};

void read(const std::string& path, bool with_crc) {
  const auto bag = open_mcap(path);
  std::vector<TopicCount> counts;
  while (const auto message = bag->next()) {
    if (counts.size() <= message->topic) counts.resize(message->topic + 1);
    TopicCount& count = counts[message->topic];
    ++count.messages;
    count.bytes += message->bytes.size();
    if (with_crc) {
      count.crc.add(std::as_bytes(std::span(&message->time, 1)));
      count.crc.add(message->bytes);
    }
  }
  counts.resize(bag->topics().size());
  fmt::print("[");
  for (std::size_t n = 0; n < counts.size(); ++n) {
    const BagTopic& topic = bag->topics()[n];
    const std::string schema = topic.schema.substr(0, topic.schema.find('\n'));
    fmt::print(R"({}{{"name":"{}","type":"{}","encoding":"{}","schema":"{}","schema_encoding":"{}",)",
               n == 0 ? "" : ",", topic.name, topic.type, topic.encoding, schema, topic.schema_encoding);
    fmt::print(R"("messages":{},"bytes":{},"crc":{}}})", counts[n].messages, counts[n].bytes,
               counts[n].crc.value());
  }
  fmt::print("]\n");
  if (bag->unfinished()) throw std::runtime_error("the file is unfinished");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string_view what = argc > 2 ? argv[1] : "";
    if (what == "write" && argc == 6) {
      write(argv[2], argv[3], count_of(argv[4]), count_of(argv[5]));
    } else if ((what == "read" || what == "check") && argc == 3) {
      read(argv[2], what == "check");
    } else {
      throw std::runtime_error(
          "benchmark_mcap write FILE none|lz4|zstd MESSAGES NUMBERS, or read FILE, or check FILE");
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}

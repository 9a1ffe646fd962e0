// Whatever the bytes of an MCAP file: messages whose topics are known, whose times fit and whose bytes can be
// read, in memory that follows the size of the file; or one line that refuses it. A file read twice is the
// same.

#include <cstddef>
#include <cstdint>

#include "sim/logs/crc32.hpp"
#include "sim/logs/mcap_reader.hpp"
#include "tests/fuzz/support/input.hpp"

namespace armtune::internal::fuzz {
namespace {

/// Reads all messages and returns a checksum of them.
std::uint32_t checksum(const std::string& path) {
  const auto bag = open_mcap(path);
  Crc32 crc;
  std::size_t topics = 0;
  while (const auto message = bag->next()) {
    require(message->topic < bag->topics().size() && message->time >= 0);
    require(bag->topics().size() >= topics);
    topics = bag->topics().size();
    crc.add(std::as_bytes(std::span(&message->time, 1)));
    crc.add(message->bytes);
  }
  require(!bag->next().has_value());
  return crc.value();
}

void check(std::string_view bytes) {
  const InputFile file(bytes);
  read_or_refuse([&] { require(checksum(file.path()) == checksum(file.path())); });
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armtune::internal::fuzz::check(armtune::internal::fuzz::text(data, size));
  return 0;
}

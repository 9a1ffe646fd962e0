// Whatever the bytes of an SQLite bag: its messages belong to topics and are together no larger than the
// file, or a line refuses it.

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include "sim/logs/sqlite_bag.hpp"
#include "tests/fuzz/support/input.hpp"

namespace armtune::internal::fuzz {
namespace {

/// SQLite resolves links, so that it cannot open a file that has no place in a folder.
std::string place() {
  const std::filesystem::path memory = "/dev/shm";
  std::error_code ignored;
  const bool is_there = std::filesystem::is_directory(memory, ignored);
  return ((is_there ? memory : std::filesystem::temp_directory_path()) /
          ("armtune_fuzz_" + std::to_string(::getpid()) + ".db3"))
      .string();
}

void check(std::string_view bytes) {
  static const std::string path = place();
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  read_or_refuse([&] {
    const auto bag = open_sqlite_bag(path);
    std::size_t total = 0;
    while (const auto message = bag->next()) {
      require(message->topic < bag->topics().size());
      total += message->bytes.size();
      require(total <= bytes.size());
    }
  });
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armtune::internal::fuzz::check(armtune::internal::fuzz::text(data, size));
  return 0;
}

// Whatever the bytes: a journal whose records are all found again and to which one more can be added, or a
// line that refuses it. Bytes are taken as they are, and once more with a right checksum before every line,
// without which hardly any would get past the first.

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/fuzz/support/input.hpp"
#include "tuner/journal/journal.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal::fuzz {
namespace {

/// A file of this process alone, which a journal can lock and cut; removed at the end.
class Place {
 public:
  Place() : path_(std::filesystem::temp_directory_path() / fmt::format("armtune_fuzz_{}", ::getpid())) {}
  ~Place() { std::filesystem::remove(path_); }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  std::string write(std::string_view bytes) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
    return path_.string();
  }

 private:
  std::filesystem::path path_;
};

std::string with_checksums(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    const std::string_view line = bytes.substr(0, bytes.find('\n'));
    Fnv1a hash;
    hash.add(line);
    text += fmt::format("{:016x} {}", hash.value(), line);
    bytes.remove_prefix(line.size());
    if (bytes.empty()) break;
    text += '\n';
    bytes.remove_prefix(1);
  }
  return text;
}

void check(std::string_view bytes) {
  static const Place place;
  const std::string path = place.write(bytes);
  read_or_refuse([&] {
    const RunHeader header = read_run_header(path);
    std::string warning;
    const auto journal = Journal::resume(path, header, warning);
    const std::size_t before = journal->records();
    JournalRecord record;
    for (record.number = 0; journal->find(record.number); ++record.number) {
    }
    record.phase = "search";
    journal->append(record);
    require(journal->records() == before + 1 && journal->find(record.number)->phase == "search");
  });
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = armtune::internal::fuzz::text(data, size);
  armtune::internal::fuzz::check(bytes);
  armtune::internal::fuzz::check(armtune::internal::fuzz::with_checksums(bytes));
  return 0;
}

#include "tuner/run/hashed_table.hpp"

#include <utility>

#include "core/common/input_file.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20;  // what CsvTable reads of armtune's own files

}  // namespace

HashedTable read_hashed_table(const std::string& path) {
  std::string text = read_file(path, kMostBytes, "a CSV file");
  Fnv1a hash;
  hash.add(text);
  return {CsvTable::parse(std::move(text), path), hash.text()};
}

}  // namespace armtune::internal

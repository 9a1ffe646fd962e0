#include "tuner/run/file_hash.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "core/common/input_file.hpp"

namespace armtune::internal {

std::string Fnv1a::text() const {
  return fmt::format("fnv1a-{:016x}", hash_);
}

std::string hash_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  Fnv1a hash;
  for (std::istreambuf_iterator<char> c(file), end; c != end; ++c) hash.add(static_cast<unsigned char>(*c));
  return hash.text();
}

std::string hash_of_input(const std::string& path) {
  const auto bytes = recorded_input(path);
  if (!bytes) return hash_of_file(path);
  Fnv1a hash;
  hash.add(*bytes);
  return hash.text();
}

}  // namespace armtune::internal

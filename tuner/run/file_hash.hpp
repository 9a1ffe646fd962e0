#pragma once
// FNV-1a, 64 bits (Fowler, Noll, Vo): tells contents apart, guards nothing. One changed byte always changes
// it, for multiplying by an odd number loses nothing.

#include <cstdint>
#include <string>
#include <string_view>

namespace armtune::internal {

class Fnv1a {
 public:
  void add(unsigned char byte) { hash_ = (hash_ ^ byte) * 1099511628211ULL; }
  void add(std::string_view text) {
    for (const char c : text) add(static_cast<unsigned char>(c));
  }
  /// All eight bytes, the lowest first.
  void add(std::uint64_t bits) {
    for (int i = 0; i < 8; ++i, bits >>= 8U) add(static_cast<unsigned char>(bits & 0xFFU));
  }
  std::uint64_t value() const { return hash_; }
  /// "fnv1a-" and 16 hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

/// Of a file's bytes; of none where it cannot be read.
std::string hash_of_file(const std::string& path);

/// Hash of what was read of an input file (see InputRecord); of the file as it is where that was not kept.
std::string hash_of_input(const std::string& path);

}  // namespace armtune::internal

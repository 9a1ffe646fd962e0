#pragma once
// The hash FNV-1a with 64 bits (Fowler, Noll, Vo). It detects that contents differ, but does not protect
// against attacks. If one byte changes, the hash always changes, because the multiplication by an odd number
// modulo 2^64 is invertible.

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
  /// Adds all eight bytes, lowest first.
  void add(std::uint64_t bits) {
    for (int i = 0; i < 8; ++i, bits >>= 8U) add(static_cast<unsigned char>(bits & 0xFFU));
  }
  std::uint64_t value() const { return hash_; }
  /// Returns "fnv1a-" and 16 hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

/// Returns the hash of a file's bytes. If the file cannot be read, returns the hash of an empty file.
std::string hash_of_file(const std::string& path);

/// Returns the hash of the contents that were read from an input file, if they are kept in memory (see
/// InputRecord). Otherwise returns the hash of the file's present contents.
std::string hash_of_input(const std::string& path);

}  // namespace armtune::internal

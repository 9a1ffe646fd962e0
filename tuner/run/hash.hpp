#pragma once
// FNV-1a, 64 bits (Fowler, Noll, Vo): tells files and records apart, guards against nobody. One changed byte
// always changes it, for multiplying by an odd number loses nothing.

#include <cstdint>
#include <string_view>

namespace armtune {

constexpr std::uint64_t fnv1a(std::string_view text, std::uint64_t hash = 14695981039346656037ULL) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

}  // namespace armtune

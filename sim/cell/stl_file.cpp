#include "sim/cell/stl_file.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeader = 84;    // 80 arbitrary bytes, then the number of triangles
constexpr std::size_t kTriangle = 50;  // normal, three corners, two arbitrary bytes
constexpr std::size_t kNormal = 12;

std::uint32_t u32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

}  // namespace

std::optional<std::vector<float>> read_binary_stl(const std::string& path, std::size_t most) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  if (error || size < kHeader || size > kHeader + kTriangle * most) return std::nullopt;
  std::string bytes;
  try {
    bytes = read_input_file(path, kHeader + kTriangle * most, "a mesh");
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (bytes.size() < kHeader) return std::nullopt;
  const std::size_t count = u32(bytes, kHeader - 4);
  if (count == 0 || count > most || bytes.size() != kHeader + kTriangle * count) return std::nullopt;
  std::vector<float> corners;
  corners.reserve(9 * count);
  for (std::size_t t = 0; t < count; ++t) {
    const std::size_t begin = kHeader + kTriangle * t + kNormal;
    for (std::size_t i = 0; i < 9; ++i) {
      corners.push_back(std::bit_cast<float>(u32(bytes, begin + 4 * i)));
      if (!std::isfinite(corners.back())) return std::nullopt;
    }
  }
  return corners;
}

}  // namespace armtune::internal

#include "tuner/report/stl_file.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace armtune::report {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeader = 84;    // 80 bytes of anything, then the number of triangles
constexpr std::size_t kTriangle = 50;  // normal, three corners, two bytes of anything
constexpr std::size_t kNormal = 12;

std::uint32_t u32(const std::vector<char>& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

}  // namespace

std::optional<std::vector<float>> read_binary_stl(const std::string& path, std::size_t most) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  if (error || size < kHeader || size > kHeader + kTriangle * most) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
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

std::optional<std::string> mesh_path(const std::string& named, const std::string& urdf) {
  constexpr std::string_view kPackage = "package://";
  constexpr std::string_view kFile = "file://";
  const fs::path folder = fs::absolute(urdf).parent_path();
  if (named.starts_with(kPackage)) {
    const fs::path within = named.substr(kPackage.size());
    for (fs::path up = folder;; up = up.parent_path()) {
      if (is_file(up / within)) return (up / within).string();
      if (up == up.parent_path()) return std::nullopt;
    }
  }
  const fs::path path = named.starts_with(kFile) ? fs::path(named.substr(kFile.size())) : folder / named;
  return is_file(path) ? std::optional(path.string()) : std::nullopt;
}

}  // namespace armtune::report

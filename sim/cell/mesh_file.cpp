#include "sim/cell/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "sim/cell/obj_file.hpp"
#include "sim/cell/stl_file.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 32U << 20U;
constexpr std::size_t kStlBytes = 50;  // of a triangle in binary STL
/// Endings of formats that URDFs also name, but that armtune does not read.
constexpr std::array<std::string_view, 6> kOtherFormats = {".dae", ".glb", ".gltf", ".fbx", ".ply", ".3ds"};

/// Returns the ending of a file's name in lower case, such as ".stl".
std::string ending_of(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending;
}

}  // namespace

Mesh read_mesh(const std::string& path, std::size_t most) {
  const std::string ending = ending_of(path);
  if (ending == ".dae") {
    return refused_mesh(
        "COLLADA files are not read; convert it to STL or OBJ, for example with MeshLab or Blender, and name "
        "the new file in the URDF");
  }
  if (std::find(kOtherFormats.begin(), kOtherFormats.end(), ending) != kOtherFormats.end())
    return refused_mesh(fmt::format("{} files are not read; convert it to STL or OBJ", ending));
  const std::size_t largest = std::max(kMostBytes, kStlBytes * (most + 2));
  std::error_code error;
  // A file that is too large is refused before it is read.
  const auto size = fs::file_size(path, error);
  if (error) return refused_mesh("it cannot be read");
  if (size > largest) return refused_mesh(fmt::format("it is larger than {} MB", largest >> 20U));
  std::string bytes;
  try {
    bytes = read_input_file(path, largest, "a mesh");
  } catch (const InputError&) {
    return refused_mesh("it cannot be read");
  }
  if (ending == ".obj") return obj_mesh(bytes, most);
  if (auto mesh = binary_stl(bytes, most)) return std::move(*mesh);
  Mesh mesh = text_stl(bytes, most);
  if (!mesh.refusal.empty())
    mesh.refusal = "it is not a valid STL file, neither binary nor text (" + mesh.refusal + ")";
  return mesh;
}

}  // namespace armtune::internal

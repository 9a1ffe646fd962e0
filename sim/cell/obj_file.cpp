#include "sim/cell/obj_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/cell/mesh_lines.hpp"

namespace armtune::internal {
namespace {

/// Returns the index, from 0, of the vertex of a face's corner such as `7`, `7/1/3` or `-1`. Negative numbers
/// count backwards from the last of the `count` vertices so far. Returns nothing if there is no such vertex.
std::optional<std::size_t> vertex_of(std::string_view corner, std::size_t count) {
  const std::string_view number = corner.substr(0, corner.find('/'));
  std::int64_t index = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), index);
  if (error != std::errc{} || end != number.data() + number.size()) return std::nullopt;
  const auto vertices = static_cast<std::int64_t>(count);
  if (index < -vertices || index == 0 || index > vertices) return std::nullopt;
  return static_cast<std::size_t>(index > 0 ? index - 1 : vertices + index);
}

class ObjReader {
 public:
  ObjReader(std::string_view text, std::size_t most) : lines_(text), most_(most) {}

  Mesh read() {
    while (lines_.next()) {
      const std::string_view kind = lines_.words().front();
      std::string why;
      if (kind == "v" && !append_point(lines_.words(), vertices_))
        why = "a vertex needs three finite coordinates";
      if (kind == "f") why = add_face();
      if (!why.empty()) return refused_mesh(lines_.at_line(why));
      // One triangle too many is enough to be refused, so the rest need not be read.
      if (mesh_.corners.size() > 9 * most_) break;
    }
    return checked_mesh(std::move(mesh_), most_);
  }

 private:
  /// Adds the triangles of the current line. Returns the reason if it cannot.
  std::string add_face() {
    const auto& words = lines_.words();
    if (words.size() < 4) return "a face needs at least three corners";
    if (words.size() == MeshLines::kMostWords) return "a face has too many corners";
    face_.clear();
    for (std::size_t i = 1; i < words.size() && !words[i].starts_with('#'); ++i) {
      const auto vertex = vertex_of(words[i], vertices_.size() / 3);
      if (!vertex) return fmt::format("there is no vertex {} above this face", shown_word(words[i]));
      face_.push_back(*vertex);
    }
    if (face_.size() < 3) return "a face needs at least three corners";
    for (std::size_t i = 2; i < face_.size() && mesh_.corners.size() <= 9 * most_; ++i) {
      for (const std::size_t vertex : {face_[0], face_[i - 1], face_[i]})
        mesh_.corners.insert(mesh_.corners.end(), vertices_.begin() + static_cast<std::ptrdiff_t>(3 * vertex),
                             vertices_.begin() + static_cast<std::ptrdiff_t>(3 * vertex + 3));
    }
    return {};
  }

  MeshLines lines_;
  std::size_t most_;
  std::vector<float> vertices_;    ///< three coordinates per vertex
  std::vector<std::size_t> face_;  ///< vertices of the current face
  Mesh mesh_;
};

}  // namespace

Mesh obj_mesh(std::string_view text, std::size_t most) {
  return ObjReader(text, most).read();
}

}  // namespace armtune::internal

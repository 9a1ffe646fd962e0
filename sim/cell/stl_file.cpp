#include "sim/cell/stl_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "sim/cell/mesh_lines.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kHeader = 84;    // 80 arbitrary bytes, then the number of triangles
constexpr std::size_t kTriangle = 50;  // normal, three corners, two arbitrary bytes
constexpr std::size_t kNormal = 12;

std::uint32_t u32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

/// The lines of text STL, by the word that opens them, in the order in which they follow each other.
enum class StlLine : std::size_t {
  kSolid,
  kFacet,
  kLoop,
  kVertex1,
  kVertex2,
  kVertex3,
  kEndLoop,
  kEndFacet,
  kEndSolid
};
constexpr std::array<std::string_view, 9> kStlWords = {"solid",  "facet",   "outer",    "vertex",  "vertex",
                                                       "vertex", "endloop", "endfacet", "endsolid"};

/// Returns the line that `word` opens if `expected` is next. A solid may have any number of facets, and a
/// file any number of solids.
std::optional<StlLine> stl_line(std::string_view word, StlLine expected) {
  if (is_keyword(word, kStlWords[static_cast<std::size_t>(expected)])) return expected;
  if (expected == StlLine::kFacet && is_keyword(word, "endsolid")) return StlLine::kEndSolid;
  return std::nullopt;
}

StlLine line_after(StlLine line) {
  if (line == StlLine::kEndFacet) return StlLine::kFacet;
  if (line == StlLine::kEndSolid) return StlLine::kSolid;
  return static_cast<StlLine>(static_cast<std::size_t>(line) + 1);
}

}  // namespace

std::optional<Mesh> binary_stl(std::string_view bytes, std::size_t most) {
  if (bytes.size() < kHeader) return std::nullopt;
  const std::size_t count = u32(bytes, kHeader - 4);
  if (bytes.size() != kHeader + kTriangle * count) return std::nullopt;
  Mesh mesh;
  if (count > most) return refused_mesh(fmt::format("it has {} triangles, more than {}", count, most));
  mesh.corners.reserve(9 * count);
  for (std::size_t t = 0; t < count; ++t) {
    const std::size_t begin = kHeader + kTriangle * t + kNormal;
    for (std::size_t i = 0; i < 9; ++i) {
      mesh.corners.push_back(std::bit_cast<float>(u32(bytes, begin + 4 * i)));
      if (!std::isfinite(mesh.corners.back()))
        return refused_mesh(fmt::format("a coordinate of triangle {} is not finite", t + 1));
    }
  }
  return checked_mesh(std::move(mesh), most);
}

Mesh text_stl(std::string_view text, std::size_t most) {
  Mesh mesh;
  StlLine expected = StlLine::kSolid;
  MeshLines lines(text);
  while (lines.next() && mesh.corners.size() <= 9 * most) {
    const auto line = stl_line(lines.words().front(), expected);
    if (!line) {
      return refused_mesh(
          lines.at_line(fmt::format("it has {} where '{}' must follow", shown_word(lines.words().front()),
                                    kStlWords[static_cast<std::size_t>(expected)])));
    }
    const bool is_vertex = *line >= StlLine::kVertex1 && *line <= StlLine::kVertex3;
    if (is_vertex && !append_point(lines.words(), mesh.corners))
      return refused_mesh(lines.at_line("a vertex needs three finite coordinates"));
    expected = line_after(*line);
  }
  const bool is_cut_off = expected != StlLine::kSolid && mesh.corners.size() <= 9 * most;
  if (is_cut_off) {
    return refused_mesh(
        fmt::format("it ends where '{}' must follow", kStlWords[static_cast<std::size_t>(expected)]));
  }
  return checked_mesh(std::move(mesh), most);
}

}  // namespace armtune::internal

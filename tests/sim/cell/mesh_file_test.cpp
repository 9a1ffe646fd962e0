#include "sim/cell/mesh_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <random>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace mesh_file_test {

using testing::HasSubstr;
using testing::IsEmpty;

using Corners = std::vector<float>;  // nine coordinates per triangle

Corners random_corners(std::size_t triangles) {
  std::mt19937 generator(4711);
  std::uniform_real_distribution<float> coordinate(-1.0F, 1.0F);
  Corners corners(9 * triangles);
  for (float& x : corners) x = coordinate(generator);
  return corners;
}

/// claimed: the number of triangles in the header.
std::string binary(const Corners& corners, std::uint32_t claimed) {
  std::string text = "solid of a binary file" + std::string(58, ' ');
  const auto put = [&text](const void* from, std::size_t size) {
    text.append(static_cast<const char*>(from), size);
  };
  put(&claimed, 4);
  for (std::size_t i = 0; i < corners.size(); i += 9) {
    text.append(12, '\0');
    put(&corners[i], 36);
    text.append(2, '\0');
  }
  return text;
}

std::string ascii(const Corners& corners, const std::string& end = "\n") {
  std::string text = "solid a part with a name" + end;
  for (std::size_t i = 0; i < corners.size(); i += 9) {
    text += "  facet normal 0 0 nan" + end + "\touter loop" + end;
    for (std::size_t k = i; k < i + 9; k += 3)
      text += fmt::format("vertex {} {} {:.9e}{}", corners[k], corners[k + 1], corners[k + 2], end);
    text += "endloop" + end + "ENDFACET" + end + end;
  }
  return text + "endsolid a part with a name" + end;
}

std::string obj(const Corners& corners) {
  std::string text = "# a comment\nmtllib part.mtl\no part\n";
  for (std::size_t i = 0; i < corners.size(); i += 3)
    text += fmt::format("v {} {} {}\n", corners[i], corners[i + 1], corners[i + 2]);
  text += "vn 0 0 1\nvt 0 0\nusemtl grey\ns off\n";
  for (std::size_t i = 0; i < corners.size() / 9; ++i)
    text += fmt::format("f {}/1/1 {}//1 {}\n", 3 * i + 1, 3 * i + 2, 3 * i + 3);
  return text;
}

/// The line that a refusal names, or 0.
long line_of(const std::string& refusal) {
  std::smatch found;
  return std::regex_search(refusal, found, std::regex("line ([0-9]+): ")) ? std::stol(found[1]) : 0;
}

class MeshFile : public testing::Test {
 protected:
  Mesh read(const std::string& name, const std::string& text, std::size_t most = 100) const {
    const Mesh mesh = read_mesh(folder_.write(name, text), most);
    EXPECT_NE(mesh.corners.empty(), mesh.refusal.empty()) << "either triangles or a reason";
    EXPECT_EQ(mesh.refusal.find('\n'), std::string::npos) << mesh.refusal;
    EXPECT_LT(mesh.refusal.size(), 250U) << mesh.refusal;
    return mesh;
  }
  std::string refused(const std::string& name, const std::string& text, std::size_t most = 100) const {
    return read(name, text, most).refusal;
  }
  test::TemporaryFolder folder_;
};

TEST_F(MeshFile, EveryFormatGivesTheSameTriangles) {
  const Corners corners = random_corners(30);
  EXPECT_EQ(read("a.stl", binary(corners, 30)).corners, corners) << "though its header begins with 'solid'";
  EXPECT_EQ(read("b.STL", ascii(corners)).corners, corners);
  EXPECT_EQ(read("c.stl", ascii(corners, "\r\n")).corners, corners);
  EXPECT_EQ(read("d.obj", obj(corners)).corners, corners);
  EXPECT_EQ(read("e.OBJ", obj(corners)).corners, corners);
  EXPECT_EQ(read("without_ending", binary(corners, 30)).corners, corners);
}

TEST_F(MeshFile, SeveralSolidsOfATextFileAreOneMesh) {
  const Corners corners = random_corners(2);
  Corners twice = corners;
  twice.insert(twice.end(), corners.begin(), corners.end());
  EXPECT_EQ(read("a.stl", ascii(corners) + ascii(corners)).corners, twice);
}

TEST_F(MeshFile, APolygonOfAnObjIsAFanOfTriangles) {
  const std::string square = "v 0 0 0\nv +1 0 0 0.5\nv 1 1 0\nv 0 1 0\n";
  const Corners fan = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0};
  EXPECT_EQ(read("a.obj", square + "f 1 2 3 4 # counter-clockwise\n").corners, fan);
  EXPECT_EQ(read("a.obj", square + "f -4 -3 -2 -1").corners, fan) << "counted from the last vertex";
  EXPECT_EQ(read("a.obj", "v 9 9 9\n" + square + "f -4 -3 3+").corners, Corners()) << "no number";
}

TEST_F(MeshFile, ABinaryStlIsReadWholeOrNotAtAll) {
  const Corners corners = random_corners(2);
  EXPECT_THAT(refused("a.stl", binary(corners, 3)), HasSubstr("not a valid STL file")) << "cut off";
  EXPECT_THAT(refused("a.stl", binary(corners, 1)), HasSubstr("not a valid STL file")) << "longer than said";
  EXPECT_THAT(refused("a.stl", binary(corners, 0xffffffffU)), HasSubstr("not a valid STL file"));
  EXPECT_THAT(refused("a.stl", binary({}, 0)), HasSubstr("no triangles"));
  Corners infinite = corners;
  infinite[13] = INFINITY;
  EXPECT_THAT(refused("a.stl", binary(infinite, 2)), HasSubstr("triangle 2"));
}

TEST_F(MeshFile, ATextStlThatDepartsFromItsFormIsRefusedWithTheLine) {
  const std::string whole = ascii(random_corners(1));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_THAT(refused("a.stl", changed("outer", "inner")), HasSubstr("line 3: it has 'inner'"));
  EXPECT_THAT(refused("a.stl", changed("vertex", "vertex 0 0")), IsEmpty()) << "further words do not count";
  EXPECT_EQ(line_of(refused("a.stl", changed("vertex", "vertex x"))), 4);
  EXPECT_EQ(line_of(refused("a.stl", changed("vertex", "vertex nan"))), 4);
  EXPECT_EQ(line_of(refused("a.stl", changed("vertex", "vertex 1e39"))), 4) << "no float";
  EXPECT_THAT(refused("a.stl", changed("endloop", "vertex 0 0 0")), HasSubstr("line 7: it has 'vertex'"));
  EXPECT_THAT(refused("a.stl", whole.substr(0, whole.find("endsolid"))), HasSubstr("ends where 'facet'"));
  EXPECT_THAT(refused("a.stl", whole.substr(0, whole.find("endloop"))), HasSubstr("ends where 'endloop'"));
  EXPECT_THAT(refused("a.stl", "solid a\nendsolid a\n"), HasSubstr("no triangles"));
  EXPECT_THAT(refused("a.stl", ""), HasSubstr("no triangles"));
  EXPECT_THAT(refused("a.stl", "\x1b[31m\n" + whole), testing::Not(HasSubstr("\x1b")));
}

TEST_F(MeshFile, AnObjWhoseFacesHaveNoVerticesIsRefusedWithTheLine) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* face : {"f 1 2 4", "f 0 1 2", "f 1 2 -4", "f 1 2 a", "f 1 2", "f 1 2 /3",
                           "f 1 2 99999999999999999999", "f 1 2 # 3"})
    EXPECT_EQ(line_of(refused("a.obj", three + face)), 4) << face;
  EXPECT_EQ(line_of(refused("a.obj", "f 1 2 3\n" + three)), 1) << "the vertices come after";
  EXPECT_EQ(line_of(refused("a.obj", "v 0 0\n")), 1);
  EXPECT_EQ(line_of(refused("a.obj", "v 0 0 inf\n")), 1);
  EXPECT_THAT(refused("a.obj", three), HasSubstr("no triangles"));
}

TEST_F(MeshFile, NoFormatHasMoreTrianglesThanAllowed) {
  const Corners corners = random_corners(5);
  for (const auto& [name, text] :
       {std::pair{"a.stl", binary(corners, 5)}, {"b.stl", ascii(corners)}, {"c.obj", obj(corners)}}) {
    EXPECT_EQ(read(name, text, 5).corners, corners) << name;
    EXPECT_THAT(refused(name, text, 4), HasSubstr("more than 4")) << name;
  }
  // A single line can have very many triangles, too.
  std::string fan = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  for (int i = 0; i < 5000; ++i) fan += " 1 2 3";
  EXPECT_THAT(refused("fan.obj", fan, 100), testing::Not(IsEmpty()));
}

TEST_F(MeshFile, OtherFormatsAreRefusedWithAdvice) {
  EXPECT_THAT(refused("a.dae", "<COLLADA/>"), testing::AllOf(HasSubstr("COLLADA"), HasSubstr("STL or OBJ")));
  EXPECT_THAT(refused("a.DAE", ""), HasSubstr("COLLADA"));
  EXPECT_THAT(refused("a.glb", "glTF"), testing::AllOf(HasSubstr(".glb"), HasSubstr("STL or OBJ")));
}

TEST_F(MeshFile, FilesThatCannotBeReadOrAreTooLargeAreRefused) {
  EXPECT_THAT(read_mesh(folder_ / "missing.stl", 10).refusal, HasSubstr("cannot be read"));
  EXPECT_THAT(read_mesh(folder_.path(), 10).refusal, testing::Not(IsEmpty())) << "a folder";
  const std::string large = folder_.write("large.obj", "v 0 0 0\n");
  std::filesystem::resize_file(large, (32U << 20U) + 1);
  EXPECT_THAT(read_mesh(large, 10).refusal, HasSubstr("32 MB"));
}

}  // namespace mesh_file_test
}  // namespace armtune::internal

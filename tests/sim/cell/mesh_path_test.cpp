#include "sim/cell/mesh_path.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace mesh_path_test {

namespace fs = std::filesystem;

/// my_arm/urdf/arm.urdf with my_arm/meshes, and what is not its own beside it.
class MeshPath : public testing::Test {
 protected:
  MeshPath() {
    fs::create_directories(folder_ / "my_arm/urdf");
    fs::create_directories(folder_ / "my_arm/meshes");
    fs::create_directories(folder_ / "other/meshes");
    mesh_ = folder_.write("my_arm/meshes/link.stl", "x");
    secret_ = folder_.write("other/meshes/link.stl", "x");
  }
  ~MeshPath() override { ::unsetenv(kMeshFolders); }

  bool finds(const std::string& named, const std::string& file,
             const std::string& urdf = "my_arm/urdf/arm.urdf") const {
    const auto found = mesh_path(named, folder_ / urdf);
    return found && fs::equivalent(*found, file);
  }
  bool refuses(const std::string& named, const std::string& urdf = "my_arm/urdf/arm.urdf") const {
    return !mesh_path(named, folder_ / urdf);
  }

  test::TemporaryFolder folder_;
  std::string mesh_, secret_;
};

TEST_F(MeshPath, FollowsTheNamesThatUrdfsUse) {
  EXPECT_TRUE(finds("package://my_arm/meshes/link.stl", mesh_));
  EXPECT_TRUE(finds("../meshes/link.stl", mesh_));
  EXPECT_TRUE(finds("file://" + mesh_, mesh_));
  EXPECT_TRUE(finds("meshes/link.stl", mesh_, "my_arm/arm.urdf"));
  EXPECT_TRUE(refuses("link.stl"));
  EXPECT_TRUE(refuses("..")) << "a folder is no mesh";
  EXPECT_TRUE(refuses("package://"));
  EXPECT_TRUE(refuses("package:///meshes/link.stl"));
}

TEST_F(MeshPath, APackageIsCalledWhatItsFileSays) {
  EXPECT_TRUE(refuses("package://arm_description/meshes/link.stl"));
  folder_.write("my_arm/package.xml", "<package>\n  <name>arm_description</name>\n</package>\n");
  EXPECT_TRUE(finds("package://arm_description/meshes/link.stl", mesh_));
  EXPECT_TRUE(finds("package://my_arm/meshes/link.stl", mesh_));
  EXPECT_TRUE(refuses("package://arm_description/../other/meshes/link.stl"));
  EXPECT_TRUE(refuses("package://other_description/meshes/link.stl"));
  ::setenv(kMeshFolders, (folder_ / "nowhere:other_description=" + (folder_ / "other")).c_str(), 1);
  EXPECT_TRUE(finds("package://other_description/meshes/link.stl", secret_));
  EXPECT_TRUE(refuses("package://third/meshes/link.stl"));
}

TEST_F(MeshPath, FindsPackagesWhereRosDoes) {
  for (const char* folder :
       {"elsewhere", "install/share/my_description/meshes", "src/my_description/meshes"}) {
    fs::create_directories(folder_ / folder);
  }
  folder_.write("elsewhere/arm.urdf", "x");
  const std::string named = "package://my_description/meshes/link.stl", urdf = "elsewhere/arm.urdf";
  const std::string installed = folder_.write("install/share/my_description/meshes/link.stl", "x");
  const std::string source = folder_.write("src/my_description/meshes/link.stl", "x");
  ::setenv("AMENT_PREFIX_PATH", (folder_ / "nowhere:" + (folder_ / "install")).c_str(), 1);
  EXPECT_TRUE(refuses(named, urdf)) << "it has no package.xml";
  folder_.write("install/share/my_description/package.xml", "<name>my_description</name>");
  EXPECT_TRUE(finds(named, installed, urdf));
  EXPECT_TRUE(refuses("package://my_description/../../../other/meshes/link.stl", urdf));
  EXPECT_TRUE(refuses("package://../share/my_description/meshes/link.stl", urdf));
  ::unsetenv("AMENT_PREFIX_PATH");
  EXPECT_TRUE(refuses(named, urdf));
  folder_.write("src/my_description/package.xml", "<name>my_description</name>");
  for (const std::string entry : {"src", "src/my_description"}) {
    ::setenv("ROS_PACKAGE_PATH", (folder_ / entry).c_str(), 1);
    EXPECT_TRUE(finds(named, source, urdf)) << entry;
  }
  ::unsetenv("ROS_PACKAGE_PATH");
}

TEST_F(MeshPath, StaysInTheRobotsFolder) {
  for (const std::string named :
       {"../../other/meshes/link.stl", "package://other/meshes/link.stl",
        "package://my_arm/../other/meshes/link.stl", "package://../other/meshes/link.stl",
        "../meshes/../../other/meshes/link.stl"}) {
    EXPECT_TRUE(refuses(named)) << named;
  }
  EXPECT_TRUE(refuses("file://" + secret_));
  EXPECT_TRUE(refuses(secret_)) << "an absolute path";
  EXPECT_TRUE(refuses("../meshes/link.stl", "my_arm/models/arm.urdf")) << "no package.xml, no folder urdf";
}

TEST_F(MeshPath, FollowsLinksBeforeItJudges) {
  fs::create_symlink(secret_, folder_ / "my_arm/meshes/linked.stl");
  EXPECT_TRUE(refuses("../meshes/linked.stl"));
  fs::create_directory_symlink(folder_ / "other", folder_ / "my_arm/meshes/all");
  EXPECT_TRUE(refuses("package://my_arm/meshes/all/meshes/link.stl"));
}

TEST_F(MeshPath, APackageIsTheRobotsFolder) {
  fs::create_directories(folder_ / "my_arm/models/deep");
  folder_.write("my_arm/package.xml", "<package/>");
  EXPECT_TRUE(finds("../../meshes/link.stl", mesh_, "my_arm/models/deep/arm.urdf"));
  EXPECT_TRUE(refuses("../../../other/meshes/link.stl", "my_arm/models/deep/arm.urdf"));
}

TEST_F(MeshPath, LeavesItWhereThatIsAllowed) {
  ::setenv(kMeshFolders, ("/nowhere:" + folder_.path()).c_str(), 1);
  EXPECT_TRUE(finds("package://other/meshes/link.stl", secret_));
  EXPECT_TRUE(finds("../../other/meshes/link.stl", secret_));
  EXPECT_TRUE(finds("file://" + secret_, secret_));
  ::setenv(kMeshFolders, (folder_ / "other/meshes/deeper").c_str(), 1);
  EXPECT_TRUE(refuses("file://" + secret_));
}

}  // namespace mesh_path_test
}  // namespace armtune::internal

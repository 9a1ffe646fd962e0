#pragma once
// Small URDF texts, and a fixture that writes them to files of its own.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "armtune/error.hpp"
#include "core/robot/urdf_reader.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/core/support/source_dir.hpp"

namespace armtune::internal::test {

inline const std::string kUr10 = test::source_dir() + "/sim/robots/ur10.urdf";

inline const std::string kInertial =
    "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";
inline const std::string kLimit = "<limit lower='-1' upper='2' velocity='3' effort='4'/>";

inline std::string link(const std::string& name, const std::string& inside = kInertial) {
  return fmt::format("<link name='{}'>{}</link>\n", name, inside);
}
inline std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                         const std::string& child,
                         const std::string& inside = "<axis xyz='0 0 1'/>" + kLimit) {
  return fmt::format("<joint name='{}' type='{}'><parent link='{}'/><child link='{}'/>{}</joint>\n", name,
                     type, parent, child, inside);
}
inline std::string robot(const std::string& inside) {
  return "<robot name='r'>\n" + inside + "</robot>\n";
}
/// One joint `j` on link `a`, moving link `b`.
inline std::string one_joint(const std::string& link_b = kInertial,
                             const std::string& joint_j = "<axis xyz='0 0 1'/>" + kLimit) {
  return link("a", "") + link("b", link_b) + joint("j", "revolute", "a", "b", joint_j);
}

/// A temporary folder for each test, removed at its end.
class UrdfFiles : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& text) const {
    const std::string path = folder_ + "/arm.urdf";
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  RobotModel read(const std::string& text, const UrdfOptions& options = {}) const {
    return read_urdf(write(text), options);
  }
  /// The error with which the text is refused. Its file is the one written, and its message is one line.
  InputError error_of(const std::string& text, const UrdfOptions& options = {}) const {
    return error_of_file(write(text), options);
  }
  InputError error_of_file(const std::string& path, const UrdfOptions& options = {}) const {
    const InputError found = input_error([&] { return read_urdf(path, options); });
    EXPECT_EQ(found.place().file, path) << found.what();
    return found;
  }
  /// The message of such an error.
  std::string refusal(const std::string& text, const UrdfOptions& options = {}) const {
    return error_of(text, options).what();
  }

  const std::string folder_ = testing::TempDir() + "armtune_urdf_" + std::to_string(getpid());
};

}  // namespace armtune::internal::test

#pragma once
// Files of a test's own, and the message with which input is refused.

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "armtune/error.hpp"
#include "tests/core/support/refused_at.hpp"

namespace armtune::internal::test {

/// A folder that lives as long as the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::filesystem::remove_all(path_);  // of a test of the same process number that was killed
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  /// Writes a file and gives its path.
  std::string write(const std::string& name, const std::string& text) const {
    std::string path = *this / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

 private:
  static std::string unique() {
    static std::atomic<int> count{0};
    return testing::TempDir() + "armtune_" + std::to_string(getpid()) + "_" + std::to_string(count++);
  }
  std::string path_ = unique();
};

inline std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Message of the InputError that `action` ends with; it must be one line.
template <typename Action>
std::string refusal(Action&& action) {
  return input_error(action).what();
}

}  // namespace armtune::internal::test

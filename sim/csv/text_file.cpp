#include "sim/csv/text_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/common/path_state.hpp"
#include "sim/csv/partial_file.hpp"

namespace armtune::internal {

std::string partial_path(const std::string& path) {
  return path + ".armtune.partial";
}

int make_partial_file(const std::string& path, int flags) {
  forget_input(path);
  const std::string partial = partial_path(path);
  ::unlink(partial.c_str());  // left by a killed run; if it cannot be deleted, open() fails
  return ::open(partial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC | flags, 0644);
}

void write_text_file(const std::string& path, std::string_view text) {
  PartialFile file(path);
  file.write(text);
  file.replace();
}

void write_new_text_file(const std::string& path, std::string_view text) {
  refuse_existing(path);
  PartialFile file(path);
  file.write(text);
  file.place_new();
}

void sync_folder_of(const std::string& path) {
  const std::string parent = std::filesystem::path(path).parent_path().string();
  const int folder = ::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path)) {
    throw InputError(InputPlace{path},
                     fmt::format("cannot create this folder: {}",
                                 error ? error.message() : std::string("a file with this name exists")));
  }
}

}  // namespace armtune::internal

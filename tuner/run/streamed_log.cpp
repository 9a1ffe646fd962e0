#include "tuner/run/streamed_log.hpp"

#include <filesystem>

#include "sim/logs/bag_folder.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {

void add_log(const std::string& log, FilesRead& files) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::is_directory(log, ignored)) {
    files.streamed.emplace_back(log, hash_of_file(log));
    return;
  }
  for (const fs::path& file : bag_files(log))
    files.streamed.emplace_back(file.string(), hash_of_file(file.string()));
}

}  // namespace armtune::internal

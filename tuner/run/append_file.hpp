#pragma once
// A file that grows line by line, each on disk before the next thing is done: what is finished is not lost.

#include <string>

namespace armtune {

class AppendFile {
 public:
  /// Makes the file. Throws InputError if it exists or cannot be made.
  explicit AppendFile(const std::string& path);
  ~AppendFile();
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  /// Appends the text and hands it to the disk. Throws std::runtime_error if the disk refuses it.
  void append(const std::string& text);

 private:
  std::string path_;
  int file_ = -1;
};

}  // namespace armtune

#pragma once
// A file that grows line by line, each handed to the system before the next thing is done: what is finished
// is not lost.

#include <string>

namespace armtune::internal {

class AppendFile {
 public:
  enum class Open {
    kNew,      ///< refuses a file that exists; keeps other processes from going on with it
    kReplace,  ///< grows beside an older file of that name until `publish` puts it in its place
    kContinue  ///< continues at the end of a file that exists; refuses if another process writes it
  };

  /// patience: how long to wait for a process that has the file [s]. Throws InputError with path and reason.
  explicit AppendFile(const std::string& path, Open open = Open::kNew, double patience = 0.0);
  ~AppendFile();
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  /// Appends the text: it outlives this process, and with `sync` a power cut. Throws FailedError if
  /// the disk refuses it, or if somebody has deleted the file.
  void append(const std::string& text, bool sync = true);
  /// Cuts the file to this many bytes. Throws FailedError.
  void truncate(long size);
  /// Of kReplace: the file takes the older one's place. Further calls do nothing.
  void publish();
  /// What was appended outlives a power cut. Throws FailedError.
  void sync();

 private:
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  bool published_ = true;
  int file_ = -1;
};

}  // namespace armtune::internal

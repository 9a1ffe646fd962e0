#pragma once
// A file to which lines are appended during a run. Each line is passed to the operating system at once, so
// that finished results are not lost if the run ends early.

#include <string>

namespace armtune::internal {

class AppendFile {
 public:
  enum class Open {
    kNew,      ///< makes and locks a new file; throws if the file exists
    kReplace,  ///< writes a new file beside an older one of this name; `publish` replaces the older one
    kContinue  ///< locks and appends to a file that exists; throws if another process has locked it
  };

  /// Opens the file. patience: longest wait for a process that has locked the file [s]. Throws InputError
  /// with path and reason.
  explicit AppendFile(const std::string& path, Open open = Open::kNew, double patience = 0.0);
  ~AppendFile();
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  /// Appends the text. It is not lost if this process is killed. With `sync` it is not lost after a power cut
  /// either. Throws FailedError if the text cannot be written, or if the file was deleted.
  void append(const std::string& text, bool sync = true);
  /// Cuts the file to this size [bytes]. Throws FailedError if that fails.
  void truncate(long size);
  /// Replaces the older file, for kReplace. Further calls do nothing.
  void publish();
  /// Writes all appended text to the disk, so that it is not lost after a power cut. Throws FailedError if
  /// that fails.
  void sync();

 private:
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  bool published_ = true;
  long texts_ = 0;  ///< whole texts in the file; the first is a header
  int file_ = -1;
};

}  // namespace armtune::internal

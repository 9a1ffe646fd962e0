#pragma once
// A file that grows line by line. Each line is handed to the system before the work continues, so that
// finished results are not lost.

#include <string>

namespace armtune::internal {

class AppendFile {
 public:
  enum class Open {
    kNew,      ///< refuses a file that exists; locks out other processes
    kReplace,  ///< grows beside an older file of that name until `publish` replaces it
    kContinue  ///< appends to a file that exists; refuses if another process writes it
  };

  /// patience: how long to wait for a process that has the file locked [s]. Throws InputError with path and
  /// reason.
  explicit AppendFile(const std::string& path, Open open = Open::kNew, double patience = 0.0);
  ~AppendFile();
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  /// Appends the text. It survives the end of this process, and with `sync` also a power cut. Throws
  /// FailedError if the disk refuses it, or if the file was deleted.
  void append(const std::string& text, bool sync = true);
  /// Cuts the file to this size [bytes]. Throws FailedError if it cannot.
  void truncate(long size);
  /// Replaces the older file, for kReplace. Further calls do nothing.
  void publish();
  /// Makes what was appended survive a power cut. Throws FailedError if it cannot.
  void sync();

 private:
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  bool published_ = true;
  int file_ = -1;
};

}  // namespace armtune::internal

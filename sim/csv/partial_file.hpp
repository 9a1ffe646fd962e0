#pragma once
// Writes a file of any size piece by piece. Other programs see either nothing of it, or the whole file.

#include <string>
#include <string_view>

namespace armtune::internal {

/// A temporary file in the folder of `path`. When it is complete, replace() moves it to `path`:
///
///     PartialFile file(path);
///     file.write(first);
///     file.write(second);
///     file.replace();
///
/// Without the last call, the temporary file is deleted, and a file that was at the path stays as it was.
/// Every function throws InputError with path and reason if it fails. The message names the path as the user
/// did.
class PartialFile {
 public:
  explicit PartialFile(const std::string& path);
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  void write(std::string_view bytes);

  /// Flushes the file to the disk and puts it in its place, where it replaces an older one.
  void replace();

  /// Does the same, but throws InputError if something exists at the path.
  void place_new();

 private:
  [[noreturn]] void fail(const char* what) const;
  void close();

  std::string path_;
  std::string partial_;  ///< empty: it is in its place
  int descriptor_ = -1;
};

}  // namespace armtune::internal

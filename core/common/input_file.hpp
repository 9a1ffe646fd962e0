#pragma once
// Files as texts: the user's own, which a run reads once, and those that armtune writes.

#include <cstddef>
#include <memory>
#include <string>

namespace armtune::internal {

/// The whole file; pipes and devices are read like files. Throws InputError with the path for one that is
/// missing, a directory, cannot be opened or read, or holds more than `max_bytes`: that much is read and no
/// more. `kind` is what messages call it: "a URDF file".
std::string read_file(const std::string& path, std::size_t max_bytes, const std::string& kind);

/// The same for a file that the user named. While an InputRecord lives, the file is read once and every later
/// call gives the same bytes. Throws InputError as well if the path is not printable (see is_printable):
/// run.yaml could not name it.
std::string read_input_file(const std::string& path, std::size_t max_bytes, const std::string& kind);

/// Keeps what read_input_file reads, so that a run uses and tells of one state of its inputs, whatever
/// becomes of the files meanwhile. For a program that makes one run: there is one at a time, for all threads.
class InputRecord {
 public:
  InputRecord();
  ~InputRecord();
  InputRecord(const InputRecord&) = delete;
  InputRecord& operator=(const InputRecord&) = delete;
};

/// The bytes that read_input_file gave for this file. Null without an InputRecord, or if it was not read.
std::shared_ptr<const std::string> recorded_input(const std::string& path);

/// Lets the next read_input_file read the file again: the program itself writes it.
void forget_input(const std::string& path);

}  // namespace armtune::internal

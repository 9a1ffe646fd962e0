#pragma once
// Reads whole files as text. Files that the user names are read only once in a run, so that the whole run
// uses the same content even if the files change meanwhile.

#include <cstddef>
#include <memory>
#include <string>

namespace armtune::internal {

/// Returns the content of the file; pipes and devices are read like files. Throws InputError with the path if
/// the file is missing, is a directory, cannot be opened or read, or is larger than `max_bytes`. Reading
/// stops at that size. Also throws if a signal interrupts the wait for a pipe. `kind` describes the expected
/// content in messages, for example "a URDF file".
std::string read_file(const std::string& path, std::size_t max_bytes, const std::string& kind);

/// Throws the InputError for a file that is larger than `max_bytes`.
[[noreturn]] void refuse_large(const std::string& path, std::size_t max_bytes);

/// Does the same as read_file for a file that the user named. While an InputRecord lives, the file is read
/// once and every later call returns the same bytes. Also throws InputError if the path is not printable (see
/// is_printable), because run.json, the record of a run's inputs, could not name it.
std::string read_input_file(const std::string& path, std::size_t max_bytes, const std::string& kind);

/// Keeps the content of the files that read_input_file reads, for as long as it lives. A run then uses and
/// records the same content of its inputs, even if the files change meanwhile. It is for a program that makes
/// one run: only one InputRecord may exist at a time, and all threads share it.
class InputRecord {
 public:
  InputRecord();
  ~InputRecord();
  InputRecord(const InputRecord&) = delete;
  InputRecord& operator=(const InputRecord&) = delete;
};

/// Returns the bytes that read_input_file returned for this file; null without an InputRecord, or if the file
/// was not read.
std::shared_ptr<const std::string> recorded_input(const std::string& path);

/// Makes the next read_input_file read the file again. It is for files that the program itself writes.
void forget_input(const std::string& path);

}  // namespace armtune::internal

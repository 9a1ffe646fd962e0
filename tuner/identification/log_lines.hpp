#pragma once
// The lines of a text table, read one at a time from a file of any length. Lines may end with LF, CR LF or
// CR.

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "tuner/run/file_hash.hpp"

namespace armtune::internal {

/// Reads a file line by line. Throws InputError with file and line for a file that cannot be opened or read,
/// for one that is not a regular file, and for a line of more than 1 MB.
class LogLines {
 public:
  explicit LogLines(const std::string& path);

  /// Moves to the next line; false at the end of the file.
  bool next();
  /// Makes next() give the present line once more.
  void repeat() { repeat_ = true; }
  /// The present line without its end; valid until next() is called.
  std::string_view text() const { return line_; }
  /// Number of the present line, counted from 1.
  long number() const { return number_; }
  /// Hash of all bytes read so far: of the whole file once next() has returned false.
  std::string hash() const { return hash_.text(); }

 private:
  bool fill();

  std::string path_;
  std::ifstream file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  ///< of the text in the buffer that has not been given out
  std::size_t end_ = 0;
  std::string_view line_;
  long number_ = 0;
  Fnv1a hash_;
  bool after_cr_ = false;  ///< a line feed that follows belongs to the line end before it
  bool repeat_ = false;
};

}  // namespace armtune::internal

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
  /// Returns the present line without its end; valid until next() is called.
  std::string_view text() const { return line_; }
  /// Returns the number of the present line, counted from 1.
  long number() const { return number_; }
  /// Returns the hash of all bytes read so far. After next() has returned false it is that of the whole file.
  std::string hash() const { return hash_.text(); }

 private:
  bool fill();

  std::string path_;
  std::ifstream file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  ///< begin and end of the text in the buffer that next() has not returned yet
  std::size_t end_ = 0;
  std::string_view line_;
  long number_ = 0;
  Fnv1a hash_;
  bool after_cr_ = false;  ///< true: a line feed that follows belongs to the line end before it
  bool repeat_ = false;
};

}  // namespace armtune::internal

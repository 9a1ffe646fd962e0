#pragma once
// Reads the lines of a text table, one at a time, from a file of any length. Lines may end with LF, CR LF or
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

  /// Moves to the next line. Returns false at the end of the file.
  bool next();
  /// Makes the following call of next() stay on the current line.
  void repeat() { repeat_ = true; }
  /// Returns the current line without its line end; valid until next() is called.
  std::string_view text() const { return line_; }
  /// Returns the number of the current line, counted from 1.
  long number() const { return number_; }
  /// Returns the hash of all bytes read so far. After next() has returned false, this is the hash of the
  /// whole file.
  std::string hash() const { return hash_.text(); }

 private:
  bool fill();

  std::string path_;
  std::ifstream file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  ///< begin and end, in the buffer, of the text after the current line
  std::size_t end_ = 0;
  std::string_view line_;
  long number_ = 0;
  Fnv1a hash_;
  bool after_cr_ = false;  ///< true after a CR: an LF that follows belongs to the same line end
  bool repeat_ = false;
};

}  // namespace armtune::internal

#pragma once
// Reads the lines of a text table, one at a time, from a file of any length. Lines may end with LF, CR LF or
// CR.

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace armtune::internal {

/// Reads a file line by line in bounded memory. Throws InputError with file and line for a file that cannot
/// be opened or read, for one that is not a regular file, and for a line of more than 1 MB.
class TextLines {
 public:
  explicit TextLines(const std::string& path);

  /// Moves to the next line. Returns false at the end of the file.
  bool next();
  /// Returns the current line without its line end; valid until next() is called.
  std::string_view text() const { return line_; }
  /// Returns the number of the current line, counted from 1.
  long number() const { return number_; }

 private:
  bool fill();

  std::string path_;
  std::ifstream file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  ///< begin and end, in the buffer, of the text after the current line
  std::size_t end_ = 0;
  std::string_view line_;
  long number_ = 0;
  bool after_cr_ = false;  ///< true after a CR: an LF that follows belongs to the same line end
};

}  // namespace armtune::internal

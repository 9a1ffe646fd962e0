#pragma once
// Writes and reads the lines of a journal. Each line is a checksum (16 hexadecimal digits) of a text, then a
// blank, then the text.

#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace armtune::internal {

/// Returns the line for a text, with its checksum and a line end.
std::string checked_line(std::string_view payload);

/// Returns the text of a line without its checksum; nothing if the checksum is wrong.
std::optional<std::string_view> payload_of(std::string_view line);

/// Reads a journal line by line.
class JournalLines {
 public:
  /// Opens the journal. Throws InputError if it cannot be opened.
  explicit JournalLines(const std::string& path);

  /// Reads the next line. Returns false at the end of the file. Throws InputError if the file cannot be read,
  /// or if a line has more than 64 MB.
  bool next();

  /// Returns the text of the line; nothing if its end is missing or its checksum is wrong.
  std::optional<std::string_view> payload() const;
  /// Returns the offset of the line in the file [bytes].
  long place() const { return place_; }
  /// Returns the number of the line, from 1.
  long number() const { return number_; }

 private:
  void read_line();

  std::string path_;
  std::ifstream file_;
  std::string line_;
  bool whole_ = false;  ///< true if the line has its line end
  long place_ = 0;
  long number_ = 0;
};

}  // namespace armtune::internal

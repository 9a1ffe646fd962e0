#pragma once
// Divides the text of a mesh file into lines and words, and reads numbers from words.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armtune::internal {

class MeshLines {
 public:
  /// text: it must outlive this object.
  explicit MeshLines(std::string_view text) : rest_(text) {}

  /// Moves to the next line that has a word. Returns false at the end of the text.
  bool next();

  /// Returns the words of the current line. There is at least one word, and there are at most kMostWords:
  /// further words of the line are left out.
  const std::vector<std::string_view>& words() const { return words_; }
  /// Returns the number of the current line, from 1.
  long line() const { return line_; }
  /// Returns a clause for a refusal, such as "line 12: 'vertx' is not a word of STL".
  std::string at_line(const std::string& what) const;

  static constexpr std::size_t kMostWords = 10000;

 private:
  std::string_view rest_;
  std::vector<std::string_view> words_;
  long line_ = 0;
};

/// Returns the number, rounded to a float, if the whole word is a finite number; otherwise nothing.
std::optional<float> coordinate(std::string_view word);

/// Appends three coordinates, which follow the first word of a line. Returns false if one of them is missing
/// or is not a finite number.
bool append_point(const std::vector<std::string_view>& words, std::vector<float>& coordinates);

/// Returns a word in quotes for a message, with at most 40 characters. Characters that are not printable
/// ASCII are replaced by '?', because the file may come from a stranger.
std::string shown_word(std::string_view word);

}  // namespace armtune::internal

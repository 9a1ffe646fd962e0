#pragma once
// One strict way to read YAML: every input file of armtune goes through here, and every mistake in one is a
// single line that says where it is, what is wrong and what is expected.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace armtune::internal::yaml {

inline constexpr std::size_t kMaxBytes = 4 * 1024 * 1024;  ///< largest text [byte]
inline constexpr std::size_t kMaxItems =
    200'000;  ///< most values in a text of kMaxBytes, containers included; in a larger one as many times more
inline constexpr std::size_t kMaxKeys = 100'000;    ///< most keys of one map
inline constexpr std::size_t kMaxDepth = 64;        ///< most containers inside one another
inline constexpr std::size_t kMaxKeyBytes = 4096;   ///< longest key [byte]; run.yaml has paths as keys
inline constexpr std::size_t kMaxPathBytes = 8192;  ///< longest key path [byte]
inline constexpr std::size_t kMaxAllPathBytes =
    32 * 1024 * 1024;  ///< of all values, each of which holds its path

/// One value of a document: empty, a scalar, a list or a map, with the place it came from. Immutable.
///
/// Every typed read throws InputError "FILE:LINE: key 'a/b': <what is wrong>; <what is expected>" when the
/// value is of another type. Types are exact: a quoted scalar (or block text) is a string and nothing else, a
/// plain number, true or false is no string, and an empty value (nothing, ~, null) is none of them.
class Node {
 public:
  enum class Kind { kNull, kScalar, kSequence, kMap };

  Kind kind() const { return kind_; }
  /// Counted from 1. The value of a map entry has the line of its key.
  int line() const { return line_; }
  /// Name of the file, as given to parse_file or parse_text.
  const std::string& file() const { return *file_; }
  /// Keys from the top, list indices counted from 0: "targets/1/center". Empty at the top.
  const std::string& key_path() const { return key_path_; }

  std::string as_string() const;
  /// Finite, decimal, with '.' whatever the locale. An integer with a leading zero (010) is refused: other
  /// readers take it for octal.
  double as_number() const;
  /// Decimal digits with an optional sign; neither 010 nor 3.0.
  long as_integer() const;
  /// true or false, in lower case; not yes, no, on, off.
  bool as_boolean() const;
  std::vector<double> as_numbers() const;
  /// A list of exactly `count` numbers.
  std::vector<double> as_numbers(std::size_t count) const;
  std::vector<std::string> as_strings() const;

  /// Elements of a list; InputError for anything else.
  const std::vector<Node>& items() const;
  /// Entries of a map in the order of the file; InputError for anything else.
  const std::vector<std::pair<std::string, Node>>& entries() const;
  /// The value at `key`, or nullptr when there is none. InputError when this is not a map.
  const Node* find(std::string_view key) const;

  /// Whether this is the scalar `text`; for keys that take a word or a number.
  bool is_word(std::string_view text) const { return kind_ == Kind::kScalar && text_ == text; }

  /// Throws InputError "FILE:LINE: key 'a/b': what", on one line whatever `what` contains.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  friend class TreeBuilder;
  friend Node overlay(const std::vector<Node>& layers);
  Node() = default;

  /// What this is, with its value, to begin a message with.
  std::string description() const;
  /// Text of a scalar without quotes, else fails with "expected ...".
  const std::string& plain_text(const std::string& expected) const;

  Kind kind_ = Kind::kNull;
  bool is_text_ = false;  ///< quoted, block text or tagged !!str
  int line_ = 1;
  std::shared_ptr<const std::string> file_;
  std::string key_path_;
  std::string text_;
  std::vector<Node> items_;
  std::vector<std::pair<std::string, Node>> entries_;
};

/// Reads one document from a file. Throws InputError, with the file and where known the line, for: a missing
/// file, a directory, an unreadable or empty file, a file over one of the limits above, syntax errors,
/// control characters, UTF-16, a quote that is never closed, duplicate keys, keys that are not scalars,
/// anchors and aliases, tags other than YAML's core ones, and a second document. A block-style file that was
/// cut off between two entries is still valid YAML and cannot be told from a complete one.
Node parse_file(const std::string& path);

/// The same for a file that armtune itself wrote, of at most so many bytes: read anew every time.
Node parse_file(const std::string& path, std::size_t max_bytes);

/// The same for a text in memory; `file_name` is only used in messages.
Node parse_text(const std::string& text, const std::string& file_name, std::size_t max_bytes = kMaxBytes);

/// One map with the top-level keys of all `layers` (at least one, each a map); where several have a key, the
/// last one's value stands whole. Values keep the file and line they came from. Throws InputError if a layer
/// is not a map.
Node overlay(const std::vector<Node>& layers);

}  // namespace armtune::internal::yaml

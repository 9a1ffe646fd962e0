#pragma once
// A strict reader for armtune's own YAML files. An error is reported in one line with its place in the file,
// what is wrong and what is expected. Files that were not written for armtune, such as ROS parameter files,
// are read by placed_value.hpp.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "armtune/error.hpp"

namespace armtune::internal::yaml {

inline constexpr std::size_t kMaxBytes = 4 * 1024 * 1024;  ///< largest text [byte]
/// Largest number of values, lists and maps included. It applies to texts of up to kMaxBytes. If a caller
/// allows larger texts, the limit grows in proportion.
inline constexpr std::size_t kMaxItems = 200'000;
inline constexpr std::size_t kMaxKeys = 100'000;    ///< most keys of one map
inline constexpr std::size_t kMaxDepth = 64;        ///< deepest nesting of lists and maps
inline constexpr std::size_t kMaxKeyBytes = 4096;   ///< longest key [byte]
inline constexpr std::size_t kMaxPathBytes = 8192;  ///< longest key path [byte]
/// Largest total length of all key paths [byte]. Every value stores its own path. The limit grows as
/// kMaxItems does.
inline constexpr std::size_t kMaxAllPathBytes = 32 * 1024 * 1024;

/// A value of a document: empty, a scalar, a list or a map, with its place in the file. It is immutable.
///
/// Every typed read throws InputError "FILE:LINE: key 'a/b': <what is wrong>; <what is expected>" if the
/// value is of another type. Types are exact. A quoted scalar (or block text) is a string only. A plain
/// number, true or false is not a string. An empty value (nothing, ~, null) has none of these types.
class Node {
 public:
  enum class Kind { kNull, kScalar, kSequence, kMap };

  Kind kind() const { return kind_; }
  /// Returns the line of the value, counted from 1. The value of a map entry has the line of its key.
  int line() const { return line_; }
  /// Returns the name of the file, as given to parse_file or parse_text.
  const std::string& file() const { return *file_; }
  /// Returns the keys from the top down to this value, with list indices from 0: "targets/1/center". The path
  /// of the top value is empty.
  const std::string& key_path() const { return key_path_; }

  std::string as_string() const;
  /// Returns a finite decimal number. The decimal point is '.' in every locale. An integer with a leading
  /// zero (010) is refused because other readers take it for octal.
  double as_number() const;
  /// Returns an integer, written as decimal digits with an optional sign. Neither 010 nor 3.0 is accepted.
  long as_integer() const;
  /// Returns the value of the word true or false, in lower case. Yes, no, on and off are not accepted.
  bool as_boolean() const;
  std::vector<double> as_numbers() const;
  /// Returns a list of exactly `count` numbers.
  std::vector<double> as_numbers(std::size_t count) const;
  std::vector<std::string> as_strings() const;

  /// Returns the elements of a list. Throws InputError for anything else.
  const std::vector<Node>& items() const;
  /// Returns the entries of a map in the order of the file. Throws InputError for anything else.
  const std::vector<std::pair<std::string, Node>>& entries() const;
  /// Returns the value at `key`, or nullptr if the key is absent. Throws InputError if this is not a map.
  const Node* find(std::string_view key) const;

  /// True if this is the scalar `text`. Meant for keys that take a word or a number.
  bool is_word(std::string_view text) const { return kind_ == Kind::kScalar && text_ == text; }

  /// Throws InputError "FILE:LINE: key 'a/b': what". The message has one line even if `what` has several. If
  /// this is a scalar, the value of the error is its text. limit: see InputError::limit().
  [[noreturn]] void fail(const std::string& what, const std::string& limit = {}) const;
  /// Throws InputError "FILE:LINE: key 'a/b': PROBLEM; expected LIMIT". If the fault has no value and this is
  /// a scalar, the value of the error is its text.
  [[noreturn]] void fail(InputFault fault) const;
  /// Throws InputError "FILE:LINE: key 'a/b': 'TEXT' is not one of: A, B" for a scalar.
  [[noreturn]] void fail_choice(const std::vector<std::string>& known) const;

 private:
  friend class TreeBuilder;
  friend Node overlay(const std::vector<Node>& layers);
  Node() = default;

  /// Returns the type and the value as the beginning of a message.
  std::string description() const;
  /// Returns the text of a scalar without quotes. Throws InputError "expected ..." for any other value.
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

/// Reads one document from a file. Throws InputError, with the file and where known the line, for:
///   - a file that is missing, a directory, unreadable, empty or beyond one of the limits above,
///   - control characters, UTF-16, and other text that is not UTF-8,
///   - syntax errors, a quote that is never closed, and a second document,
///   - duplicate keys, and keys that are not scalars,
///   - anchors, aliases, and tags other than YAML's core ones.
/// A block-style file that was cut off between two entries is still valid YAML. It cannot be distinguished
/// from a complete file.
Node parse_file(const std::string& path);

/// Reads a file of at most `max_bytes` that armtune itself wrote. Every call reads it from the disk again.
/// The function above, in contrast, may return what an InputRecord kept (input_file.hpp).
Node parse_file(const std::string& path, std::size_t max_bytes);

/// Reads one document from a text in memory. `file_name` is only used in messages.
Node parse_text(const std::string& text, const std::string& file_name, std::size_t max_bytes = kMaxBytes);

/// Returns one map with the top-level keys of all `layers` (at least one, each a map). If several layers have
/// a key, the value of the last one replaces the others as a whole. Values keep the file and line they came
/// from. Throws InputError if a layer is not a map.
Node overlay(const std::vector<Node>& layers);

}  // namespace armtune::internal::yaml

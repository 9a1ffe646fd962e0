#pragma once
// Reads a YAML map key by key. A key that no code has read is reported as unknown. A misspelt key in a user's
// file is therefore an error and is never ignored silently.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "sim/yaml/document.hpp"

namespace armtune::internal::yaml {

/// A reader of one map. Request every key, then call finish(). A key counts as known once any member function
/// was called with it.
///
/// The typed reads throw the InputErrors of Node. A default is used only if the key is absent. An empty value
/// or a value of another type is an error.
class MapReader {
 public:
  /// Throws InputError if `map` is not a map. `map` must outlive the reader.
  explicit MapReader(const Node& map);
  explicit MapReader(const Node&& temporary) = delete;

  /// Returns the value, or nullptr if the key is absent.
  const Node* optional(std::string_view key);
  /// Returns the value. Throws InputError naming key and map if the key is absent.
  const Node& required(std::string_view key);
  /// Throws the InputError for a map that must have one of `keys`, but has none of them.
  [[noreturn]] void none_of(std::initializer_list<std::string_view> keys) const;
  bool has(std::string_view key);
  /// Accepts the key with any value, and also its absence. It is for keys that other code reads.
  void ignore(std::string_view key);

  double number(std::string_view key);
  double number(std::string_view key, double default_value);
  /// Returns the number. Throws InputError with value and limits if a given value is outside [lower, upper].
  /// A limit may be infinite.
  double number_in(std::string_view key, double default_value, double lower, double upper);
  long integer(std::string_view key, long default_value);
  bool boolean(std::string_view key, bool default_value);
  std::string string(std::string_view key, const std::string& default_value);

  /// Throws InputError for the first key of the file that is not known. The message names the nearest known
  /// key and lists all known keys.
  void finish() const;

 private:
  bool is_known(std::string_view key) const;
  std::vector<std::string> unread() const;

  const Node& map_;
  std::vector<std::string> known_;  // in the order of the requests
};

}  // namespace armtune::internal::yaml

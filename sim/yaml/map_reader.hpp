#pragma once
// Reads a YAML map key by key and remembers what was asked for, so that a key nobody asked for is an error.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "sim/yaml/document.hpp"

namespace armtune::internal::yaml {

/// Known keys are all keys ever asked for, by any member. Ask for every key, then call finish().
///
/// The typed reads throw the InputErrors of Node; a default stands for a key that is absent, never for one
/// that is there and empty or of another type.
class MapReader {
 public:
  /// InputError when `map` is not a map. `map` must outlive the reader.
  explicit MapReader(const Node& map);
  explicit MapReader(const Node&& temporary) = delete;

  /// The value, or nullptr when the key is absent.
  const Node* optional(std::string_view key);
  /// The value; InputError naming key and map when it is absent.
  const Node& required(std::string_view key);
  /// Throws the InputError of a map that has none of `keys`, one of which must be there.
  [[noreturn]] void none_of(std::initializer_list<std::string_view> keys) const;
  bool has(std::string_view key);
  /// Accepts the key, absent or with whatever value: someone else reads it.
  void ignore(std::string_view key);

  double number(std::string_view key);
  double number(std::string_view key, double default_value);
  /// InputError with value and limits when a value is there and outside [lower, upper]; a limit may be
  /// infinite.
  double number_in(std::string_view key, double default_value, double lower, double upper);
  long integer(std::string_view key, long default_value);
  bool boolean(std::string_view key, bool default_value);
  std::string string(std::string_view key, const std::string& default_value);

  /// InputError for the first key of the file that is not known, with the nearest known one and the list of
  /// all.
  void finish() const;

 private:
  bool is_known(std::string_view key) const;
  std::vector<std::string> unread() const;

  const Node& map_;
  std::vector<std::string> known_;  // in the order asked for
};

}  // namespace armtune::internal::yaml

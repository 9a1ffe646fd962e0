#pragma once
// Reads a YAML file that was not written for armtune, such as a ROS parameter file, with the position of each
// number in its text. A number can then be changed while the rest of the file stays as it is. Anchors,
// aliases and merge keys are resolved.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace armtune::internal::yaml {

struct PlacedValue;
/// A shared value: all aliases of an anchor refer to the same one.
using Placed = std::shared_ptr<const PlacedValue>;

/// A value in a list or a map.
struct PlacedEntry {
  std::string key;  ///< in a map
  Placed value;
  bool alias = false;  ///< true if the value is written elsewhere, and an alias or a merge key refers to it
};

struct PlacedValue {
  enum class Kind { kNull, kScalar, kSequence, kMap };

  Kind kind = Kind::kNull;
  int line = 1;                      ///< counted from 1
  bool anchored = false;             ///< true if it has an anchor, so that aliases can refer to it
  std::string text;                  ///< of a scalar
  std::size_t begin = 0;             ///< offset of a plain scalar in the file [byte]
  std::size_t end = 0;               ///< offset of the first byte after it; end <= begin: not a plain scalar
  std::vector<PlacedEntry> items;    ///< of a list
  std::vector<PlacedEntry> entries;  ///< of a map, in the order of the file

  /// True for a scalar whose text in the file is exactly `text`: neither quoted nor tagged, folded or empty.
  bool has_place() const { return end > begin; }
  /// Returns the value at `key` of a map, or null if the key is absent or this is not a map.
  const PlacedValue* find(std::string_view key) const;
};

/// Reads one document. Throws InputError "FILE:LINE: what" for: text that is too large, has too many values
/// or is nested too deeply (document.hpp), invalid YAML, control characters, text that is not UTF-8, a quote
/// that is never closed, duplicate keys, keys that are lists or maps, an alias inside its own value, an empty
/// document, and a second document.
Placed read_placed(const std::string& text, const std::string& file);

}  // namespace armtune::internal::yaml

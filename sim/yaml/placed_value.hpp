#pragma once
// A YAML file of other people's, with the place of each of its numbers in the text: so that a number can be
// changed and all else stays. Anchors, aliases and merge keys are understood; what is not YAML is refused.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace armtune::internal::yaml {

struct PlacedValue;
/// What an anchor names is shared by all of its aliases.
using Placed = std::shared_ptr<const PlacedValue>;

/// A value in a list or a map.
struct PlacedEntry {
  std::string key;  ///< in a map
  Placed value;
  bool alias = false;  ///< it stands elsewhere, and here by an alias or a merge key
};

struct PlacedValue {
  enum class Kind { kNull, kScalar, kSequence, kMap };

  Kind kind = Kind::kNull;
  int line = 1;                      ///< counted from 1
  std::string text;                  ///< of a scalar
  std::size_t begin = 0;             ///< of a plain scalar in the file [byte]
  std::size_t end = 0;               ///< behind it; no larger than begin: it has no place, as it is quoted
  std::vector<PlacedEntry> items;    ///< of a list
  std::vector<PlacedEntry> entries;  ///< of a map, in the order of the file

  bool has_place() const { return end > begin; }
  /// The value at `key` of a map; null: there is none, or this is no map.
  const PlacedValue* find(std::string_view key) const;
};

/// Reads one document. Throws InputError "FILE:LINE: what" for what document.hpp refuses, but for anchors,
/// aliases, merge keys and tags.
Placed read_placed(const std::string& text, const std::string& file);

}  // namespace armtune::internal::yaml

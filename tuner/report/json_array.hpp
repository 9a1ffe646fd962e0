#pragma once
// Lists of anything, and what may not be there, as JSON.

#include "tuner/report/json.hpp"

namespace armtune::report {

/// key: [each of items, as `write` writes it].
template <typename Items, typename Write>
void array(Json& json, const char* key, const Items& items, Write write) {
  json.key(key);
  json.begin_array();
  for (const auto& item : items) write(json, item);
  json.end_array();
}

/// The same; without items nothing.
template <typename Items, typename Write>
void array_if_any(Json& json, const char* key, const Items& items, Write write) {
  if (!items.empty()) array(json, key, items, write);
}

/// key: an optional value, as `write` writes it; nothing where there is none.
template <typename Optional, typename Write>
void value_if_any(Json& json, const char* key, const Optional& value, Write write) {
  if (!value) return;
  json.key(key);
  write(json, *value);
}

}  // namespace armtune::report

#pragma once
// Lists of anything as JSON.

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

}  // namespace armtune::report

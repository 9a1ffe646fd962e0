#pragma once
// Makes an InputPlace, which is the place in a file that an InputError names.

#include <concepts>
#include <string>
#include <utility>

#include "armtune/error.hpp"

namespace armtune::internal {

/// Returns a place in the file. line: counted from 1. key: a YAML key, or the name of a CSV column.
inline InputPlace at_line(std::string file, std::integral auto line, std::string key = {}) {
  return {std::move(file), static_cast<long>(line), std::move(key)};
}

}  // namespace armtune::internal

#pragma once
// A place in a file, for errors.

#include <concepts>
#include <string>
#include <utility>

#include "armtune/error.hpp"

namespace armtune::internal {

/// Returns a place in the file; line: counted from 1. key: of YAML, or the column of a CSV file.
inline InputPlace at_line(std::string file, std::integral auto line, std::string key = {}) {
  return {std::move(file), static_cast<long>(line), std::move(key)};
}

}  // namespace armtune::internal

#include "sim/csv/cell.hpp"

#include <fmt/format.h>

#include <cmath>

namespace armtune {

std::string cell(double value) {
  return std::isnan(value) ? std::string() : fmt::format("{}", value);
}

}  // namespace armtune
